//! [`Real`]: the scalar of generated code, and the only functions that it calls.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::sin_cos;

/// A scalar of the generated functions: a real number, or several side by side as lanes.
///
/// Implemented for `f64` and `f32`, with this crate's own sine and cosine, which give the same bits on every
/// IEEE-754 machine. To use other sines, implement the trait for a newtype.
///
/// ```
/// use core::ops::{Add, Div, Mul, Neg, Sub};
/// use kane::Real;
///
/// /// `f64` with the platform's sines.
/// #[derive(Clone, Copy, Debug)]
/// struct Platform(f64);
///
/// # impl Add for Platform { type Output = Self; fn add(self, o: Self) -> Self { Self(self.0 + o.0) } }
/// # impl Sub for Platform { type Output = Self; fn sub(self, o: Self) -> Self { Self(self.0 - o.0) } }
/// # impl Mul for Platform { type Output = Self; fn mul(self, o: Self) -> Self { Self(self.0 * o.0) } }
/// # impl Div for Platform { type Output = Self; fn div(self, o: Self) -> Self { Self(self.0 / o.0) } }
/// # impl Neg for Platform { type Output = Self; fn neg(self) -> Self { Self(-self.0) } }
/// // Add, Sub, Mul, Div and Neg likewise, then:
/// impl Real for Platform {
///     fn from_f64(number: f64) -> Self {
///         Self(number)
///     }
///     fn abs(self) -> Self {
///         Self(self.0.abs())
///     }
///     fn sin_cos(self) -> (Self, Self) {
///         let (sine, cosine) = self.0.sin_cos();
///         (Self(sine), Self(cosine))
///     }
/// }
/// assert_eq!(Platform::sin_cos_array([Platform(0.0)]).1[0].0, 1.0);
/// ```
pub trait Real:
    Copy
    + Debug
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The value nearest to `number`, in every lane.
    fn from_f64(number: f64) -> Self;

    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// `self * a + b`: called only by code generated with fused multiply-add.
    ///
    /// Rounded once if the crate has the feature `std` and its target has the instruction (x86 with the target feature
    /// `fma`, 64-bit Arm); otherwise rounded twice, never emulated in software. So the bits depend on the target,
    /// except if the product is exact. All scalars and lanes of one program round alike.
    #[must_use]
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// Sine and cosine of an angle in rad.
    ///
    /// The error is below 0.85 ulp for `f64` and below 0.8 ulp for `f32`, for `|x| <= 10000`. Far beyond that, from `2^30` in `f64` and from `2^16` in `f32`,
    /// the results are meaningless: keep the angles of wheels small. They are in [-1, 1] for finite arguments, and NaN for others.
    /// No branch, no call, no fused multiply-add.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// Sines and cosines of several angles in rad, with the bits of [`Self::sin_cos`] lane by lane.
    ///
    /// If [`Self::sin_cos`] has no branches, this vectorises over the angles.
    #[must_use]
    #[inline]
    fn sin_cos_array<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        sin_cos::each(angles, Self::sin_cos)
    }
}

/// True if the target has a fused multiply-add instruction. `core` alone does not have the operation.
#[cfg(any(feature = "std", feature = "wide"))]
pub(crate) const FUSED: bool = cfg!(all(
    feature = "std",
    any(
        target_feature = "fma",
        all(target_arch = "aarch64", target_feature = "neon")
    )
));

macro_rules! scalars {
    ($($scalar:ident: $sin_cos:ident;)+) => {$(
        impl Real for $scalar {
            #[inline]
            #[allow(
                clippy::cast_possible_truncation,
                reason = "rounding to the nearest f32 is what is asked for"
            )]
            fn from_f64(number: f64) -> Self {
                number as Self
            }

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }

            #[cfg(feature = "std")]
            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                if FUSED {
                    Self::mul_add(self, a, b)
                } else {
                    self * a + b
                }
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                sin_cos::$sin_cos(self)
            }

            // A call would copy its results by `memcpy`.
            #[inline(always)]
            fn sin_cos_array<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                sin_cos::scalars(angles, sin_cos::$sin_cos)
            }
        }
    )+};
}

scalars! {
    f64: sin_cos_f64;
    f32: sin_cos_f32;
}
