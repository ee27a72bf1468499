//! Sums of arrays.

use crate::{Array, Real};

/// `a + factor b`.
pub(super) fn plus_scaled<R: Real, A: Array<R>>(a: &A, factor: R, b: &A) -> A {
    A::from_fn(|place| a[place] + factor * b[place])
}

/// `a + b`.
pub(super) fn plus<R: Real, A: Array<R>>(a: &A, b: &A) -> A {
    A::from_fn(|place| a[place] + b[place])
}

/// `factor a`.
pub(super) fn scaled<R: Real, A: Array<R>>(factor: R, a: &A) -> A {
    A::from_fn(|place| factor * a[place])
}

/// No change.
pub(super) fn zero<R: Real, A: Array<R>>() -> A {
    A::filled(R::from_f64(0.0))
}

/// One entry of a change alone.
pub(super) fn unit<R: Real, A: Array<R>>(entry: usize) -> A {
    A::from_fn(|place| R::from_f64(if place == entry { 1.0 } else { 0.0 }))
}

/// A matrix by rows times a vector.
pub(super) fn times<R: Real, U: Array<R>, M: Array<U>>(matrix: &M, v: &U) -> U {
    U::from_fn(|row| {
        let row = matrix[row].as_ref().iter();
        let zero = R::from_f64(0.0);
        row.zip(v.as_ref())
            .fold(zero, |sum, (entry, v)| sum + *entry * *v)
    })
}

/// A column of a matrix by rows, one entry a speed.
pub(super) fn column<R: Real, U: Array<R>, Row: Array<R>, M: Array<Row>>(
    matrix: &M,
    place: usize,
) -> U {
    U::from_fn(|row| matrix[row][place])
}

/// Writes such a column.
pub(super) fn set_column<R: Real, U: Array<R>, Row: Array<R>, M: Array<Row>>(
    matrix: &mut M,
    place: usize,
    column: &U,
) {
    for (row, entry) in matrix.as_mut().iter_mut().zip(column.as_ref()) {
        row[place] = *entry;
    }
}
