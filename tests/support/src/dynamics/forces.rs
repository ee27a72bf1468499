//! Identities of forces: the mass matrix, and what is linear in it.
//!
//! None of them knows how a function is derived: they are mechanics.

use super::{
    model::Model,
    quantities::{gravity, mass_matrix, matrices, rows, vectors},
    state::State,
};
use crate::{
    compare::{larger, largest, relative, relative_to, size_of},
    numeric::{Cholesky, condition},
    rotation::{cross, scaled, sum, times},
};

/// `M = M^T`.
pub fn mass_matrix_is_symmetric(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let mirrored: Vec<f64> = (0..m.n * m.n)
        .map(|place| m.at(place % m.n, place / m.n))
        .collect();
    relative(&mirrored, &m.entries)
}

/// The packed entries are those of `M`, and what has no place among them is zero.
pub fn packed_mass_matrix_is_the_lower_triangle(model: &dyn Model, state: &State) -> f64 {
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
pub fn mass_matrix_is_positive_definite(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let Some(cholesky) = m.cholesky() else {
        return f64::INFINITY;
    };
    let pivots = model.evaluate("forward_dynamics_pivots", state);
    let logarithm: f64 = pivots.iter().map(|pivot| pivot.ln()).sum();
    let error = (logarithm - Cholesky::log_determinant(&cholesky)).abs();
    error / condition(&m)
}

/// `M u_dot + bias = inverse_dynamics(u_dot)`.
pub fn inverse_dynamics_is_linear(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let bias = model.evaluate("bias", state);
    let tau: Vec<f64> = m
        .times(&state.u_dot)
        .iter()
        .zip(&bias)
        .map(|(a, b)| a + b)
        .collect();
    relative_to(
        larger(m.norm(), largest(&bias)),
        &model.evaluate("inverse_dynamics", state),
        &tau,
    )
}

/// `forward_dynamics(inverse_dynamics(u_dot)) = u_dot`: what is left, times the mass matrix, is of the size of rounding of
/// the forces, however ill-conditioned the matrix (the factorisation is backward stable); relative to them.
pub fn forward_dynamics_undoes_inverse_dynamics(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let tau = model.evaluate("inverse_dynamics", state);
    let given = State {
        tau: tau.clone(),
        ..state.clone()
    };
    let u_dot = model.evaluate("forward_dynamics", &given);
    let left: Vec<f64> = u_dot.iter().zip(&state.u_dot).map(|(a, b)| a - b).collect();
    let bias = largest(&model.evaluate("bias", state));
    size_of(m.norm() + bias, &m.times(&left))
}

/// `forcing = generalized_forces - bias`.
pub fn forcing_is_loads_less_bias(model: &dyn Model, state: &State) -> f64 {
    let loads = model.evaluate("generalized_forces", state);
    let bias = model.evaluate("bias", state);
    let expected: Vec<f64> = loads.iter().zip(&bias).map(|(a, b)| a - b).collect();
    relative_to(
        larger(largest(&loads), largest(&bias)),
        &model.evaluate("forcing", state),
        &expected,
    )
}

/// `gravity_forces = -sum_K V_G_K^T m_K g`, less what lifts.
pub fn gravity_forces_hold_the_weight(model: &dyn Model, state: &State) -> f64 {
    let rotations = matrices(model, "rotation", state);
    let solids = model.composition().solids();
    let supports: Vec<[f64; 6]> = solids
        .iter()
        .zip(&rotations)
        .map(|(solid, turn)| {
            let weight = solid.weight(times(turn, gravity(model.tree())));
            let [[x, y, z], [a, b, c]] = weight.map(|part| scaled(-1.0, part));
            [x, y, z, a, b, c]
        })
        .collect();
    let (expected, most) = projected(model, state, &supports);
    relative_to(most, &model.evaluate("gravity_forces", state), &expected)
}

/// The generalized forces of what lifts bodies.
pub(super) fn lifting_forces(model: &dyn Model, state: &State) -> Vec<f64> {
    let rotations = matrices(model, "rotation", state);
    let solids = model.composition().solids().into_iter();
    let lifts = solids.zip(&rotations).map(|(solid, turn)| {
        let g = times(turn, gravity(model.tree()));
        let whole = scaled(solid.mass, g);
        let [left, [a, b, c]] = solid.weight(g);
        let [x, y, z] = sum(left, scaled(-1.0, whole));
        [x, y, z, a, b, c]
    });
    projected(model, state, &lifts.collect::<Vec<_>>()).0
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
                most = larger(most, largest(&[v * load[axis], w * load[axis + 3]]));
            }
        }
    }
    (tau, most)
}

/// `generalized_forces = sum_K V_G_K^T F_K + W_K^T M_K`.
pub fn generalized_forces_are_projected_loads(model: &dyn Model, state: &State) -> f64 {
    let (expected, most) = projected(model, state, &state.loads);
    relative_to(
        most,
        &model.evaluate("generalized_forces", state),
        &expected,
    )
}

/// Newton and Euler, projected, and what acts in joints:
/// `inverse_dynamics = sum_K V_G_K^T m (a_K - g) + W_K^T (I alpha_K + w_K x I w_K)`, less what lifts, and rotors, dampers and springs.
pub fn inverse_dynamics_is_newton_euler(model: &dyn Model, state: &State) -> f64 {
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
            let weight = solid.weight(times(&rotations[k], gravity(tree)));
            let [weight, around] = weight.map(|part| scaled(-1.0, part));
            let force = sum(scaled(solid.mass, accelerations[k]), weight);
            let i = &solid.inertia;
            let moment = sum(times(i, alphas[k]), cross(omegas[k], times(i, omegas[k])));
            let moment = sum(moment, around);
            [
                force[0], force[1], force[2], moment[0], moment[1], moment[2],
            ]
        })
        .collect();
    let (mut expected, mut most) = projected(model, state, &needed);
    for acting in model.composition().acting() {
        let (speed, forces) = acting.needed(state);
        expected[speed] += forces.iter().sum::<f64>();
        most = larger(most, largest(&forces));
    }
    relative_to(most, &model.evaluate("inverse_dynamics", state), &expected)
}
