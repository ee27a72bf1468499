//! The error between two orientations, for task-space controllers and solvers.

use crate::{Array, Real, square_root::square_root};

/// The orientation error: the vector along the axis of the rotation that takes a frame from the rotation matrix `from` to `to`.
///
/// Its length is `2 sin(angle / 2)`, the angle in rad to third order. Rotation matrices are as [`Pose`](crate::functions::Pose) writes
/// them. The vector has the components that they map from: along the inertial axes, or along those of another frame. It describes the
/// shorter rotation, and vanishes only if the two orientations agree.
///
/// ```
/// let from = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// // Turned by 0.2 rad about z: its rows are its axes.
/// let (s, c) = f64::sin_cos(0.2);
/// let to = [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
/// let [x, y, z] = kane::rotation::error(&from, &to);
/// assert!(x == 0.0 && y == 0.0 && (z - 0.2).abs() < 1e-3);
/// ```
pub fn error<R: Real + PartialOrd>(from: &[[R; 3]; 3], to: &[[R; 3]; 3]) -> [R; 3] {
    error_and_cosine(from, to).0
}

/// The orientation error, and the cosine of half its angle.
pub(crate) fn error_and_cosine<R: Real + PartialOrd>(
    from: &[[R; 3]; 3],
    to: &[[R; 3]; 3],
) -> ([R; 3], R) {
    // The turn of vectors that are fixed in the frame.
    let turn: [[R; 3]; 3] = Array::from_fn(|i| {
        Array::from_fn(|j| to[0][i] * from[0][j] + to[1][i] * from[1][j] + to[2][i] * from[2][j])
    });
    let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
    let [x, y, z] = [0, 1, 2].map(|i| turn[i][i]);
    let odd = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| turn[i][j] - turn[j][i]);
    let even = |i: usize, j: usize| turn[i][j] + turn[j][i];

    // Euler parameters times four times the one that is greatest: the greatest stands in `square`, four times its square.
    let (square, scalar, vector) = if x + y + z > zero {
        let square = one + x + y + z;
        (square, square, odd)
    } else if x >= y && x >= z {
        let square = one + x - y - z;
        (square, odd[0], [square, even(0, 1), even(0, 2)])
    } else if y >= z {
        let square = one - x + y - z;
        (square, odd[1], [even(0, 1), square, even(1, 2)])
    } else {
        let square = one - x - y + z;
        (square, odd[2], [even(0, 2), even(1, 2), square])
    };
    // The square is from 1 to 4.
    let (half, quarter) = (R::from_f64(0.5), R::from_f64(0.25));
    let factor = half / square_root(quarter * square);
    let factor = if scalar < zero { -factor } else { factor };
    (vector.map(|entry| factor * entry), half * factor * scalar)
}
