//! How to turn from one orientation to another.

use kane::Real;

/// The axis about which to turn from one orientation to another, by the sine of the angle long; inertial components. Both as `pose`
/// writes them.
pub(crate) fn turn<R: Real>(from: &[[R; 3]; 3], to: &[[R; 3]; 3]) -> [R; 3] {
    let half = R::from_f64(0.5);
    let cross = |i: usize, j: usize| {
        let of_row = |k: usize| from[k][i] * to[k][j] - from[k][j] * to[k][i];
        half * (of_row(0) + of_row(1) + of_row(2))
    };
    [cross(1, 2), cross(2, 0), cross(0, 1)]
}
