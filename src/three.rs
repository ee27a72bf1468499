//! Vectors and matrices of three.
//!
//! Entries are written out: where the compiler keeps a loop over places, it checks each of them, and callers can panic.

use crate::Real;

/// A vector of three components.
pub(crate) type Vector<R> = [R; 3];

/// A matrix by rows.
pub(crate) type Matrix<R> = [[R; 3]; 3];

/// The square of a vector's length.
pub(crate) fn square<R: Real>(v: Vector<R>) -> R {
    v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
}

/// The cross product.
pub(crate) fn cross<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn transposed<R: Real>(matrix: &Matrix<R>) -> Matrix<R> {
    let [a, b, c] = *matrix;
    [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]]
}

/// A matrix times a vector.
pub(crate) fn times<R: Real>(matrix: &Matrix<R>, v: Vector<R>) -> Vector<R> {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// A transposed matrix times a vector.
pub(crate) fn transposed_times<R: Real>(matrix: &Matrix<R>, v: Vector<R>) -> Vector<R> {
    times(&transposed(matrix), v)
}
