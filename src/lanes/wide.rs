//! The vectors of the crate `wide`: as scalars, as lanes, and for the sines.
//!
//! Everything is inlined: a call passes vectors in memory, and costs more than most functions here.
//! If the target has no instruction for a vector, `wide` uses smaller ones, down to scalars: the bits are the same.

use wide::bytemuck::cast;
use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8, i32x4, i32x8, i32x16, i64x2, i64x4, i64x8};

use super::Lanes;
use crate::Real;
use crate::real::FUSED;
use crate::sin_cos::{Word, sin_cos_f32, sin_cos_f64};

macro_rules! lanes {
    ($($lanes:ident: [$scalar:ident; $n:literal], $bits:ident, $sin_cos:ident;)+) => {$(
        impl Real for $lanes {
            #[inline(always)]
            fn from_f64(number: f64) -> Self {
                Self::splat(<$scalar as Real>::from_f64(number))
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                // `wide` would fuse without the feature `std` too, where scalars do not.
                if FUSED { self.mul_add(a, b) } else { self * a + b }
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
        }

        impl Lanes for $lanes {
            type Scalar = $scalar;
            const LANES: usize = $n;

            #[inline(always)]
            fn load(values: &[$scalar]) -> Self {
                if let Some(values) = values.first_chunk() {
                    return Self::new(*values);
                }
                let mut lanes = [values.last().copied().unwrap_or(0.0); $n];
                for (lane, value) in lanes.iter_mut().zip(values) {
                    *lane = *value;
                }
                Self::new(lanes)
            }

            #[inline(always)]
            fn store(self, values: &mut [$scalar]) {
                let lanes = self.to_array();
                if let Some(values) = values.first_chunk_mut() {
                    *values = lanes;
                } else {
                    for (value, lane) in values.iter_mut().zip(lanes) {
                        *value = lane;
                    }
                }
            }
        }

        impl Word for $lanes {
            type Float = $scalar;
            type Bits = $bits;
            const ONE: $bits = $bits::ONE;
            const TWO: $bits = $bits::splat(2);
            const SHIFT: u32 = <$scalar as Word>::SHIFT;

            #[inline(always)]
            fn cut(self, limit: $scalar) -> Self {
                self.fast_max(Self::splat(-limit)).fast_min(Self::splat(limit))
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                cast(self)
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                cast(bits)
            }
        }
    )+};
}

lanes! {
    f64x2: [f64; 2], i64x2, sin_cos_f64;
    f64x4: [f64; 4], i64x4, sin_cos_f64;
    f64x8: [f64; 8], i64x8, sin_cos_f64;
    f32x4: [f32; 4], i32x4, sin_cos_f32;
    f32x8: [f32; 8], i32x8, sin_cos_f32;
    f32x16: [f32; 16], i32x16, sin_cos_f32;
}
