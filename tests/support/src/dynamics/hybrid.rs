//! Identities of hybrid dynamics, whatever speeds of the model's tree are prescribed.

use super::{model::Model, quantities::mass_matrix, state::State};
use crate::compare::{larger, largest, relative_to, size_of};

/// With `tau = inverse_dynamics(u_dot)` both come out as they are given, and what is found is not read; accelerations as
/// [`forward_dynamics_undoes_inverse_dynamics`](super::forces::forward_dynamics_undoes_inverse_dynamics) has them.
pub fn hybrid_dynamics_keeps_a_motion_and_its_forces(model: &dyn Model, state: &State) -> f64 {
    let tau = model.evaluate("inverse_dynamics", state);
    let mut given = State {
        u_dot: vec![f64::NAN; tau.len()],
        tau: tau.clone(),
        ..state.clone()
    };
    for speed in model.tree().prescribed.iter().map(|speed| speed.index()) {
        given.u_dot[speed] = state.u_dot[speed];
        given.tau[speed] = f64::NAN;
    }
    let found = model.evaluate("hybrid_dynamics", &given);
    apart(model, state, &found, &[state.u_dot.clone(), tau].concat())
}

/// The whole forces are those of the whole accelerations, `whole_tau = inverse_dynamics(whole_u_dot)`.
pub fn whole_forces_are_those_of_whole_accelerations(model: &dyn Model, state: &State) -> f64 {
    let found = model.evaluate("hybrid_dynamics", state);
    let u_dot = found[..model.tree().n_speeds].to_vec();
    let moved = State {
        u_dot: u_dot.clone(),
        ..state.clone()
    };
    let tau = model.evaluate("inverse_dynamics", &moved);
    apart(model, state, &found, &[u_dot, tau].concat())
}

/// How far two results of hybrid dynamics are apart: accelerations by the forces for what is between them, and forces; both
/// relative to the forces, the bias and the mass matrix.
pub fn apart(model: &dyn Model, state: &State, found: &[f64], expected: &[f64]) -> f64 {
    let m = mass_matrix(model, state);
    let bias = largest(&model.evaluate("bias", state));
    let ((a, f), (b, g)) = (found.split_at(m.n), expected.split_at(m.n));
    let scale = larger(m.norm() * larger(largest(b), 1.0), larger(largest(g), bias));
    let left: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    larger(size_of(scale, &m.times(&left)), relative_to(scale, f, g))
}
