//! The nearest orthonormal matrix of one that is written with few digits.

use crate::geometry::{IDENTITY, Rotation, dot, transposed};

/// The nearest orthonormal matrix of one that is not, by more than rounding: rotations may be written with few digits.
pub fn orthonormal(rotation: &Rotation) -> Rotation {
    let columns = transposed(rotation);
    let gram = columns.map(|a| columns.map(|b| dot(a, b)));
    let entries = gram.iter().flatten().zip(IDENTITY.iter().flatten());
    let defect = entries.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    if defect < 1e-14 {
        return *rotation;
    }
    // What is off by 1e-6 is off by 1e-12 after one step, and by rounding after two.
    nearer_to_orthonormal(&nearer_to_orthonormal(rotation))
}

/// `R (3 - R^T R) / 2`: a step of Newton's iteration for the nearest orthonormal matrix.
pub(super) fn nearer_to_orthonormal(rotation: &Rotation) -> Rotation {
    let columns = transposed(rotation);
    let gram = columns.map(|a| columns.map(|b| dot(a, b)));
    rotation.map(|row| {
        std::array::from_fn(|j| {
            1.5 * row[j] - 0.5 * (0..3).map(|k| row[k] * gram[k][j]).sum::<f64>()
        })
    })
}
