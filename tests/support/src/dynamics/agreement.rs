//! How far two models of one system differ.

use kane_codegen::{
    base_parameters,
    functions::{CATALOGUE, Function},
    tree::Tree,
};

use super::{
    hybrid::apart,
    model::Model,
    numbering::renumbered_output,
    quantities::{mass_matrix, worst},
    state::State,
    topology::has_mimics,
};
use crate::{
    compare::{larger, largest, relative, relative_to, size_of},
    numeric::{Matrix, condition},
};

/// The largest difference of pivots, each relative to itself and to the condition number: a pivot is the reciprocal of a
/// diagonal entry of a leading block's inverse, which rounding of the block moves by its condition.
pub fn pivot_error(m: &Matrix, found: &[f64], expected: &[f64]) -> f64 {
    let error = |(found, expected): (&f64, &f64)| (found - expected) / expected;
    worst(found.iter().zip(expected).map(error)) / condition(m)
}

/// The bodies and the places of the parameters that stand for combinations.
fn bases(tree: &Tree) -> Vec<(&str, usize)> {
    let base = base_parameters::of(tree).iter();
    let first = base.map(|base| base.terms[0].0);
    first
        .map(|own| (tree.body(own.body).name.as_str(), own.place))
        .collect()
}

/// The largest relative difference of two models of one system, over all functions that `both` have; with its function.
///
/// Forward and hybrid dynamics are compared through the mass matrix (see [`forward_dynamics_undoes_inverse_dynamics`](super::forces::forward_dynamics_undoes_inverse_dynamics)), bias and inverse
/// dynamics relative to the mass matrix as well, for theirs are sums of terms of its size, and the forces of loads relative to
/// the loads' largest moment arm, which is that of the partial velocities.
pub fn disagreement(
    a: &dyn Model,
    b: &dyn Model,
    both: impl Fn(&Function) -> bool,
    state: &State,
) -> (f64, &'static str) {
    let other = state.renumbered(a.tree(), b.tree());
    let m = mass_matrix(a, state);
    let mut most = (0.0, "no function");
    for function in CATALOGUE.iter().filter(|function| both(function)) {
        if function.name == "mass_matrix_factors" && has_mimics(a.tree()) {
            // As the pivots below: an identity says what the factors make.
            continue;
        }
        if function.name == "base_parameters" {
            // Their factors are those of the nominal values, which the models may have apart.
            continue;
        }
        if function.name == "base_regressor" && bases(a.tree()) != bases(b.tree()) {
            // Which parameters stand for a combination follows from values and from the order of bodies: identities say what
            // they predict.
            continue;
        }
        let expected = a.evaluate(function.name, state);
        let found = b.evaluate(function.name, &other);
        let found = renumbered_output(function, &found, b.tree(), a.tree());
        let error = match function.name {
            "forward_dynamics" | "loaded_forward_dynamics" | "mass_matrix_solve" => {
                let left: Vec<f64> = expected.iter().zip(&found).map(|(a, b)| a - b).collect();
                size_of(m.norm() * larger(largest(&expected), 1.0), &m.times(&left))
            }
            "hybrid_dynamics" => apart(a, state, &found, &expected),
            // Joints that follow one another couple branches, whose order is then that of elimination: only the product of
            // all pivots does not depend on it.
            "forward_dynamics_pivots" if has_mimics(a.tree()) => {
                let logarithm = |pivots: &[f64]| pivots.iter().map(|pivot| pivot.ln()).sum::<f64>();
                (logarithm(&found) - logarithm(&expected)).abs() / condition(&m)
            }
            "forward_dynamics_pivots" => pivot_error(&m, &found, &expected),
            // Solutions with the mass matrix, whose rounding its condition number multiplies.
            "mass_matrix_inverse" | "mass_matrix_inverse_packed" | "mass_matrix_factors" => {
                relative(&found, &expected) / condition(&m)
            }
            // Sums of terms of the mass matrix's size.
            "mass_matrix_product"
            | "coriolis_matrix"
            | "mass_matrix_dot"
            | "bias"
            | "gravity_forces"
            | "inverse_dynamics"
            | "forcing"
            | "linear_momentum"
            | "angular_momentum"
            | "potential_energy"
            | "loaded_inverse_dynamics"
            | "potential_energies"
            | "joint_wrenches"
            | "centroidal_momentum_matrix"
            | "centroidal_momentum_matrix_dot_u" => {
                relative_to(larger(largest(&expected), m.norm()), &found, &expected)
            }
            // Means over bodies.
            "center_of_mass" | "center_of_mass_velocity" => {
                let of_bodies = match function.name {
                    "center_of_mass" => "mass_center_position",
                    _ => "mass_center_velocity",
                };
                relative_to(largest(&a.evaluate(of_bodies, state)), &found, &expected)
            }
            _ => relative(&found, &expected),
        };
        if error > most.0 || error.is_nan() {
            most = (error, function.name);
        }
    }
    most
}
