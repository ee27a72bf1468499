//! Sine and cosine without a branch, a call or a fused multiply-add.
//!
//! In: an angle in rad. Out: both functions, the same bits on every IEEE-754 machine.
//!
//! | | range of the stated error | error | beyond it |
//! | --- | --- | --- | --- |
//! | `f64` | `abs(x) < 2^14` (16384) | below 0.85 ulp | up to `2^30`: as for an angle half an ulp of `x` away; above: meaningless |
//! | `f32` | `abs(x) <= 10000` | below 0.8 ulp | up to `2^16`: as for an angle half an ulp of `x` away; above: meaningless |
//!
//! For any finite argument both results lie in [-1, 1]; infinities and NaN give NaN; `sin(-0) = -0`. The sine is
//! exactly odd, the cosine exactly even. `tests/runtime/real` tests the bounds; the largest errors found are
//! 0.806 ulp for `f64`, in a search of 8e8 angles, and 0.783 ulp of all `f32` in range.
//!
//! With `n` the nearest integer to `2x/π`, the angle is reduced to `r = x - n π/2`, `|r| <= π/4`, in several
//! parts of `π/2`, all but the last so short that `n` times it is exact (Cody & Waite 1980); `r` is carried as a sum
//! `hi + lo`. Both polynomials are evaluated, and `n mod 4` chooses between them and sets the signs by bit
//! operations. The polynomials are minimax in relative error on [0, π/4], each coefficient rounded before
//! the next was fitted. Their terms are added in pairs (Estrin 1960), which takes half the time of Horner's chain.
//!
//! Everything is written once for a [`Word`](word::Word): a scalar, or lanes of it.

mod double;
mod lanes;
mod single;
mod word;

pub(crate) use double::sin_cos as sin_cos_f64;
pub(crate) use lanes::{each, scalars};
pub(crate) use single::sin_cos as sin_cos_f32;
#[cfg(feature = "wide")]
pub(crate) use word::Word;
