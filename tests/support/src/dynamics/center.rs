//! Identities of the mass centre of all bodies, and of momentum about it.

use super::{
    model::Model,
    quantities::{in_inertial, rows, vectors, worst},
    state::State,
};
use crate::{
    compare::{larger, largest, relative, relative_to},
    numeric::derivative,
    rotation::{Vector, cross, scaled, sum},
};

/// A matrix of three rows times a vector.
fn product(matrix: &[Vec<f64>], u: &[f64]) -> Vec<f64> {
    let row = |row: &Vec<f64>| row.iter().zip(u).map(|(a, b)| a * b).sum();
    matrix.iter().map(row).collect()
}

fn total_mass(model: &dyn Model) -> f64 {
    let solids = model.composition().solids();
    solids.iter().map(|solid| solid.mass).sum()
}

/// The place of each body's mass centre, inertial components.
fn centers(model: &dyn Model, state: &State) -> Vec<Vector> {
    let positions = vectors(model, "mass_center_position", state);
    let positions = in_inertial(model, state, &positions);
    positions
        .chunks_exact(3)
        .map(|p| [p[0], p[1], p[2]])
        .collect()
}

/// `sum_K m_K r_K = m r`, `m v` and `m J u` are linear momentum; without mass all are zero.
pub fn the_mass_center_moves_as_all_mass_does(model: &dyn Model, state: &State) -> f64 {
    let mass = total_mass(model);
    let found = model.evaluate("center_of_mass", state);
    let velocity = model.evaluate("center_of_mass_velocity", state);
    let jacobian = rows(model, "center_of_mass_jacobian", state);
    if mass == 0.0 {
        let all = [found, velocity, jacobian.concat()].concat();
        return largest(&all);
    }
    let centers = centers(model, state);
    let solids = model.composition().solids();
    let weighted = solids.iter().zip(&centers);
    let expected = weighted.fold([0.0; 3], |all, (solid, center)| {
        sum(all, scaled(solid.mass / mass, *center))
    });
    let momentum = model.evaluate("linear_momentum", state);
    let momentum: Vec<f64> = momentum.iter().map(|p| p / mass).collect();
    let speed = larger(largest(&momentum), largest(&jacobian.concat()));
    worst([
        relative_to(largest(centers.as_flattened()), &found, &expected),
        relative_to(speed, &velocity, &momentum),
        relative_to(speed, &product(&jacobian, &state.u), &momentum),
    ])
}

/// `A_G u` is linear momentum, and angular momentum about the mass centre: that about the inertial origin less `r x p`.
pub fn the_centroidal_momentum_matrix_gives_momentum(model: &dyn Model, state: &State) -> f64 {
    let matrix = rows(model, "centroidal_momentum_matrix", state);
    let found = product(&matrix, &state.u);
    let [linear, angular] = ["linear_momentum", "angular_momentum"]
        .map(|function| model.evaluate(function, state))
        .map(|v| [v[0], v[1], v[2]]);
    let center = model.evaluate("center_of_mass", state);
    let moved = cross([center[0], center[1], center[2]], linear);
    let expected = sum(angular, scaled(-1.0, moved));
    let most = larger(largest(&matrix[..3].concat()), largest(&linear));
    let scale = larger(largest(&angular), largest(&moved));
    let scale = larger(scale, largest(&matrix[3..].concat()));
    worst([
        relative_to(most, &found[..3], &linear),
        relative_to(scale, &found[3..], &expected),
    ])
}

/// The Jacobian of the mass centre is the linear part over all mass.
pub fn the_mass_center_s_jacobian_is_linear_momentum_s(model: &dyn Model, state: &State) -> f64 {
    let mass = total_mass(model);
    let matrix = rows(model, "centroidal_momentum_matrix", state);
    let jacobian = model.evaluate("center_of_mass_jacobian", state);
    let expected: Vec<f64> = jacobian.iter().map(|entry| mass * entry).collect();
    relative(&matrix[..3].concat(), &expected)
}

/// `d(A_G u)/dt = A_G u_dot + A_G_dot u`.
pub fn centroidal_momentum_changes_as_its_matrix_says(model: &dyn Model, state: &State) -> f64 {
    let matrix = |state: &State| rows(model, "centroidal_momentum_matrix", state);
    let momentum = |t: f64| {
        let state = state.moved(model.tree(), t);
        product(&matrix(&state), &state.u)
    };
    let rates = derivative(momentum);
    let own = model.evaluate("center_of_mass_jacobian_dot_u", state);
    let drift = model.evaluate("centroidal_momentum_matrix_dot_u", state);
    let driven = product(&matrix(state), &state.u_dot);
    let expected: Vec<f64> = drift.iter().zip(&driven).map(|(a, b)| a + b).collect();
    let of = |part: std::ops::Range<usize>| {
        let all = [
            &momentum(0.0)[part.clone()],
            &matrix(state)[part.clone()].concat(),
        ]
        .concat();
        let scale = larger(largest(&all), largest(&drift[part.clone()]));
        relative_to(scale, &rates[part.clone()], &expected[part])
    };
    let mass = total_mass(model);
    let own: Vec<f64> = own.iter().map(|entry| mass * entry).collect();
    let of_center = relative_to(larger(largest(&drift[..3]), mass), &own, &drift[..3]);
    worst([of(0..3), of(3..6), of_center])
}
