//! [`Lanes`]: vectors of scalars, one state per lane, with their loads and stores.

#[cfg(feature = "wide")]
mod wide;

use crate::Real;

/// A [`Real`] that holds [`Self::LANES`] scalars, each with the bits that it would have alone.
///
/// Implemented for `f64` and `f32`, one lane each, and with the feature `wide` for the vectors of that crate, which
/// `kane` re-exports: `f64x2`, `f64x4`, `f64x8`, `f32x4`, `f32x8`, `f32x16`. Take the widest that the machine has: eight
/// `f64` or sixteen `f32` with AVX-512, half as many with AVX, a quarter with SSE2 and Neon. Wider ones
/// work everywhere, composed of narrower ones.
///
/// Vectors are compiled for the target of the whole program (`-C target-cpu` or `-C target-feature`), never selected at run
/// time.
pub trait Lanes: Real {
    /// The scalar of a lane.
    type Scalar: Real;
    /// The number of lanes.
    const LANES: usize;

    /// Loads the first values, one per lane; if there are fewer, repeats the last one, and if there are none, loads zeros.
    fn load(values: &[Self::Scalar]) -> Self;

    /// Stores the first lanes, as many as `values` has room for.
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
