//! The identities, each the relative error by which a model breaks it in a state.
//!
//! None of them knows how a function is derived: they are mechanics, differentiated by finite differences.

use kane_codegen::{
    functions::{CATALOGUE, Function},
    tree::{Orientation, Tree},
};

pub(crate) use super::random::rotation::{Vector, cross, scaled, times, transposed};
use super::{
    Model, State, floats, has_mimics,
    numeric::{Cholesky, Matrix, derivative, dot, largest, relative, relative_to},
    random::rotation::sum,
    renumbered_output, root_speeds,
};

/// Identities of sums and products alone: some hundred to some thousand roundings, of which the chains that feed one number
/// are some hundred long.
pub(crate) const EXACT: f64 = 2e-14;
/// Identities with a derivative by finite differences: 2e-14 of each evaluation's relative error in units of rounding
/// (see [`derivative`](super::numeric::derivative)), which is some ten to a hundred where terms cancel.
pub(crate) const DIFFERENTIATED: f64 = 1e-12;

pub(crate) fn vectors(model: &dyn Model, function: &str, state: &State) -> Vec<Vector> {
    let numbers = model.evaluate(function, state);
    numbers
        .chunks_exact(3)
        .map(|vector| [vector[0], vector[1], vector[2]])
        .collect()
}

pub(crate) fn matrices(model: &dyn Model, function: &str, state: &State) -> Vec<[Vector; 3]> {
    let rows = vectors(model, function, state);
    rows.chunks_exact(3)
        .map(|rows| [rows[0], rows[1], rows[2]])
        .collect()
}

/// One row of `NU` numbers for each body and component.
pub(crate) fn rows(model: &dyn Model, function: &str, state: &State) -> Vec<Vec<f64>> {
    let numbers = model.evaluate(function, state);
    numbers
        .chunks_exact(model.tree().n_speeds)
        .map(<[f64]>::to_vec)
        .collect()
}

pub(crate) fn mass_matrix(model: &dyn Model, state: &State) -> Matrix {
    Matrix::new(model.tree().n_speeds, model.evaluate("mass_matrix", state))
}

fn gravity(tree: &Tree) -> Vector {
    tree.gravity.map(|value| tree.nominal(value))
}

/// `f` of every body, in inertial components: `f` gives body components.
pub(crate) fn in_inertial(model: &dyn Model, state: &State, vectors: &[Vector]) -> Vec<f64> {
    let rotations = matrices(model, "rotation", state);
    let turn = |(rotation, vector): (&[Vector; 3], &Vector)| times(&transposed(rotation), *vector);
    rotations.iter().zip(vectors).flat_map(turn).collect()
}

/// As [`in_inertial`], of vectors in the components of the lower body.
pub(crate) fn lower_in_inertial(model: &dyn Model, state: &State, vectors: &[Vector]) -> Vec<f64> {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    tree.body_ids()
        .zip(vectors)
        .flat_map(|(body, vector)| {
            tree.lower(body).map_or(*vector, |lower| {
                times(&transposed(&rotations[lower.index()]), *vector)
            })
        })
        .collect()
}

/// The largest relative error of several.
pub(crate) fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    largest(&errors.into_iter().collect::<Vec<_>>())
}

/// `M = M^T`.
pub(crate) fn mass_matrix_is_symmetric(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let mirrored: Vec<f64> = (0..m.n * m.n)
        .map(|place| m.at(place % m.n, place / m.n))
        .collect();
    relative(&mirrored, &m.entries)
}

/// The packed entries are those of `M`, and what has no place among them is zero.
pub(crate) fn packed_mass_matrix_is_the_lower_triangle(model: &dyn Model, state: &State) -> f64 {
    let mut m = mass_matrix(model, state);
    let packed = model.evaluate("mass_matrix_packed", state);
    let places = model.tree().coupled_speeds();
    assert_eq!(packed.len(), places.len());
    let expected: Vec<f64> = places
        .iter()
        .map(|&[row, column]| m.at(row, column))
        .collect();
    for [row, column] in places {
        m.entries[row * m.n + column] = 0.0;
        m.entries[column * m.n + row] = 0.0;
    }
    assert!(
        m.entries.iter().all(|entry| *entry == 0.0),
        "{}",
        model.tree().name
    );
    relative(&packed, &expected)
}

/// `M = L L^T`, and the determinant is the product of the pivots, all positive; relative to the condition number, with
/// which rounding of `M` moves its determinant.
pub(crate) fn mass_matrix_is_positive_definite(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let Some(cholesky) = m.cholesky() else {
        return f64::INFINITY;
    };
    let pivots = model.evaluate("forward_dynamics_pivots", state);
    let logarithm: f64 = pivots.iter().map(|pivot| pivot.ln()).sum();
    let error = (logarithm - Cholesky::log_determinant(&cholesky)).abs();
    error / super::numeric::condition(&m)
}

/// `M u_dot + bias = inverse_dynamics(u_dot)`.
pub(crate) fn inverse_dynamics_is_linear(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let bias = model.evaluate("bias", state);
    let tau: Vec<f64> = m
        .times(&state.u_dot)
        .iter()
        .zip(&bias)
        .map(|(a, b)| a + b)
        .collect();
    relative_to(
        m.norm().max(largest(&bias)),
        &model.evaluate("inverse_dynamics", state),
        &tau,
    )
}

/// `forward_dynamics(inverse_dynamics(u_dot)) = u_dot`: what is left, times the mass matrix, is of the size of rounding of
/// the forces, however ill-conditioned the matrix (the factorisation is backward stable); relative to them.
pub(crate) fn forward_dynamics_undoes_inverse_dynamics(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let tau = model.evaluate("inverse_dynamics", state);
    let given = State {
        tau: tau.clone(),
        ..state.clone()
    };
    let u_dot = model.evaluate("forward_dynamics", &given);
    let left: Vec<f64> = u_dot.iter().zip(&state.u_dot).map(|(a, b)| a - b).collect();
    let bias = largest(&model.evaluate("bias", state));
    largest(&m.times(&left)) / (m.norm() + bias)
}

/// `forcing = generalized_forces - bias`.
pub(crate) fn forcing_is_loads_less_bias(model: &dyn Model, state: &State) -> f64 {
    let loads = model.evaluate("generalized_forces", state);
    let bias = model.evaluate("bias", state);
    let expected: Vec<f64> = loads.iter().zip(&bias).map(|(a, b)| a - b).collect();
    relative_to(
        largest(&loads).max(largest(&bias)),
        &model.evaluate("forcing", state),
        &expected,
    )
}

/// `gravity_forces = -sum_K V_G_K^T m_K g`.
pub(crate) fn gravity_forces_hold_the_weight(model: &dyn Model, state: &State) -> f64 {
    let rotations = matrices(model, "rotation", state);
    let solids = model.composition().solids();
    let supports: Vec<[f64; 6]> = solids
        .iter()
        .zip(&rotations)
        .map(|(solid, turn)| {
            let [x, y, z] = scaled(-solid.mass, times(turn, gravity(model.tree())));
            [x, y, z, 0.0, 0.0, 0.0]
        })
        .collect();
    let (expected, most) = projected(model, state, &supports);
    relative_to(most, &model.evaluate("gravity_forces", state), &expected)
}

/// `sum_K V_G_K^T F_K + W_K^T M_K`, and the largest term of it.
fn projected(model: &dyn Model, state: &State, loads: &[[f64; 6]]) -> (Vec<f64>, f64) {
    let velocity = rows(model, "partial_velocity", state);
    let angular = rows(model, "partial_angular_velocity", state);
    let (mut tau, mut most) = (vec![0.0; model.tree().n_speeds], 0.0_f64);
    for (body, load) in loads.iter().enumerate() {
        for axis in 0..3 {
            let row = 3 * body + axis;
            for (tau, (v, w)) in tau.iter_mut().zip(velocity[row].iter().zip(&angular[row])) {
                *tau += v * load[axis] + w * load[axis + 3];
                most = most
                    .max((v * load[axis]).abs())
                    .max((w * load[axis + 3]).abs());
            }
        }
    }
    (tau, most)
}

/// `generalized_forces = sum_K V_G_K^T F_K + W_K^T M_K`.
pub(crate) fn generalized_forces_are_projected_loads(model: &dyn Model, state: &State) -> f64 {
    let (expected, most) = projected(model, state, &state.loads);
    relative_to(
        most,
        &model.evaluate("generalized_forces", state),
        &expected,
    )
}

/// Newton and Euler, projected, and what acts in joints:
/// `inverse_dynamics = sum_K V_G_K^T m (a_K - g) + W_K^T (I alpha_K + w_K x I w_K)` and rotors, dampers and springs.
pub(crate) fn inverse_dynamics_is_newton_euler(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let accelerations = vectors(model, "mass_center_acceleration", state);
    let alphas = vectors(model, "angular_acceleration", state);
    let omegas = vectors(model, "angular_velocity", state);
    let solids = model.composition().solids();
    let needed: Vec<[f64; 6]> = solids
        .iter()
        .enumerate()
        .map(|(k, solid)| {
            let weight = times(&rotations[k], gravity(tree));
            let felt = sum(accelerations[k], scaled(-1.0, weight));
            let force = scaled(solid.mass, felt);
            let i = &solid.inertia;
            let moment = sum(times(i, alphas[k]), cross(omegas[k], times(i, omegas[k])));
            [
                force[0], force[1], force[2], moment[0], moment[1], moment[2],
            ]
        })
        .collect();
    let (mut expected, mut most) = projected(model, state, &needed);
    for acting in model.composition().acting() {
        let (speed, forces) = acting.needed(state);
        expected[speed] += forces.iter().sum::<f64>();
        most = most.max(largest(&forces));
    }
    relative_to(most, &model.evaluate("inverse_dynamics", state), &expected)
}

/// What dampers need at every speed.
fn damping(model: &dyn Model, state: &State) -> Vec<f64> {
    let mut damping = vec![0.0; state.u.len()];
    for acting in model.composition().acting() {
        let (speed, [_, damper, _]) = acting.needed(state);
        damping[speed] += damper;
    }
    damping
}

/// `d(T + V)/dt = tau u + sum_K F_K v_K + M_K w_K`, less what dampers take, along a motion that the forces and loads make.
pub(crate) fn power_is_the_rate_of_energy(model: &dyn Model, state: &State) -> f64 {
    let energy = |t: f64| {
        let state = state.moved(model.tree(), t);
        let mut energy = model.evaluate("kinetic_energy", &state);
        energy.extend(model.evaluate("potential_energy", &state));
        energy
    };
    let rates = derivative(energy);
    // What is left of the forces after the loads have done their part.
    let loads = model.evaluate("generalized_forces", state);
    let needed = model.evaluate("inverse_dynamics", state);
    let tau: Vec<f64> = needed
        .iter()
        .zip(&loads)
        .map(|(needed, load)| needed - load)
        .collect();
    let velocities = vectors(model, "mass_center_velocity", state);
    let omegas = vectors(model, "angular_velocity", state);
    let by_loads: Vec<f64> = state
        .loads
        .iter()
        .zip(velocities.iter().zip(&omegas))
        .map(|(load, (v, w))| dot(&load[..3], v) + dot(&load[3..], w))
        .collect();
    let by_tau: Vec<f64> = tau.iter().zip(&state.u).map(|(tau, u)| tau * u).collect();
    let taken = dot(&damping(model, state), &state.u);
    let power = by_tau.iter().sum::<f64>() + by_loads.iter().sum::<f64>() - taken;
    let scale = worst([
        largest(&by_loads),
        largest(&by_tau),
        taken,
        largest(&energy(0.0)),
    ]);
    relative_to(scale, &[rates[0] + rates[1]], &[power])
}

/// Lagrange, speeds held: `bias = d(M u)/dt - dT/dq + dV/dq` and dampers; for the components of an angular velocity, whose
/// coordinates move as these do one by one, also `w x dT/dw` (Hamel).
pub(crate) fn bias_follows_from_the_energies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let steady = State {
        u_dot: vec![0.0; state.u.len()],
        ..state.clone()
    };
    let momenta = |t: f64| mass_matrix(model, &steady.moved(tree, t)).times(&state.u);
    let energies = |state: &State| {
        [
            model.evaluate("kinetic_energy", state)[0],
            model.evaluate("potential_energy", state)[0],
        ]
    };
    let gradient = |speed| derivative(|t| energies(&state.displaced(tree, speed, t)).to_vec());
    let mut expected = derivative(momenta);
    for (speed, expected) in expected.iter_mut().enumerate() {
        let [kinetic, potential] = gradient(speed)[..] else {
            unreachable!("two energies")
        };
        *expected += potential - kinetic;
    }
    for (expected, damping) in expected.iter_mut().zip(damping(model, state)) {
        *expected += damping;
    }
    let p = momenta(0.0);
    for body in &tree.bodies {
        if let Orientation::AngularVelocity { speeds, .. } = body.joint.orientation {
            let of = |numbers: &[f64]| speeds.map(|speed| numbers[speed.index()]);
            let turning = cross(of(&state.u), of(&p));
            for (speed, turning) in speeds.into_iter().zip(turning) {
                expected[speed.index()] += turning;
            }
        }
    }
    let bias = model.evaluate("bias", state);
    let scale = worst([largest(&bias), largest(&p), largest(&energies(state))]);
    relative_to(scale, &bias, &expected)
}

/// `bias = dV/dq` at rest.
pub(crate) fn bias_at_rest_is_the_gradient_of_potential_energy(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let rest = State {
        u: vec![0.0; state.u.len()],
        ..state.clone()
    };
    let energy = |state: &State| model.evaluate("potential_energy", state);
    let gradient: Vec<f64> = (0..state.u.len())
        .flat_map(|speed| derivative(|t| energy(&rest.displaced(model.tree(), speed, t))))
        .collect();
    relative_to(
        largest(&gradient).max(energy(&rest)[0].abs()),
        &model.evaluate("bias", &rest),
        &gradient,
    )
}

/// `T = u M u / 2 = sum_K (m v_K v_K + w_K I w_K) / 2` and rotors, `p = sum_K m v_K`, `h = sum_K r_K x m v_K + I w_K` and
/// `V = -sum_K m g r_K` and springs, in inertial components.
pub(crate) fn energies_and_momenta_are_sums_over_bodies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let positions = vectors(model, "mass_center_position", state);
    let velocities = vectors(model, "mass_center_velocity", state);
    let omegas = vectors(model, "angular_velocity", state);
    let (mut kinetic, mut potential) = (0.0, 0.0);
    let (mut linear, mut angular) = ([0.0; 3], [0.0; 3]);
    let mut most = [0.0_f64; 3];
    for (k, solid) in model.composition().solids().iter().enumerate() {
        let (m, turn) = (solid.mass, transposed(&rotations[k]));
        let h = times(&solid.inertia, omegas[k]);
        let (p, r) = (
            scaled(m, times(&turn, velocities[k])),
            times(&turn, positions[k]),
        );
        kinetic += 0.5 * (m * dot(&velocities[k], &velocities[k]) + dot(&h, &omegas[k]));
        potential -= m * dot(&gravity(tree), &r);
        linear = sum(linear, p);
        angular = sum(angular, sum(cross(r, p), times(&turn, h)));
        most[0] = most[0].max(m * largest(&gravity(tree)) * largest(&r));
        most[1] = most[1].max(largest(&p));
        most[2] = most[2].max(largest(&p) * largest(&r)).max(largest(&h));
    }
    for acting in model.composition().acting() {
        let [rotor, spring] = acting.energies(state);
        kinetic += rotor;
        potential += spring;
        most[0] = most[0].max(spring.abs());
    }
    let quadratic = 0.5 * dot(&state.u, &mass_matrix(model, state).times(&state.u));
    let of = |function| model.evaluate(function, state);
    worst([
        relative(&of("kinetic_energy"), &[kinetic]),
        relative(&of("kinetic_energy"), &[quadratic]),
        relative_to(most[0], &of("potential_energy"), &[potential]),
        relative_to(most[1], &of("linear_momentum"), &linear),
        relative_to(most[2], &of("angular_momentum"), &angular),
    ])
}

/// Where nothing holds the tree: the rates of linear and angular momentum are the resultant of weight and loads, whatever
/// the joints do, springs, dampers, rotors and what follows what with them; where there is neither, both are conserved.
/// Along the motion that forward dynamics gives.
pub(crate) fn momenta_of_a_floating_tree_change_by_external_loads(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let tree = model.tree();
    if !floats(model.composition()) {
        return 0.0;
    }
    worst([true, false].map(|loaded| {
        let mut state = state.clone();
        if !loaded {
            state.loads.fill([0.0; 6]);
        }
        // The joints' forces: all but those between a root and the inertial frame, which undo springs and dampers there.
        for speed in root_speeds(tree) {
            state.tau[speed] = 0.0;
        }
        for acting in model.composition().acting() {
            let (speed, [_, damper, spring]) = acting.needed(&state);
            if root_speeds(tree).any(|root| root == speed) {
                state.tau[speed] += damper + spring;
            }
        }
        let loads = model.evaluate("generalized_forces", &state);
        state
            .tau
            .iter_mut()
            .zip(&loads)
            .for_each(|(tau, load)| *tau += load);
        state.u_dot = model.evaluate("forward_dynamics", &state);
        momentum_error(model, &state)
    }))
}

fn momentum_error(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let positions = vectors(model, "mass_center_position", state);
    let accelerations = vectors(model, "mass_center_acceleration", state);
    let alphas = vectors(model, "angular_acceleration", state);
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    let mut most = [0.0_f64; 2];
    for (k, solid) in model.composition().solids().iter().enumerate() {
        let (turn, m) = (transposed(&rotations[k]), solid.mass);
        let load = state.loads[k];
        let f = sum(
            times(&turn, [load[0], load[1], load[2]]),
            scaled(m, gravity(tree)),
        );
        let r = times(&turn, positions[k]);
        force = sum(force, f);
        moment = sum(
            moment,
            sum(cross(r, f), times(&turn, [load[3], load[4], load[5]])),
        );
        let inertial = m * largest(&accelerations[k]) + largest(&f);
        most[0] = most[0].max(inertial);
        most[1] = most[1]
            .max(inertial * largest(&r))
            .max(largest(&times(&solid.inertia, alphas[k])));
    }
    let momenta = |function: &str| {
        let momentum = |t: f64| model.evaluate(function, &state.moved(tree, t));
        (derivative(momentum), largest(&momentum(0.0)))
    };
    let (linear, p) = momenta("linear_momentum");
    let (angular, h) = momenta("angular_momentum");
    worst([
        relative_to(most[0].max(p), &linear, &force),
        relative_to(most[1].max(h), &angular, &moment),
    ])
}

/// The largest difference of pivots, each relative to itself and to the condition number: a pivot is the reciprocal of a
/// diagonal entry of a leading block's inverse, which rounding of the block moves by its condition.
pub(crate) fn pivot_error(m: &Matrix, found: &[f64], expected: &[f64]) -> f64 {
    let error = |(found, expected): (&f64, &f64)| (found - expected) / expected;
    worst(found.iter().zip(expected).map(error)) / super::numeric::condition(m)
}

/// The largest relative difference of two models of one system, over all functions that `both` have; with its function.
///
/// Forward dynamics is compared through the mass matrix (see [`forward_dynamics_undoes_inverse_dynamics`]), bias and inverse
/// dynamics relative to the mass matrix as well, for theirs are sums of terms of its size, and the forces of loads relative to
/// the loads' largest moment arm, which is that of the partial velocities.
pub(crate) fn disagreement(
    a: &dyn Model,
    b: &dyn Model,
    both: impl Fn(&Function) -> bool,
    state: &State,
) -> (f64, &'static str) {
    let other = state.renumbered(a.tree(), b.tree());
    let m = mass_matrix(a, state);
    let mut most = (0.0, "no function");
    for function in CATALOGUE.iter().filter(|function| both(function)) {
        let expected = a.evaluate(function.name, state);
        let found = b.evaluate(function.name, &other);
        let found = renumbered_output(function, &found, b.tree(), a.tree());
        let error = match function.name {
            "forward_dynamics" => {
                let left: Vec<f64> = expected.iter().zip(&found).map(|(a, b)| a - b).collect();
                largest(&m.times(&left)) / (m.norm() * largest(&expected).max(1.0))
            }
            // Joints that follow one another couple branches, whose order is then that of elimination: only the product of
            // all pivots does not depend on it.
            "forward_dynamics_pivots" if has_mimics(a.tree()) => {
                let logarithm = |pivots: &[f64]| pivots.iter().map(|pivot| pivot.ln()).sum::<f64>();
                (logarithm(&found) - logarithm(&expected)).abs() / super::numeric::condition(&m)
            }
            "forward_dynamics_pivots" => pivot_error(&m, &found, &expected),
            // Sums of terms of the mass matrix's size.
            "bias" | "gravity_forces" | "inverse_dynamics" | "forcing" | "linear_momentum"
            | "angular_momentum" | "potential_energy" => {
                relative_to(largest(&expected).max(m.norm()), &found, &expected)
            }
            _ => relative(&found, &expected),
        };
        if error > most.0 || error.is_nan() {
            most = (error, function.name);
        }
    }
    most
}
