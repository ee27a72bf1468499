//! The `f64` pair.

#![expect(
    clippy::inline_always,
    reason = "the lanes of an array become vectors only where nothing is left to call"
)]

use super::word::{Word, select};

/// Adding it rounds to the nearest integer and leaves that integer, mod 2^51, in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52
/// The limit to which the argument is clamped, so that nothing below can overflow.
const CUT: f64 = 1_073_741_824.0; // 2^30

const TWO_OVER_PI: f64 = core::f64::consts::FRAC_2_PI;
/// `π/2` in 38, 38 and 53 bits: `n` times either of the first two is exact for `|n| < 2^15`.
const HALF_PI: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// `(sin(r) - r) / r^3` in `z = r^2`, to 2^-57.8 of the sine.
const SIN: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_321_84,
    -0.000_198_412_698_293_585_28,
    2.755_731_353_851_424_2e-6,
    -2.505_073_438_926_613e-8,
    1.589_543_329_036_380_8e-10,
];
/// `(cos(r) - 1 + z/2) / z^2` in `z = r^2`, to 2^-63.9 of the cosine.
const COS: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_333_8,
    2.480_158_728_899_747_5e-5,
    -2.755_731_421_529_469_3e-7,
    2.087_570_510_411_05e-9,
    -1.135_873_271_080_930_4e-11,
];

/// Sine and cosine of `x` (rad).
#[inline(always)]
pub(crate) fn sin_cos<W: Word<Float = f64>>(x: W) -> (W, W) {
    let (quadrant, n) = quarter_turns(x);
    let (hi, lo) = reduce(x, n);
    select(quadrant, sin(hi, lo), cos(hi, lo))
}

/// The integer nearest to `2x/π`: in the low two bits, mod 4, and as a number; the argument is clamped so that nothing below can
/// overflow.
#[inline(always)]
fn quarter_turns<W: Word<Float = f64>>(x: W) -> (W, W) {
    let round = W::from(ROUND);
    let shifted = x.cut(CUT) * TWO_OVER_PI.into() + round;
    (shifted, shifted - round)
}

/// `x - n π/2` as the sum of two numbers, the second below half an ulp of the first.
#[inline(always)]
fn reduce<W: Word<Float = f64>>(x: W, n: W) -> (W, W) {
    let half_pi = |part: usize| W::from(HALF_PI[part]);
    // The first difference is exact; the second loses `rest`.
    let first = x.cut(CUT) - n * half_pi(0);
    let w = n * half_pi(1);
    let second = first - w;
    let rest = (first - second) - w;
    let w = n * half_pi(2);
    let hi = second - w;
    // `0 x` is 0, or NaN where x is not finite: it undoes the cut of an infinity.
    let lo = ((second - hi) - w) + rest + W::from(0.0) * x;
    (hi, lo)
}

/// `sin(hi + lo)` for `|hi| <= π/4`.
#[inline(always)]
fn sin<W: Word<Float = f64>>(hi: W, lo: W) -> W {
    let k = |power: usize| W::from(SIN[power]);
    let z = hi * hi;
    let (zz, cube) = (z * z, z * hi);
    let p = z * (k(1) + z * k(2)) + z * zz * ((k(3) + z * k(4)) + zz * k(5));
    hi - (((z * (W::from(0.5) * lo) - lo) - cube * k(0)) - cube * p)
}

/// `cos(hi + lo)` for `|hi| <= π/4`.
#[inline(always)]
fn cos<W: Word<Float = f64>>(hi: W, lo: W) -> W {
    let (one, k) = (W::from(1.0), |power: usize| W::from(COS[power]));
    let z = hi * hi;
    let zz = z * z;
    let p = ((k(0) + z * k(1)) + zz * (k(2) + z * k(3))) + zz * zz * (k(4) + z * k(5));
    let half = W::from(0.5) * z;
    let head = one - half;
    head + ((((one - head) - half) - hi * lo) + zz * p)
}
