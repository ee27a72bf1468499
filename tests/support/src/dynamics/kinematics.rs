//! What positions, velocities, accelerations and their partials have to do with one another.

use kane_codegen::{id::BodyId, tree::Coordinate};

use super::{
    model::Model,
    quantities::{in_inertial, lower_in_inertial, matrices, rows, vectors, worst},
    rates::q_dot,
    state::{State, quaternions},
};
use crate::{
    compare::{larger, largest, relative, relative_to},
    numeric::{derivative, dot},
    rotation::{IDENTITY, cross, product, scaled, sum, times, transposed},
};

/// `dR/dt = -tilde(w) R`, `dr/dt = v` of origins and mass centres, in inertial components.
pub fn velocities_are_rates_of_positions(model: &dyn Model, state: &State) -> f64 {
    let position = |function: &'static str| {
        move |t: f64| {
            let state = state.moved(model.tree(), t);
            in_inertial(model, &state, &vectors(model, function, &state))
        }
    };
    let rate = |position: &dyn Fn(f64) -> Vec<f64>, found: &[f64]| {
        let expected = derivative(position);
        relative_to(
            larger(largest(&expected), largest(&position(0.0))),
            found,
            &expected,
        )
    };
    let origin = lower_in_inertial(model, state, &vectors(model, "origin_velocity", state));
    let center = in_inertial(model, state, &vectors(model, "mass_center_velocity", state));
    let rotations = matrices(model, "rotation", state);
    let omegas = vectors(model, "angular_velocity", state);
    let turning: Vec<f64> = rotations
        .iter()
        .zip(&omegas)
        .flat_map(|(rotation, w)| {
            let columns = transposed(rotation).map(|column| scaled(-1.0, cross(*w, column)));
            transposed(&columns).into_iter().flatten()
        })
        .collect();
    worst([
        rate(&position("origin_position"), &origin),
        rate(&position("mass_center_position"), &center),
        rate(
            &|t| model.evaluate("rotation", &state.moved(model.tree(), t)),
            &turning,
        ),
    ])
}

/// `dv/dt = a` of mass centres, `dw/dt = alpha`, in inertial components.
pub fn accelerations_are_rates_of_velocities(model: &dyn Model, state: &State) -> f64 {
    worst(
        [
            ("mass_center_velocity", "mass_center_acceleration"),
            ("angular_velocity", "angular_acceleration"),
        ]
        .map(|(velocity, acceleration)| {
            let velocity = |t: f64| {
                let state = state.moved(model.tree(), t);
                in_inertial(model, &state, &vectors(model, velocity, &state))
            };
            let found = in_inertial(model, state, &vectors(model, acceleration, state));
            let expected = derivative(velocity);
            relative_to(
                larger(largest(&expected), largest(&velocity(0.0))),
                &found,
                &expected,
            )
        }),
    )
}

/// `v = V u`, and `V_dot` is the rate of `V`'s components.
pub fn partial_velocities_make_velocities(model: &dyn Model, state: &State) -> f64 {
    let pairs = [
        (
            "angular_velocity",
            "partial_angular_velocity",
            "partial_angular_velocity_dot",
        ),
        (
            "origin_velocity",
            "partial_velocity_origin",
            "partial_velocity_origin_dot",
        ),
        (
            "mass_center_velocity",
            "partial_velocity",
            "partial_velocity_dot",
        ),
    ];
    worst(
        pairs
            .into_iter()
            .flat_map(|(velocity, partial, partial_dot)| {
                let made: Vec<f64> = rows(model, partial, state)
                    .iter()
                    .map(|row| dot(row, &state.u))
                    .collect();
                let partials = |t: f64| model.evaluate(partial, &state.moved(model.tree(), t));
                let expected = derivative(partials);
                let scale = larger(largest(&expected), largest(&partials(0.0)));
                [
                    relative(&model.evaluate(velocity, state), &made),
                    relative_to(scale, &model.evaluate(partial_dot, state), &expected),
                ]
            }),
    )
}

/// Rotations are orthonormal and right-handed, and `R_K = JR_K R_J`.
pub fn rotations_are_rotations(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let absolute = matrices(model, "rotation", state);
    let relative_ones = matrices(model, "relative_rotation", state);
    worst(tree.body_ids().flat_map(|body| {
        let (r, step) = (&absolute[body.index()], &relative_ones[body.index()]);
        let chained = tree.lower(body).map_or(*step, |lower| {
            let below = transposed(&absolute[lower.index()]);
            transposed(&below.map(|column| times(step, column)))
        });
        let third = cross(r[0], r[1]);
        let unit = r.map(|row| dot(&row, &row));
        [
            relative(chained.as_flattened(), r.as_flattened()),
            relative(&third, &r[2]),
            relative(&unit, &[1.0; 3]),
            dot(&r[0], &r[1]).abs(),
        ]
    }))
}

/// `angle_rates` gives back the rates of three free angles from the relative angular velocity; zero for other bodies.
/// Relative to the nearness of the singularity, by which the inverse divides.
pub fn angle_rates_undo_relative_angular_velocity(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let given = State {
        w_rel: vectors(model, "relative_angular_velocity", state),
        ..state.clone()
    };
    let q_dot = model.evaluate("q_dot", state);
    let mut least: f64 = 1.0;
    let mut expected = Vec::new();
    for body in &tree.bodies {
        let rate = |angle: Coordinate| match angle {
            Coordinate::Free { coordinate, .. } => Some(q_dot[coordinate.index()]),
            Coordinate::Mimic { .. } | Coordinate::Locked(_) => None,
        };
        let rates = body.joint.angles().map(|angles| angles.map(rate));
        expected.extend(match rates {
            Some([Some(first), Some(second), Some(third)]) => [first, second, third],
            _ => [0.0; 3],
        });
    }
    for distance in model.evaluate("singularity", state) {
        least = -larger(-least, -distance);
    }
    least * relative_to(1.0, &model.evaluate("angle_rates", &given), &expected)
}

/// `singularity = |cos(theta_2)|` between free `theta_1` and `theta_3`, one elsewhere.
pub fn singularity_is_the_cosine_of_the_second_angle(model: &dyn Model, state: &State) -> f64 {
    let expected: Vec<f64> = model
        .tree()
        .bodies
        .iter()
        .map(|body| match body.joint.angles() {
            Some([Coordinate::Free { .. }, second, Coordinate::Free { .. }]) => {
                let angle = match second {
                    Coordinate::Free { coordinate, .. } => state.q[coordinate.index()],
                    Coordinate::Locked(at) => at,
                    Coordinate::Mimic { .. } => unreachable!("it has two other coordinates"),
                };
                libm::cos(angle).abs()
            }
            _ => 1.0,
        })
        .collect();
    relative(&model.evaluate("singularity", state), &expected)
}

/// `q_dot = u`, or what the relative angular velocity makes of angles and quaternions; and no quaternion leaves its sphere.
pub fn rates_of_coordinates_follow_from_the_speeds(model: &dyn Model, state: &State) -> f64 {
    let expected = q_dot(model.tree(), &state.q, &state.u);
    let found = model.evaluate("q_dot", state);
    let growth = quaternions(model.tree()).map(|places| {
        let terms = places.map(|place| state.q[place] * found[place]);
        terms.iter().sum::<f64>()
    });
    worst([relative(&found, &expected)].into_iter().chain(growth))
}

/// `normalize` brings a quaternion that is off by 1e-5 back to length one, in its direction, and keeps the rest.
pub fn normalized_quaternions_have_length_one(model: &dyn Model, state: &State) -> f64 {
    let mut off = state.clone();
    for places in quaternions(model.tree()) {
        for place in places {
            off.q[place] *= 1.0 + 1e-5;
        }
    }
    relative(&model.evaluate("normalize", &off), &state.q)
}

/// Rotations, origins and mass centres are those of the description's frames: each joint between its two constant ones,
/// whatever the generator's own axes, what is fixed merged into what it is fixed to.
pub fn positions_are_those_of_the_description(model: &dyn Model, state: &State) -> f64 {
    let (tree, composition) = (model.tree(), model.composition());
    let placed = composition.placed(&state.q);
    let of_body = |body: BodyId| placed[tree.body(body).user_number - 1];
    let (mut relative_rotations, mut rotations) = (Vec::new(), Vec::new());
    let (mut origins, mut centers) = (Vec::new(), Vec::new());
    for (body, solid) in tree.body_ids().zip(composition.solids()) {
        let own = of_body(body);
        let below = tree
            .lower(body)
            .map_or(IDENTITY, |lower| of_body(lower).rotation);
        let step = product(&own.rotation, &transposed(&below));
        relative_rotations.extend(step.into_iter().flatten());
        rotations.extend(own.rotation.into_iter().flatten());
        let origin = times(&own.rotation, own.origin);
        origins.extend(origin);
        centers.extend(sum(origin, solid.center));
    }
    let named = model
        .tree()
        .frames
        .iter()
        .map(|frame| composition.frame_error(frame, &placed));
    let of = |function| model.evaluate(function, state);
    worst(
        [
            relative(&of("relative_rotation"), &relative_rotations),
            relative(&of("rotation"), &rotations),
            relative(&of("origin_position"), &origins),
            relative(&of("mass_center_position"), &centers),
        ]
        .into_iter()
        .chain(named),
    )
}
