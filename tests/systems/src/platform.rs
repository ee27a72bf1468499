//! [`Libm`]: `f64` with the sines of the crate libm.

use core::ops::{Add, Div, Mul, Neg, Sub};

use kane::Real;

/// `f64` with the sines of the crate libm, which are those of the generator's own evaluation.
///
/// What else differs between compiled text and that evaluation is a fault of emission.
#[derive(Clone, Copy, Debug)]
pub struct Libm(pub f64);

macro_rules! operator {
    ($($name:ident $method:ident;)+) => {$(
        impl $name for Libm {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self($name::$method(self.0, other.0))
            }
        }
    )+};
}

operator! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl Neg for Libm {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Libm {
    fn from_f64(number: f64) -> Self {
        Self(number)
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn sin_cos(self) -> (Self, Self) {
        (Self(libm::sin(self.0)), Self(libm::cos(self.0)))
    }
}

impl From<Libm> for f64 {
    fn from(number: Libm) -> Self {
        number.0
    }
}
