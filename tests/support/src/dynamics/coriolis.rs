//! Identities of the Coriolis matrix and of the rate of the mass matrix.

use kane_codegen::tree::Orientation;

use super::{model::Model, quantities::mass_matrix, state::State};
use crate::{
    compare::{larger, largest, relative_to},
    numeric::{Matrix, derivative},
};

fn matrix(model: &dyn Model, function: &str, state: &State) -> Matrix {
    Matrix::new(model.tree().n_speeds, model.evaluate(function, state))
}

/// `C u = bias - gravity_forces - springs - dampers`.
pub fn coriolis_matrix_makes_the_bias(model: &dyn Model, state: &State) -> f64 {
    let c = matrix(model, "coriolis_matrix", state);
    let bias = model.evaluate("bias", state);
    let weight = model.evaluate("gravity_forces", state);
    let mut expected: Vec<f64> = bias.iter().zip(&weight).map(|(a, b)| a - b).collect();
    let mut most = larger(largest(&bias), mass_matrix(model, state).norm());
    let steady = State {
        u_dot: vec![0.0; state.u.len()],
        ..state.clone()
    };
    for acting in model.composition().acting() {
        let (speed, forces) = acting.needed(&steady);
        expected[speed] -= forces.iter().sum::<f64>();
        most = larger(most, largest(&forces));
    }
    relative_to(most, &c.times(&state.u), &expected)
}

/// `M_dot = C + C^T`.
pub fn rate_of_the_mass_matrix_is_twice_the_symmetric_part(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let c = matrix(model, "coriolis_matrix", state);
    let m_dot = model.evaluate("mass_matrix_dot", state);
    let sum = |place: usize| {
        let (row, column) = (place / c.n, place % c.n);
        c.at(row, column) + c.at(column, row)
    };
    let sums: Vec<f64> = (0..c.n * c.n).map(sum).collect();
    let scale = larger(c.norm(), mass_matrix(model, state).norm());
    relative_to(scale, &m_dot, &sums)
}

/// `M_dot` is the rate of `M` along the motion.
pub fn mass_matrix_dot_is_the_rate_of_the_mass_matrix(model: &dyn Model, state: &State) -> f64 {
    let steady = State {
        u_dot: vec![0.0; state.u.len()],
        ..state.clone()
    };
    let tree = model.tree();
    let at = |t: f64| mass_matrix(model, &steady.moved(tree, t)).entries;
    let m_dot = model.evaluate("mass_matrix_dot", state);
    relative_to(mass_matrix(model, state).norm(), &m_dot, &derivative(at))
}

/// `C_ij = sum_k (d_k M_ij + d_j M_ik - d_i M_jk) u_k / 2`, Christoffel's symbols of the first kind, where all speeds are rates
/// of coordinates; elsewhere nothing is said. The first sum is `M_dot`, and with `p = M u`, `u` held, the others are `d_j p_i` and `d_i p_j`.
pub fn coriolis_matrix_is_that_of_the_christoffel_symbols(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let is_rate = |orientation| matches!(orientation, Orientation::Rates(_));
    let mut bodies = tree.bodies.iter();
    if !bodies.all(|body| is_rate(body.joint.orientation)) {
        return 0.0;
    }
    let c = matrix(model, "coriolis_matrix", state);
    let m_dot = matrix(model, "mass_matrix_dot", state);
    let held = State {
        u_dot: state.u.clone(),
        ..state.clone()
    };
    let momentum = |state: &State| model.evaluate("mass_matrix_product", state);
    let gradient = |speed| derivative(|t| momentum(&held.displaced(tree, speed, t)));
    let gradients: Vec<Vec<f64>> = (0..c.n).map(gradient).collect();
    let expected = |place: usize| {
        let (i, j) = (place / c.n, place % c.n);
        0.5 * (m_dot.at(i, j) + gradients[j][i] - gradients[i][j])
    };
    let expected: Vec<f64> = (0..c.n * c.n).map(expected).collect();
    let scale = larger(c.norm(), mass_matrix(model, state).norm());
    relative_to(scale, &c.entries, &expected)
}
