//! The operations of a scalar that the sines need: arithmetic, and its bits.

#![expect(
    clippy::inline_always,
    reason = "the lanes of an array become vectors only where nothing is left to call"
)]

use core::ops::{Add, BitAnd, BitXor, Mul, Shl, Sub};

/// A float or several side by side, and integers of the same size for operations on its bits.
///
/// Every operation follows IEEE 754, lane by lane, so that all words give the same bits.
pub(crate) trait Word:
    Copy + From<Self::Float> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The float; as a word it is in every lane.
    type Float;
    /// The same number of bits, as two's complement integers.
    type Bits: Copy
        + Default
        + BitAnd<Output = Self::Bits>
        + BitXor<Output = Self::Bits>
        + Sub<Output = Self::Bits>
        + Shl<u32, Output = Self::Bits>;
    /// 1 in every lane.
    const ONE: Self::Bits;
    /// 2 in every lane.
    const TWO: Self::Bits;
    /// The shift that moves the 2 to the sign bit.
    const SHIFT: u32;

    /// Clamps to `-limit` and `limit`; anything for NaN.
    fn cut(self, limit: Self::Float) -> Self;
    /// The bits.
    fn to_bits(self) -> Self::Bits;
    /// From the bits.
    fn from_bits(bits: Self::Bits) -> Self;
}

/// The pair of the full angle from that of the reduced one; `quadrant` holds the number of right angles between them in
/// its low two bits, and is not the least integer, which is the zero that has a sign.
#[inline(always)]
pub(super) fn select<W: Word>(quadrant: W, sin: W, cos: W) -> (W, W) {
    let (quadrant, s, c) = (quadrant.to_bits(), sin.to_bits(), cos.to_bits());
    let zero = W::Bits::default();
    let swap = (s ^ c) & (zero - (quadrant & W::ONE));
    // Two and three right angles turn the sine's sign, one and two the cosine's.
    let sin_sign = (quadrant & W::TWO) << W::SHIFT;
    let cos_sign = ((zero - quadrant) & W::TWO) << W::SHIFT;
    (
        W::from_bits(s ^ swap ^ sin_sign),
        W::from_bits(c ^ swap ^ cos_sign),
    )
}

macro_rules! words {
    ($($float:ident: $bits:ident),+) => {$(
        impl Word for $float {
            type Float = Self;
            type Bits = $bits;
            const ONE: $bits = 1;
            const TWO: $bits = 2;
            const SHIFT: u32 = $bits::BITS - 2;

            // Not `clamp`: of its comparisons the optimizer packs some with those of other lanes, and makes jumps of what
            // is left of them, where SSE2 is all there is.
            #[inline(always)]
            fn cut(self, limit: Self) -> Self {
                self.max(-limit).min(limit)
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                self.to_bits().cast_signed()
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                Self::from_bits(bits.cast_unsigned())
            }
        }
    )+};
}

words!(f64: i64, f32: i32);
