//! What identities are said of: the outputs of functions as vectors and matrices, and how exactly they hold.

use kane_codegen::tree::Tree;

use super::{model::Model, state::State};
use crate::{
    compare::largest,
    numeric::Matrix,
    rotation::{Vector, times, transposed},
};

/// Identities of sums and products alone: some hundred to some thousand roundings, of which the chains that feed one number
/// are some hundred long.
pub const EXACT: f64 = 2e-14;
/// Identities with a derivative by finite differences: 2e-14 of each evaluation's relative error in units of rounding
/// (see [`derivative`](crate::numeric::derivative)), which is some ten to a hundred where terms cancel.
pub const DIFFERENTIATED: f64 = 1e-12;
/// Identities with the factors of base parameters, which come from least squares over columns of unit length: their condition
/// multiplies rounding. Found: 3e-14.
pub const FITTED: f64 = 1e-12;

pub fn vectors(model: &dyn Model, function: &str, state: &State) -> Vec<Vector> {
    let numbers = model.evaluate(function, state);
    numbers
        .chunks_exact(3)
        .map(|vector| [vector[0], vector[1], vector[2]])
        .collect()
}

pub fn matrices(model: &dyn Model, function: &str, state: &State) -> Vec<[Vector; 3]> {
    let rows = vectors(model, function, state);
    rows.chunks_exact(3)
        .map(|rows| [rows[0], rows[1], rows[2]])
        .collect()
}

/// One row of `NU` numbers for each body and component.
pub fn rows(model: &dyn Model, function: &str, state: &State) -> Vec<Vec<f64>> {
    let numbers = model.evaluate(function, state);
    numbers
        .chunks_exact(model.tree().n_speeds)
        .map(<[f64]>::to_vec)
        .collect()
}

pub fn mass_matrix(model: &dyn Model, state: &State) -> Matrix {
    Matrix::new(model.tree().n_speeds, model.evaluate("mass_matrix", state))
}

pub fn gravity(tree: &Tree) -> Vector {
    tree.gravity.map(|value| tree.nominal(value))
}

/// `f` of every body, in inertial components: `f` gives body components.
pub fn in_inertial(model: &dyn Model, state: &State, vectors: &[Vector]) -> Vec<f64> {
    let rotations = matrices(model, "rotation", state);
    let turn = |(rotation, vector): (&[Vector; 3], &Vector)| times(&transposed(rotation), *vector);
    rotations.iter().zip(vectors).flat_map(turn).collect()
}

/// As [`in_inertial`], of vectors in the components of the lower body.
pub fn lower_in_inertial(model: &dyn Model, state: &State, vectors: &[Vector]) -> Vec<f64> {
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
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    largest(&errors.into_iter().collect::<Vec<_>>())
}
