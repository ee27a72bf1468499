//! Identities of what the mass matrix is as an operator: its products, its inverse, its factors.

use std::collections::BTreeSet;

use kane_codegen::solve;

use super::{
    agreement::pivot_error,
    model::Model,
    quantities::{mass_matrix, worst},
    state::State,
};
use crate::{
    compare::{larger, largest, relative, relative_to, size_of},
    numeric::{Matrix, condition},
};

fn inverse(model: &dyn Model, state: &State) -> Matrix {
    let entries = model.evaluate("mass_matrix_inverse", state);
    Matrix::new(model.tree().n_speeds, entries)
}

/// `mass_matrix_product = M u_dot`.
pub fn mass_matrix_product_is_the_product(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let found = model.evaluate("mass_matrix_product", state);
    let scale = m.norm() * largest(&state.u_dot);
    relative_to(scale, &found, &m.times(&state.u_dot))
}

/// `mass_matrix_solve(M u_dot) = u_dot`, as forward dynamics undoes inverse dynamics.
pub fn mass_matrix_solve_undoes_the_product(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let given = State {
        tau: m.times(&state.u_dot),
        ..state.clone()
    };
    let found = model.evaluate("mass_matrix_solve", &given);
    let left: Vec<f64> = found.iter().zip(&state.u_dot).map(|(a, b)| a - b).collect();
    size_of(m.norm() * larger(1.0, largest(&found)), &m.times(&left))
}

/// `M^-1 = M^-T`.
pub fn mass_matrix_inverse_is_symmetric(model: &dyn Model, state: &State) -> f64 {
    let h = inverse(model, state);
    let mirrored: Vec<f64> = (0..h.n * h.n)
        .map(|place| h.at(place % h.n, place / h.n))
        .collect();
    relative(&mirrored, &h.entries)
}

/// `M^-1 M = 1`, relative to the condition number.
pub fn mass_matrix_inverse_is_the_inverse(model: &dyn Model, state: &State) -> f64 {
    let (m, h) = (mass_matrix(model, state), inverse(model, state));
    let column = |place: usize| {
        let column: Vec<f64> = (0..m.n).map(|row| m.at(row, place)).collect();
        let mut left = h.times(&column);
        left[place] -= 1.0;
        size_of(1.0, &left)
    };
    // The norm of the inverse weighs the rounding of M in rows of different units.
    worst((0..m.n).map(column)) / larger(condition(&m), m.norm() * h.norm())
}

/// The packed entries are those of `M^-1`, and what has no place among them is zero.
pub fn packed_inverse_is_the_lower_triangle(model: &dyn Model, state: &State) -> f64 {
    let (m, mut h) = (mass_matrix(model, state), inverse(model, state));
    let packed = model.evaluate("mass_matrix_inverse_packed", state);
    let places: BTreeSet<[usize; 2]> = solve::inverse_places(model.tree());
    assert_eq!(packed.len(), places.len());
    let expected: Vec<f64> = places
        .iter()
        .map(|&[row, column]| h.at(row, column))
        .collect();
    for [row, column] in places {
        h.entries[row * h.n + column] = 0.0;
        h.entries[column * h.n + row] = 0.0;
    }
    assert!(
        h.entries.iter().all(|entry| *entry == 0.0),
        "{}",
        model.tree().name
    );
    relative(&packed, &expected) / condition(&m)
}

/// `L^T D L = M`, and D is that of `forward_dynamics_pivots`.
pub fn mass_matrix_factors_make_the_mass_matrix(model: &dyn Model, state: &State) -> f64 {
    let m = mass_matrix(model, state);
    let packed = model.evaluate("mass_matrix_factors", state);
    let places = solve::factor_places(model.tree());
    assert_eq!(packed.len(), places.len());
    let order = solve::elimination(model.tree());
    let place = |speed: usize| order.iter().position(|own| *own == speed);
    let (mut l, mut d) = (Matrix::new(m.n, vec![0.0; m.n * m.n]), vec![0.0; m.n]);
    for (&entry, [row, column]) in packed.iter().zip(places) {
        let (first, other) = if place(row) < place(column) {
            (row, column)
        } else {
            (column, row)
        };
        if row == column {
            d[row] = entry;
            l.entries[row * m.n + row] = 1.0;
        } else {
            l.entries[first * m.n + other] = entry;
        }
    }
    let product = |row: usize, column: usize| {
        let terms = (0..m.n).map(|k| l.at(k, row) * d[k] * l.at(k, column));
        terms.sum::<f64>()
    };
    let made: Vec<f64> = (0..m.n * m.n)
        .map(|place| product(place / m.n, place % m.n))
        .collect();
    let pivots = model.evaluate("forward_dynamics_pivots", state);
    worst([
        relative_to(m.norm(), &made, &m.entries),
        pivot_error(&m, &d, &pivots),
    ])
}
