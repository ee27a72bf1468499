//! The `f32` pair, in `f32` arithmetic throughout: most microcontrollers have no other.

#![expect(
    clippy::inline_always,
    reason = "the lanes of an array become vectors only where nothing is left to call"
)]

use super::word::{Word, select};

/// Adding it rounds to the nearest integer and leaves that integer, mod 2^22, in the low bits.
const ROUND: f32 = 12_582_912.0; // 1.5 * 2^23
/// The limit to which the argument is clamped, so that the reduced angle stays below 1.
const CUT: f32 = 65_536.0; // 2^16

const TWO_OVER_PI: f32 = core::f32::consts::FRAC_2_PI;
/// `π/2` in 11, 11, 11 and 24 bits: `n` times any of the first three is exact for `|n| < 2^13`.
const HALF_PI: [f32; 4] = [1.570_312_5, 4.837_513e-4, 7.549_533_6e-8, 2.563_344e-12];

/// `(sin(r) - r) / r^3` in `z = r^2`, to 2^-27.9 of the sine.
const SIN: [f32; 3] = [-0.166_666_55, 0.008_332_189, -0.000_195_182_83];
/// `(cos(r) - 1 + z/2) / z^2` in `z = r^2`, to 2^-32.9 of the cosine.
const COS: [f32; 3] = [0.041_666_646, -0.001_388_731, 2.443_232_7e-5];

/// Sine and cosine of `x` (rad).
#[inline(always)]
pub(crate) fn sin_cos<W: Word<Float = f32>>(x: W) -> (W, W) {
    let (quadrant, n) = quarter_turns(x);
    let (hi, lo) = reduce(x, n);
    select(quadrant, sin(hi, lo), cos(hi, lo))
}

/// The integer nearest to `2x/π`: in the low two bits, mod 4, and as a number; the argument is clamped so that nothing below can
/// overflow.
#[inline(always)]
fn quarter_turns<W: Word<Float = f32>>(x: W) -> (W, W) {
    let round = W::from(ROUND);
    let shifted = x.cut(CUT) * TWO_OVER_PI.into() + round;
    (shifted, shifted - round)
}

/// `x - n π/2` as the sum of two numbers, the second below half an ulp of the first.
#[inline(always)]
fn reduce<W: Word<Float = f32>>(x: W, n: W) -> (W, W) {
    let half_pi = |part: usize| W::from(HALF_PI[part]);
    // The first two differences are exact; the third loses `rest`.
    let second = (x.cut(CUT) - n * half_pi(0)) - n * half_pi(1);
    let w = n * half_pi(2);
    let third = second - w;
    let rest = (second - third) - w;
    let w = n * half_pi(3);
    let hi = third - w;
    // `0 x` is 0, or NaN where x is not finite: it undoes the cut of an infinity.
    let lo = ((third - hi) - w) + rest + W::from(0.0) * x;
    (hi, lo)
}

/// `sin(hi + lo)` for `|hi| <= π/4`.
#[inline(always)]
fn sin<W: Word<Float = f32>>(hi: W, lo: W) -> W {
    let k = |power: usize| W::from(SIN[power]);
    let z = hi * hi;
    let cube = z * hi;
    let p = z * cube * (k(1) + z * k(2));
    hi - (((z * (W::from(0.5) * lo) - lo) - p) - cube * k(0))
}

/// `cos(hi + lo)` for `|hi| <= π/4`.
#[inline(always)]
fn cos<W: Word<Float = f32>>(hi: W, lo: W) -> W {
    let (one, k) = (W::from(1.0), |power: usize| W::from(COS[power]));
    let z = hi * hi;
    let zz = z * z;
    let p = (k(0) + z * k(1)) + zz * k(2);
    let half = W::from(0.5) * z;
    let head = one - half;
    head + ((((one - head) - half) - hi * lo) + zz * p)
}
