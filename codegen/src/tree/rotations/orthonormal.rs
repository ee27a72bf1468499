//! The nearest orthonormal matrix of one that is written with few digits.

use crate::geometry::{IDENTITY, Rotation, dot, transposed};

/// The nearest orthonormal matrix of one that is not, by more than rounding: rotations may be written with few digits.
pub fn orthonormal(rotation: &Rotation) -> Rotation {
    if defect(rotation) < 1e-14 {
        return *rotation;
    }
    // What is off by 1e-6 is off by 1e-12 after one step, and by rounding after two.
    nearer_to_orthonormal(&nearer_to_orthonormal(rotation))
}

/// How far columns are from orthonormal: the largest entry of `R^T R - 1`.
pub(super) fn defect(rotation: &Rotation) -> f64 {
    let gram = gram(rotation);
    let entries = gram.as_flattened().iter().zip(IDENTITY.as_flattened());
    entries.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// `R^T R`.
fn gram(rotation: &Rotation) -> Rotation {
    let columns = transposed(rotation);
    columns.map(|a| columns.map(|b| dot(a, b)))
}

/// `R (3 - R^T R) / 2`: a step of Newton's iteration for the nearest orthonormal matrix.
pub(super) fn nearer_to_orthonormal(rotation: &Rotation) -> Rotation {
    let gram = gram(rotation);
    rotation.map(|row| {
        std::array::from_fn(|j| {
            1.5 * row[j] - 0.5 * (0..3).map(|k| row[k] * gram[k][j]).sum::<f64>()
        })
    })
}
