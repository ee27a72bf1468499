//! Lengths and angles without an arc tangent, which `core` has not.
//!
//! Only sums, products and quotients of [`Real`]: no branch, the same bits on every machine and in every lane.

use crate::{Real, square_root::square_root};

/// Keeps a quotient of zeros finite: it vanishes beside numbers above `1e-14`, and is a normal number of `f32`.
const TINY: f64 = 1e-30;

/// 2^-30: beside one nothing in single precision.
const LAST: f64 = 1.0 / 1_073_741_824.0;

/// The length of a vector of two to four entries; above zero even if all are zero.
///
/// Relative to the sum of the entries' magnitudes it is a number with a square between 1/4 and 1.
pub(super) fn length<R: Real, const N: usize>(v: [R; N]) -> R {
    let tiny = R::from_f64(TINY);
    let sum = v.iter().fold(tiny, |sum, entry| sum + entry.abs());
    let mut square = R::from_f64(0.0);
    for entry in v {
        let ratio = entry / sum;
        square = square + ratio * ratio;
    }
    sum * square_root(square)
}

/// `atan(t) / t` for `t²` from 0 to 1, from `t²`.
pub(super) fn arc_ratio<R: Real>(mut square: R) -> R {
    let (one, two) = (R::from_f64(1.0), R::from_f64(2.0));
    let quarter = R::from_f64(0.25);
    let mut ratio = one;
    // tan(a / 2) = t / (1 + sqrt(1 + t²)): three times, and tan² is below 0.01.
    for _ in 0..3 {
        let by = one / (one + two * square_root(quarter * (one + square)));
        ratio = two * ratio * by;
        square = square * by * by;
    }
    // 1 - t²/3 + t⁴/5 - ..: the first term left out is below 5e-18.
    let mut sum = R::from_f64(0.0);
    for term in (0..8_u8).rev() {
        sum = one / R::from_f64(f64::from(2 * term + 1)) - square * sum;
    }
    ratio * sum
}

/// The angle, from -π to π, whose sine and cosine are proportional to these two numbers.
pub(super) fn angle<R: Real>(sine: R, cosine: R) -> R {
    // That to the nearer half of the axis along which the cosine counts: the tangent of its half is from -1 to 1.
    let side = sign(cosine);
    let tangent = guarded(sine, length([sine, cosine]) + cosine.abs());
    let nearer = R::from_f64(2.0) * tangent * arc_ratio(tangent * tangent);
    let quarter = R::from_f64(core::f64::consts::FRAC_PI_2);
    side * nearer + (R::from_f64(1.0) - side) * sign(sine) * quarter
}

/// 1 or -1, exactly: the sign of a finite number, also of the least; 1 for zeros of both signs.
pub(crate) fn sign<R: Real>(number: R) -> R {
    let one = R::from_f64(1.0);
    // 1 in double precision, 0 in single.
    let double = (R::from_f64(1.0 + LAST) - one) / R::from_f64(LAST);
    let least = R::from_f64(1e-300) + (one - double) * R::from_f64(TINY);
    // The first quotient of the least numbers is small, and every second one is -1, 0 or 1.
    let once = number / (number.abs() + least);
    let sign = once / (once.abs() + least);
    sign + (one - sign * sign)
}

/// A quotient that is finite where both numbers vanish.
pub(super) fn guarded<R: Real>(number: R, by: R) -> R {
    number / (by + R::from_f64(TINY))
}
