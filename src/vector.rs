//! Sums of arrays. Nothing is indexed, so that no panic remains in a linked program.

use crate::{Array, Real};

/// `sum += factor b`.
pub(crate) fn add_scaled<R: Real, A: Array<R>>(sum: &mut A, factor: R, b: &A) {
    for (sum, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *sum = *sum + factor * *b;
    }
}

/// `a + factor b`.
pub(crate) fn plus_scaled<R: Real, A: Array<R>>(a: &A, factor: R, b: &A) -> A {
    let mut sum = *a;
    add_scaled(&mut sum, factor, b);
    sum
}

/// `a + b`.
pub(crate) fn plus<R: Real, A: Array<R>>(a: &A, b: &A) -> A {
    let mut sum = *a;
    for (sum, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *sum = *sum + *b;
    }
    sum
}

/// `factor a`.
pub(crate) fn scaled<R: Real, A: Array<R>>(factor: R, a: &A) -> A {
    let mut scaled = *a;
    for entry in scaled.as_mut() {
        *entry = factor * *entry;
    }
    scaled
}

/// Zeros.
pub(crate) fn zero<R: Real, A: Array<R>>() -> A {
    A::filled(R::from_f64(0.0))
}

/// One at this entry, zeros elsewhere.
pub(crate) fn unit<R: Real, A: Array<R>>(entry: usize) -> A {
    A::from_fn(|place| R::from_f64(if place == entry { 1.0 } else { 0.0 }))
}

/// A matrix by rows times a vector.
pub(crate) fn times<R: Real, U: Array<R>, M: Array<U>>(matrix: &M, v: &U) -> U {
    let mut product = zero::<R, U>();
    for (sum, row) in product.as_mut().iter_mut().zip(matrix.as_ref()) {
        for (entry, v) in row.as_ref().iter().zip(v.as_ref()) {
            *sum = *sum + *entry * *v;
        }
    }
    product
}

/// A column of a matrix by rows, one entry per speed.
pub(crate) fn column<R: Real, U: Array<R>, Row: Array<R>, M: Array<Row>>(
    matrix: &M,
    place: usize,
) -> U {
    let mut column = zero::<R, U>();
    for (entry, row) in column.as_mut().iter_mut().zip(matrix.as_ref()) {
        if let Some(own) = row.as_ref().get(place) {
            *entry = *own;
        }
    }
    column
}

/// Overwrites a column of a matrix by rows.
pub(crate) fn set_column<R: Real, U: Array<R>, Row: Array<R>, M: Array<Row>>(
    matrix: &mut M,
    place: usize,
    column: &U,
) {
    for (row, entry) in matrix.as_mut().iter_mut().zip(column.as_ref()) {
        if let Some(own) = row.as_mut().get_mut(place) {
            *own = *entry;
        }
    }
}
