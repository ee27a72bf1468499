//! [`Lanes`]: vectors of scalars, each of another state, and how they are read from memory and written back.

#[cfg(feature = "wide")]
mod wide;

use crate::Real;

/// A [`Real`] that holds [`Self::LANES`] scalars, each of which has the bits that the scalar alone would have.
///
/// Implemented for `f64` and `f32`, one lane each, and with the feature `wide` for the vectors of that crate, which
/// `kane` re-exports: `f64x2`, `f64x4`, `f64x8`, `f32x4`, `f32x8`, `f32x16`. Of these take what the machine has: eight
/// `f64` or sixteen `f32` with AVX-512, half as many with AVX, a quarter with SSE2 and Neon; larger ones
/// work everywhere and are made of smaller.
///
/// Vectors are compiled for the target of the whole program (`-C target-cpu` or `-C target-feature`), never chosen when
/// it runs.
pub trait Lanes: Real {
    /// The scalar of a lane.
    type Scalar: Real;
    /// How many lanes there are.
    const LANES: usize;

    /// The first values, one a lane; where there are fewer, the last one is repeated, and where there are none, zero.
    fn load(values: &[Self::Scalar]) -> Self;

    /// Writes the first lanes, one a value, as many as there is room for.
    fn store(self, values: &mut [Self::Scalar]);
}

macro_rules! single_lanes {
    ($($scalar:ident),+) => {$(
        impl Lanes for $scalar {
            type Scalar = Self;
            const LANES: usize = 1;

            #[inline]
            fn load(values: &[Self]) -> Self {
                values.first().copied().unwrap_or(0.0)
            }

            #[inline]
            fn store(self, values: &mut [Self]) {
                if let Some(value) = values.first_mut() {
                    *value = self;
                }
            }
        }
    )+};
}

single_lanes!(f64, f32);
