//! Orientations for task-space controllers and the costs of poses: errors, rotation vectors, and the derivatives of both.
//!
//! Rotation matrices are as [`Pose`](crate::functions::Pose) writes them: inertial components **to** components along the frame's axes, row by
//! row. A rotation vector, rad, is along the axis about which the frame has turned, counterclockwise seen from its tip; its length is the
//! angle. Because the axis turns into itself, the vector has the same components along the inertial axes and along the frame's.
//! If the matrices map from another frame, it takes the place of the inertial one.
//!
//! | function | what it computes |
//! | --- | --- |
//! | [`exp`], [`log`] | the matrix of a rotation vector, and back |
//! | [`difference`] | the rotation vector from one orientation to another |
//! | [`error`] | the same with `2 sin(angle / 2)` for the angle, which costs less |
//! | [`exp_jacobian`], [`log_jacobian`] | the angular velocity for a rate of the vector, and the rate for an angular velocity |
//! | [`error_and_jacobian`] | the error, and its rate for an angular velocity |
//!
//! Rotation vectors take only arithmetic of [`Real`], without branches on numbers, so also in lanes. Errors branch, and take a
//! quarter of the time.
//!
//! ```
//! use kane::rotation::{difference, exp, log_jacobian};
//!
//! let (goal, rotation) = (exp(&[0.0, 0.0, 0.3_f64]), exp(&[0.0, 0.0, 0.5]));
//! // The cost is half the square of this vector.
//! let v = difference(&goal, &rotation);
//! assert!(v[0] == 0.0 && v[1] == 0.0 && (v[2] - 0.2).abs() < 1e-15);
//! // Its gradient by the angular velocity, inertial components: with the rows `angular` of a Jacobian it becomes that by the speeds.
//! let by_w = log_jacobian(&v);
//! let gradient = [0, 1, 2].map(|j| v[0] * by_w[0][j] + v[1] * by_w[1][j] + v[2] * by_w[2][j]);
//! assert!((gradient[2] - 0.2).abs() < 1e-15);
//! ```

use crate::manifold::{sign, turn};
use crate::three::{transposed, transposed_times};
use crate::vector::plus;
use crate::{Real, square_root::square_root};

/// The rotation matrix of a frame that has turned by a rotation vector, rad, of a length below 2^31 in `f64`, 2^17 in `f32`.
///
/// ```
/// let [x_axis, _, _] = kane::rotation::exp(&[0.0, 0.0, core::f64::consts::FRAC_PI_2]);
/// assert!((x_axis[1] - 1.0).abs() < 1e-15, "the frame's x axis is the inertial y axis");
/// ```
#[must_use]
pub fn exp<R: Real>(vector: &[R; 3]) -> [[R; 3]; 3] {
    let [matrix, _] = turn::inverse_and_jacobian(*vector);
    matrix
}

/// The rotation vector of a rotation matrix, rad: [`exp`] back, with a length from 0 to π.
///
/// The error is a few roundings of the matrix, also near 0 and π: for a matrix with entries right to 1e-16 a few 1e-16 rad. Near π the vector may
/// be that of the other way round, of nearly the same rotation.
#[must_use]
pub fn log<R: Real>(rotation: &[[R; 3]; 3]) -> [R; 3] {
    turn::log(quaternion(&transposed(rotation)))
}

/// The rotation vector, rad, that takes a frame from the rotation matrix `from` to `to`, the shorter way.
///
/// It has the components that the matrices map from: along the inertial axes, or along those of another frame. Accuracy is that of [`log`].
#[must_use]
pub fn difference<R: Real>(from: &[[R; 3]; 3], to: &[[R; 3]; 3]) -> [R; 3] {
    turn::log(quaternion(&between(from, to)))
}

/// The angular velocity of a frame turned by a rotation vector, inertial components, per rate of the vector: entry `[i][j]` is
/// component `i` for a unit rate of entry `j`.
///
/// The left Jacobian of SO(3). Its transpose, the right Jacobian, gives components along the frame's axes. Right to rounding up to the lengths for which [`exp`] is.
#[must_use]
pub fn exp_jacobian<R: Real>(vector: &[R; 3]) -> [[R; 3]; 3] {
    let [_, right] = turn::inverse_and_jacobian(*vector);
    transposed(&right)
}

/// The rate of the rotation vector per angular velocity of the frame, inertial components: entry `[i][j]` is the rate of entry `i` for a
/// unit angular velocity about axis `j`. The inverse of [`exp_jacobian`].
///
/// The inverse left Jacobian of SO(3), at `vector` from [`log`]. Its transpose, the inverse right Jacobian, takes the angular velocity along
/// the frame's own axes. For [`difference`] it takes the angular velocity of `to`, along the axes of the vector's components; the rate for
/// that of `from` is minus its transpose. Right to rounding up to π; singular only at whole revolutions.
#[must_use]
pub fn log_jacobian<R: Real>(vector: &[R; 3]) -> [[R; 3]; 3] {
    transposed(&turn::jacobian_inverse(*vector))
}

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
#[must_use]
pub fn error<R: Real + PartialOrd>(from: &[[R; 3]; 3], to: &[[R; 3]; 3]) -> [R; 3] {
    error_and_cosine(from, to).0
}

/// The orientation [`error`], and its rate per angular velocity of `to`: entry `[i][j]` is the rate of component `i` for a unit angular
/// velocity about axis `j`, both along the axes of the error's components.
///
/// The matrix is `cos(angle / 2) - [error] / 2`, with `[error]` that of the cross product. The rate for the angular velocity of `from` is
/// minus its transpose. At π, where the shorter way changes sides, the error jumps.
#[must_use]
pub fn error_and_jacobian<R: Real + PartialOrd>(
    from: &[[R; 3]; 3],
    to: &[[R; 3]; 3],
) -> ([R; 3], [[R; 3]; 3]) {
    let (error, cosine) = error_and_cosine(from, to);
    let [x, y, z] = error.map(|entry| R::from_f64(0.5) * entry);
    (error, [[cosine, z, -y], [-z, cosine, x], [y, -x, cosine]])
}

/// The orientation error, and the cosine of half its angle.
pub(crate) fn error_and_cosine<R: Real + PartialOrd>(
    from: &[[R; 3]; 3],
    to: &[[R; 3]; 3],
) -> ([R; 3], R) {
    let turn = between(from, to);
    let zero = R::from_f64(0.0);
    let [x, y, z] = [turn[0][0], turn[1][1], turn[2][2]];
    let greatest = if x + y + z > zero {
        0
    } else if x >= y && x >= z {
        1
    } else if y >= z {
        2
    } else {
        3
    };
    let row = rows(&turn)[greatest];
    let [scalar, vector @ ..] = row;
    let square = row[greatest];
    // The square is from 1 to 4.
    let (half, quarter) = (R::from_f64(0.5), R::from_f64(0.25));
    let factor = half / square_root(quarter * square);
    let factor = if scalar < zero { -factor } else { factor };
    (vector.map(|entry| factor * entry), half * factor * scalar)
}

/// The turn, from one orientation to another, of vectors that are fixed in the frame: inertial components to inertial components.
fn between<R: Real>(from: &[[R; 3]; 3], to: &[[R; 3]; 3]) -> [[R; 3]; 3] {
    transposed(to).map(|column| transposed_times(from, column))
}

/// The quaternion of a turn of vectors, scalar first, of a length from 8 to 16; without the comparisons of errors, for lanes.
fn quaternion<R: Real>(turn: &[[R; 3]; 3]) -> [R; 4] {
    // The sum of the rows, each times its own square and with the sign of the others: rows with few digits, of small entries, do not count, and
    // nothing cancels.
    rows(turn)
        .iter()
        .enumerate()
        .fold([R::from_f64(0.0); 4], |sum, (i, row)| {
            let along = sum[0] * row[0] + sum[1] * row[1] + sum[2] * row[2] + sum[3] * row[3];
            let weight = sign(along) * row[i];
            plus(&sum, &row.map(|entry| weight * entry))
        })
}

/// The unit quaternion of a turn of vectors, scalar first, in each row times four times one of its entries, whose square stands on the diagonal.
fn rows<R: Real>(turn: &[[R; 3]; 3]) -> [[R; 4]; 4] {
    let one = R::from_f64(1.0);
    let [x, y, z] = [turn[0][0], turn[1][1], turn[2][2]];
    let odd = [
        turn[2][1] - turn[1][2],
        turn[0][2] - turn[2][0],
        turn[1][0] - turn[0][1],
    ];
    let even = |i: usize, j: usize| turn[i][j] + turn[j][i];
    [
        [one + x + y + z, odd[0], odd[1], odd[2]],
        [odd[0], one + x - y - z, even(0, 1), even(0, 2)],
        [odd[1], even(0, 1), one - x + y - z, even(1, 2)],
        [odd[2], even(0, 2), even(1, 2), one - x - y + z],
    ]
}
