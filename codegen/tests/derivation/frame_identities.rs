//! What Jacobians, accelerations and forces of frames have to do with one another, with poses and with velocities.

use kane_codegen::{
    functions::{Formulation, Function, Request},
    tree::Tree,
};
use kane_test_support::{
    compare::assert_within,
    dynamics::{
        State,
        state::{FRAME_FORCE, FRAME_MOMENT, FRAME_POINT},
    },
};

use crate::frames::{
    DIFFERENCED, EXACT, INVERTED, evaluate, names, of_states, product, rate, relative, request,
    seeds, system, transposed,
};

/// What a function of a frame writes, by the notes' equations.
fn value(tree: &Tree, state: &State, text: &str) -> Vec<f64> {
    evaluate(tree, &request(tree, text), Formulation::Notes, state)
}

/// The same in any state, derived once.
fn by_notes<'a>(tree: &'a Tree, text: &str) -> impl Fn(&State) -> Vec<f64> + use<'a> {
    of_states(tree, &request(tree, text), Formulation::Notes)
}

/// Six rows times speeds.
fn times(rows: &[f64], u: &[f64]) -> Vec<f64> {
    let row = |row: &[f64]| row.iter().zip(u).map(|(a, b)| a * b).sum();
    rows.chunks(u.len().max(1)).map(row).collect()
}

fn sum(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

fn each_frame(check: impl Fn(&str, &Tree, &State, &str)) {
    for seed in seeds() {
        let (_, tree) = system(seed);
        if tree.n_speeds == 0 {
            continue;
        }
        let state = State::random(&tree, seed);
        for name in names(&tree) {
            check(&format!("{seed}, {name}"), &tree, &state, &name);
        }
    }
}

#[test]
fn jacobians_times_speeds_are_velocities() {
    each_frame(|what, tree, state, name| {
        for own in ["", ", local"] {
            let jacobian = value(tree, state, &format!("jacobian({name}{own})"));
            let velocity = value(tree, state, &format!("velocity({name}{own})"));
            let error = relative(&times(&jacobian, &state.u), &velocity);
            assert_within(format!("{what}{own}"), error, EXACT);
        }
    });
}

#[test]
fn jacobians_times_accelerations_and_their_rates_times_speeds_are_accelerations() {
    each_frame(|what, tree, state, name| {
        for own in ["", ", local"] {
            let jacobian = value(tree, state, &format!("jacobian({name}{own})"));
            let drift = value(tree, state, &format!("jacobian_dot_u({name}{own})"));
            let acceleration = value(tree, state, &format!("acceleration({name}{own})"));
            let expected = sum(&times(&jacobian, &state.u_dot), &drift);
            let error = relative(&acceleration, &expected);
            assert_within(format!("{what}{own}"), error, EXACT);
        }
    });
}

#[test]
fn accelerations_are_rates_of_velocities() {
    each_frame(|what, tree, state, name| {
        let text = format!("velocity({name})");
        let velocity = by_notes(tree, &text);
        let expected = rate(|t| velocity(&state.moved(tree, t)));
        let acceleration = value(tree, state, &format!("acceleration({name})"));
        let error = relative(&acceleration, &expected);
        assert_within(what, error, DIFFERENCED);

        let pose = value(tree, state, &format!("pose({name})"));
        let turned: Vec<f64> = acceleration
            .chunks(3)
            .flat_map(|v| product(&pose[..9], v))
            .collect();
        let local = value(tree, state, &format!("acceleration({name}, local)"));
        assert_within(format!("{what}, local"), relative(&local, &turned), EXACT);
    });
}

#[test]
fn poses_seen_from_a_frame_are_those_of_both() {
    each_frame(|what, tree, state, name| {
        let own = value(tree, state, &format!("pose({name})"));
        for other in names(tree) {
            let view = value(tree, state, &format!("pose({other})"));
            let apart: Vec<f64> = own[9..]
                .iter()
                .zip(&view[9..])
                .map(|(a, b)| a - b)
                .collect();
            let rows = own[..9].chunks(3);
            let rotation = rows.flat_map(|row| product(&view[..9], row));
            let expected: Vec<f64> = rotation.chain(product(&view[..9], &apart)).collect();
            let found = value(tree, state, &format!("pose({name}, {other})"));
            let error = relative(&found, &expected);
            assert_within(format!("{what}, {other}"), error, EXACT);
        }
    });
}

#[test]
fn jacobians_seen_from_a_frame_times_speeds_are_rates_of_poses_seen_from_it() {
    each_frame(|what, tree, state, name| {
        let at_rest = State {
            u_dot: vec![0.0; tree.n_speeds],
            ..state.clone()
        };
        let names = names(tree);
        for other in names.iter().step_by(3) {
            // A rotation that is set at run time is used as given, and here is one.
            let text = format!("pose({name}, {other})");
            let pose = by_notes(tree, &text);
            let pose = |t: f64| pose(&at_rest.moved(tree, t));
            let (now, rate) = (pose(0.0), rate(pose));
            let entry = |i: usize, j: usize| {
                (0..3)
                    .map(|k| rate[3 * k + i] * now[3 * k + j])
                    .sum::<f64>()
            };
            let angular = [entry(2, 1), entry(0, 2), entry(1, 0)];
            let expected = [&rate[9..], &angular].concat();
            let jacobian = value(tree, state, &format!("jacobian({name}, {other})"));
            let error = relative(&times(&jacobian, &state.u), &expected);
            assert_within(format!("{what}, {other}"), error, DIFFERENCED);
        }
    });
}

#[test]
fn packed_jacobians_are_the_columns_that_are_not_zero() {
    each_frame(|what, tree, state, name| {
        for view in ["", ", local", ", stand"] {
            let whole = value(tree, state, &format!("jacobian({name}{view})"));
            let text = format!("jacobian_packed({name}{view})");
            let packed = value(tree, state, &text);
            let request = request(tree, &text);
            let subject = request.parts()[0].subject.as_ref();
            let speeds = subject.expect("it is of a frame").speeds(tree);
            let mut found = vec![0.0; 6 * tree.n_speeds];
            for (place, number) in packed.iter().enumerate() {
                let (row, column) = (place / speeds.len(), place % speeds.len());
                found[row * tree.n_speeds + speeds[column].index()] = *number;
            }
            assert_eq!(found, whole, "{what}{view}");
        }
    });
}

#[test]
fn jacobians_of_points_are_those_of_the_frame_moved_there() {
    each_frame(|what, tree, state, name| {
        for own in ["", ", local"] {
            let frame = value(tree, state, &format!("jacobian({name}{own})"));
            let point = value(tree, state, &format!("point_jacobian({name}{own})"));
            let pose = value(tree, state, &format!("pose({name})"));
            let lever = match own {
                "" => product(&transposed(&pose[..9]), &FRAME_POINT),
                _ => FRAME_POINT.to_vec(),
            };
            let n = tree.n_speeds;
            let mut expected = frame.clone();
            for speed in 0..n {
                let w = |axis: usize| frame[(3 + axis) * n + speed];
                for axis in 0..3 {
                    let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
                    expected[axis * n + speed] += w(b) * lever[c] - w(c) * lever[b];
                }
            }
            assert_within(format!("{what}{own}"), relative(&point, &expected), EXACT);
        }
    });
}

#[test]
fn forces_of_wrenches_have_their_power() {
    each_frame(|what, tree, state, name| {
        for own in ["", ", local"] {
            let jacobian = value(tree, state, &format!("jacobian({name}{own})"));
            let tau = value(tree, state, &format!("generalized_force({name}{own})"));
            let wrench = [FRAME_FORCE, FRAME_MOMENT].concat();
            let n = tree.n_speeds;
            let expected: Vec<f64> = (0..n)
                .map(|speed| {
                    (0..6)
                        .map(|row| jacobian[row * n + speed] * wrench[row])
                        .sum()
                })
                .collect();
            assert_within(format!("{what}{own}"), relative(&tau, &expected), EXACT);
        }
    });
}

#[test]
fn operational_inertias_are_the_inverse_mass_matrix_between_jacobians() {
    each_frame(|what, tree, state, name| {
        let n = tree.n_speeds;
        let inverse = Function::find("mass_matrix_inverse").expect("a function of the catalogue");
        let inverse = Request::from(inverse);
        let inverse = evaluate(tree, &inverse, Formulation::Notes, state);
        for (others, own) in [
            ("", ""),
            (", \"stand\", \"marker one\"", ""),
            ("", ", local"),
        ] {
            // No frame may stand there twice.
            let others = others.split(", ").skip(1).filter(|other| *other != name);
            let frames: Vec<&str> = std::iter::once(name).chain(others).collect();
            let jacobians = frames.iter();
            let jacobians =
                jacobians.map(|name| value(tree, state, &format!("jacobian({name}{own})")));
            let rows: Vec<f64> = jacobians.flatten().collect();
            let entry = |a: &[f64], b: &[f64]| -> f64 {
                let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
                pairs.map(|(i, j)| a[i] * inverse[i * n + j] * b[j]).sum()
            };
            let rows: Vec<&[f64]> = rows.chunks(n).collect();
            let all = rows.iter().flat_map(|a| rows.iter().map(move |b| (*a, *b)));
            let expected: Vec<f64> = all.map(|(a, b)| entry(a, b)).collect();
            let text = format!("operational_inverse_inertia({}{own})", frames.join(", "));
            let found = value(tree, state, &text);
            let error = relative(&found, &expected);
            assert_within(format!("{what}, {text}"), error, INVERTED);
        }
    });
}

#[test]
fn measurement_units_read_accelerations_less_gravity() {
    each_frame(|what, tree, state, name| {
        let pose = value(tree, state, &format!("pose({name})"));
        let gravity = tree.gravity.map(|component| tree.nominal(component));
        let gravity = product(&pose[..9], &gravity);
        let acceleration = value(tree, state, &format!("acceleration({name}, local)"));
        let velocity = value(tree, state, &format!("velocity({name}, local)"));
        let specific = acceleration.iter().zip(&gravity).map(|(a, g)| a - g);
        let expected: Vec<f64> = specific.chain(velocity[3..].iter().copied()).collect();
        let found = value(tree, state, &format!("imu({name})"));
        assert_within(what, relative(&found, &expected), EXACT);
    });
}
