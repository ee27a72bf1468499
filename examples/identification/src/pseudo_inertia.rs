//! The pseudo-inertia of a body: its ten inertial parameters as one matrix, which is positive definite where they are those of
//! a body of positive density.
//!
//! `P = [[Σ, m c], [m cᵀ, m]]` with `Σ` the integral of `x xᵀ` over the mass, `x` from the body's origin. The tensor of inertia about
//! the origin is `tr(Σ) 1 - Σ`. That `P` is positive definite says three things at once: positive mass, positive moments, and that no
//! principal moment exceeds the sum of the other two.

use nalgebra::Matrix4;

use crate::extremes::{largest, least};

/// The inertial parameters of a body, in the order of [`kane::functions::Regressor`].
pub const PARAMETERS: usize = 10;

/// `P` of ten inertial parameters.
pub fn of(parameters: &[f64; PARAMETERS]) -> Matrix4<f64> {
    let &[m, x, y, z, xx, xy, yy, xz, yz, zz] = parameters;
    let half = (xx + yy + zz) / 2.0;
    Matrix4::new(
        half - xx,
        -xy,
        -xz,
        x, //
        -xy,
        half - yy,
        -yz,
        y, //
        -xz,
        -yz,
        half - zz,
        z, //
        x,
        y,
        z,
        m,
    )
}

/// The ten inertial parameters of `P`: linear in it.
pub fn parameters(p: &Matrix4<f64>) -> [f64; PARAMETERS] {
    let trace = p[(0, 0)] + p[(1, 1)] + p[(2, 2)];
    [
        p[(3, 3)],
        p[(0, 3)],
        p[(1, 3)],
        p[(2, 3)],
        trace - p[(0, 0)],
        -p[(0, 1)],
        trace - p[(1, 1)],
        -p[(0, 2)],
        -p[(1, 2)],
        trace - p[(2, 2)],
    ]
}

/// The least eigenvalue of `P` once its axes begin in the mass centre, as a part of the largest: lengths and masses do not matter, and it is
/// positive where `P` is positive definite.
pub fn margin(p: &Matrix4<f64>) -> f64 {
    let mass = p[(3, 3)];
    let moments = p.fixed_view::<3, 1>(0, 3);
    let about_center = p.fixed_view::<3, 3>(0, 0) - moments * moments.transpose() / mass;
    let eigenvalues = about_center.symmetric_eigenvalues();
    if mass > 0.0 {
        least(&eigenvalues) / largest(&eigenvalues)
    } else {
        mass
    }
}
