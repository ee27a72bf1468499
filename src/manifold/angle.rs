//! Lengths and angles without an arc tangent, which `core` has not.
//!
//! Only sums, products and quotients of [`Real`]: no branch, the same bits on every machine and in every lane.

use crate::{Real, square_root::square_root};

/// Keeps a quotient of zeros finite: it vanishes beside numbers above `1e-14`, and is a normal number of `f32`.
const TINY: f64 = 1e-30;

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

/// 1 or -1, the sign of the number; 1 for zero.
pub(crate) fn sign<R: Real>(number: R) -> R {
    // What is added is nothing beside a cosine that rounding leaves of a right angle, and the negative of no number that is written.
    let number = number + R::from_f64(1.234_567_89e-20);
    number / number.abs()
}

/// A quotient that is finite where both numbers vanish.
pub(super) fn guarded<R: Real>(number: R, by: R) -> R {
    number / (by + R::from_f64(TINY))
}
