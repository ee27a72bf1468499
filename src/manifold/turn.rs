//! Rotation vectors: to quaternions, back, and their derivatives.
//!
//! A rotation vector is along the axis of the rotation, and its length is the angle, rad; a quaternion is scalar first, Hamilton's
//! product. Everything also holds near zero rotation, without a branch.

use super::angle::{angle, arc_ratio, guarded, length, sign};
use crate::Real;
use crate::three::{Matrix, Vector, square};

/// A unit quaternion.
pub(crate) type Quaternion<R> = [R; 4];

/// Hamilton's product.
pub(super) fn product<R: Real>(a: Quaternion<R>, b: Quaternion<R>) -> Quaternion<R> {
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (a, b);
    [
        a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3,
        a0 * b1 + a1 * b0 + a2 * b3 - a3 * b2,
        a0 * b2 - a1 * b3 + a2 * b0 + a3 * b1,
        a0 * b3 + a1 * b2 - a2 * b1 + a3 * b0,
    ]
}

/// The inverse rotation.
pub(super) fn inverse<R: Real>([e0, e1, e2, e3]: Quaternion<R>) -> Quaternion<R> {
    [e0, -e1, -e2, -e3]
}

/// `sin(a / 2) / a` and `cos(a / 2)` of the angle `a` of a rotation, and `a²`.
fn half<R: Real>(d: Vector<R>) -> (R, R, R) {
    let angle = length(d);
    let (sine, cosine) = (R::from_f64(0.5) * angle).sin_cos();
    (sine / angle, cosine, square(d))
}

/// The quaternion of a rotation vector.
pub(super) fn exp<R: Real>(d: Vector<R>) -> Quaternion<R> {
    let (ratio, cosine, _) = half(d);
    [cosine, ratio * d[0], ratio * d[1], ratio * d[2]]
}

/// The rotation vector of a quaternion of any length, with an angle from 0 to π.
pub(crate) fn log<R: Real>(e: Quaternion<R>) -> Vector<R> {
    // tan(a / 4) = |v| / (|e| + |e_0|).
    let size = length(e);
    let by = sign(e[0] / size) / (size + e[0].abs());
    let quarter = [e[1] * by, e[2] * by, e[3] * by];
    let ratio = R::from_f64(4.0) * arc_ratio(square(quarter));
    quarter.map(|entry| ratio * entry)
}

/// The quaternion of 1-2-3 body-fixed angles, rad.
pub(crate) fn of_angles<R: Real>(theta: Vector<R>) -> Quaternion<R> {
    let [(s1, c1), (s2, c2), (s3, c3)] = theta.map(|angle| (R::from_f64(0.5) * angle).sin_cos());
    // (c1, s1 x) (c2, s2 y) (c3, s3 z)
    [
        c1 * c2 * c3 - s1 * s2 * s3,
        s1 * c2 * c3 + c1 * s2 * s3,
        c1 * s2 * c3 - s1 * c2 * s3,
        c1 * c2 * s3 + s1 * s2 * c3,
    ]
}

/// The 1-2-3 body-fixed angles of a unit quaternion nearest to `near`, with `theta_2` on the same side of their singularity.
pub(super) fn angles_near<R: Real>(e: Quaternion<R>, near: Vector<R>) -> Vector<R> {
    let two = R::from_f64(2.0);
    let [e0, e1, e2, e3] = e;
    let [(s1, c1), (s2, c2), (s3, c3)] = near.map(R::sin_cos);
    // Entries of C(e)^T, Eq. (4): s2, -s1 c2, c1 c2.
    let new_s2 = two * (e1 * e3 + e0 * e2);
    let side = sign(c2);
    let s1c2 = side * two * (e0 * e1 - e2 * e3);
    let c1c2 = side * (e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3);
    let size = length([s1c2, c1c2]);
    let new_c2 = side * size;
    let (new_s1, new_c1) = (s1c2 / size, c1c2 / size);
    let xy = two * (e1 * e2 + e0 * e3);
    let xz = two * (e1 * e3 - e0 * e2);
    let yy = e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3;
    let yz = two * (e2 * e3 + e0 * e1);
    let (new_s3, new_c3) = (new_c1 * xy + new_s1 * xz, new_c1 * yy + new_s1 * yz);
    // By how much each has turned on.
    [
        near[0] + angle(new_s1 * c1 - new_c1 * s1, new_c1 * c1 + new_s1 * s1),
        near[1] + angle(new_s2 * c2 - new_c2 * s2, new_c2 * c2 + new_s2 * s2),
        near[2] + angle(new_s3 * c3 - new_c3 * s3, new_c3 * c3 + new_s3 * s3),
    ]
}

/// `1 + a [d] + b [d]²`, `[d]` the matrix of the cross product with `d`.
fn polynomial<R: Real>(d: Vector<R>, a: R, b: R) -> Matrix<R> {
    let (one, zero) = (R::from_f64(1.0), R::from_f64(0.0));
    let cross = [
        [zero, -d[2], d[1]],
        [d[2], zero, -d[0]],
        [-d[1], d[0], zero],
    ];
    let own = one - b * square(d);
    let row = |[x, y, z]: Vector<R>, cross: Vector<R>, factor: R| {
        [
            x + a * cross[0] + b * factor * d[0],
            y + a * cross[1] + b * factor * d[1],
            z + a * cross[2] + b * factor * d[2],
        ]
    };
    [
        row([own, zero, zero], cross[0], d[0]),
        row([zero, own, zero], cross[1], d[1]),
        row([zero, zero, own], cross[2], d[2]),
    ]
}

/// The matrix of the inverse rotation, what a rotation before makes of one after, and the right Jacobian of SO(3): the change of the
/// rotation by `d`, along its own moved axes, as `d` changes.
pub(crate) fn inverse_and_jacobian<R: Real>(d: Vector<R>) -> [Matrix<R>; 2] {
    let (one, two) = (R::from_f64(1.0), R::from_f64(2.0));
    let (ratio, cosine, square) = half(d);
    let sine_ratio = two * ratio * cosine;
    let versine_ratio = two * ratio * ratio;
    // The difference keeps no digits near no turn, and is multiplied by as little: the product is exact to rounding.
    let rest = guarded(one - sine_ratio, square);
    [
        polynomial(d, -sine_ratio, versine_ratio),
        polynomial(d, -versine_ratio, rest),
    ]
}

/// The inverse of the right Jacobian, for less than a full revolution.
pub(crate) fn jacobian_inverse<R: Real>(d: Vector<R>) -> Matrix<R> {
    let (one, two) = (R::from_f64(1.0), R::from_f64(2.0));
    let (ratio, cosine, square) = half(d);
    let rest = guarded(one - cosine / (two * ratio), square);
    polynomial(d, R::from_f64(0.5), rest)
}
