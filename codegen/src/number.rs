//! What graphs and programs are evaluated in: `f64`, or `f64` with a bound on what rounding has done to it.

use std::ops::{Add, Div, Mul, Neg};

/// A number in which a graph or a program can be evaluated.
pub trait Number:
    Copy + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A constant of the graph.
    fn constant(value: f64) -> Self;
    /// A constant of which folding may have taken digits.
    fn folded(constant: Rounded) -> Self;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// Sine and cosine: the crate libm's, so that they are the same on every machine.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);
    /// `self factor + term`, rounded once.
    #[must_use]
    fn mul_add(self, factor: Self, term: Self) -> Self;
}

impl Number for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn folded(constant: Rounded) -> Self {
        constant.value
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn sin_cos(self) -> (Self, Self) {
        (libm::sin(self), libm::cos(self))
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        libm::fma(self, factor, term)
    }
}

/// A number that was computed, and how far it may be from the exact one: to first order, by running error analysis
/// [Higham 2002, section 3.3].
///
/// Unlike a bound by the number of operations it grows with the cancellation that takes place, and with the condition of
/// what is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounded {
    /// As computed.
    pub value: f64,
    /// The most that rounding can have changed, not negative.
    pub error: f64,
}

/// What rounding takes of a number, at most.
const UNIT: f64 = f64::EPSILON / 2.0;

impl Rounded {
    /// A number that is given.
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// A result that was rounded, of operands that were off by so much.
    fn new(value: f64, inherited: f64) -> Self {
        Self {
            value,
            error: inherited + UNIT * value.abs(),
        }
    }
}

impl Number for Rounded {
    /// Constants were folded.
    fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    fn folded(constant: Rounded) -> Self {
        constant
    }

    fn abs(self) -> Self {
        Self {
            value: self.value.abs(),
            ..self
        }
    }

    /// Two sines, each right within a unit in the last place, are two roundings apart.
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Number::sin_cos(self.value);
        let of = |value: f64, slope: f64| {
            Self::new(value, self.error * slope.abs() + UNIT * value.abs())
        };
        (of(sin, cos), of(cos, sin))
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}

impl Add for Rounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.error + other.error)
    }
}

impl Mul for Rounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let inherited = self.error * other.value.abs() + other.error * self.value.abs();
        Self::new(self.value * other.value, inherited)
    }
}

impl Div for Rounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inherited = (self.error + quotient.abs() * other.error) / other.value.abs();
        Self::new(quotient, inherited)
    }
}

impl Neg for Rounded {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

/// The least number of one digit that is not below a tolerance.
pub fn one_digit(tolerance: f64) -> f64 {
    let nearest = format!("{tolerance:.0e}");
    let next = |(digit, exponent): (&str, &str)| {
        let digit = digit.parse::<u32>().ok()? + 1;
        format!("{digit}e{exponent}").parse().ok()
    };
    match nearest.parse() {
        Ok(number) if number >= tolerance => number,
        _ => nearest.split_once('e').and_then(next).unwrap_or(tolerance),
    }
}
