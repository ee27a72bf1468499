//! Numbers modulo a prime, in which what cancels is exactly zero: whether an expression is zero whatever its inputs are can be
//! asked of them.
//!
//! A rational function that is not zero everywhere is zero at a drawn point with a probability of its degree over the prime
//! (Schwartz 1980, Zippel 1979). A sine and a cosine are a point of the circle, drawn by their angle.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::{Number, Rounded};

/// The prime `2^61 - 1`.
const PRIME: u64 = (1 << 61) - 1;

/// A number modulo this prime.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field(u64);

impl Field {
    /// Zero.
    pub const ZERO: Self = Self(0);
    /// One.
    pub const ONE: Self = Self(1);

    /// A number drawn by these bits.
    pub fn drawn(bits: u64) -> Self {
        let mut bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self((bits ^ (bits >> 31)) % PRIME)
    }

    /// A number below twice the prime.
    fn below_twice(number: u64) -> Self {
        Self(if number < PRIME {
            number
        } else {
            number - PRIME
        })
    }

    /// Another number, drawn by this one.
    fn other(self) -> Self {
        Self::drawn(self.0)
    }

    /// `2^exponent`, of which 61 is a period.
    fn power_of_two(exponent: i64) -> Self {
        Self(1 << exponent.rem_euclid(61))
    }

    /// The number itself, a whole number times a power of two; zero for what is not finite.
    fn exact(value: f64) -> Self {
        let bits = value.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let (mantissa, exponent) = match exponent {
            0x7ff => return Self::ZERO,
            0 => (fraction, 1),
            normal => (fraction | (1 << 52), normal),
        };
        let exponent = i64::try_from(exponent).expect("eleven bits") - 1075;
        let magnitude = Self(mantissa) * Self::power_of_two(exponent);
        if value.is_sign_negative() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// `1 / self`; zero for zero.
    pub(crate) fn reciprocal(self) -> Self {
        let (mut power, mut square, mut exponent) = (Self::ONE, self, PRIME - 2);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power * square;
            }
            square = square * square;
            exponent >>= 1;
        }
        power
    }

    /// The reciprocal of each, zero for zero, by one reciprocal of the product of all.
    pub(crate) fn reciprocals(all: &[Self]) -> Vec<Self> {
        let mut product = Self::ONE;
        let mut before = Vec::with_capacity(all.len());
        for &one in all {
            before.push(product);
            if one != Self::ZERO {
                product = product * one;
            }
        }
        let mut rest = product.reciprocal();
        let mut reciprocals = vec![Self::ZERO; all.len()];
        for (place, &one) in all.iter().enumerate().rev() {
            if one != Self::ZERO {
                reciprocals[place] = rest * before[place];
                rest = rest * one;
            }
        }
        reciprocals
    }

    /// The smaller of this and its negative, as numbers below the prime, and whether that is the negative.
    pub(crate) fn magnitude(self) -> (u64, bool) {
        let negative = PRIME - self.0;
        if negative < self.0 {
            (negative, true)
        } else {
            (self.0, false)
        }
    }
}

impl Number for Field {
    /// The fraction that was rounded to it, where there is one with a small denominator; zero for what is not finite.
    fn constant(value: f64) -> Self {
        match fraction(value) {
            Some([numerator, denominator]) => Self::exact(numerator) / Self::exact(denominator),
            None => Self::exact(value),
        }
    }

    fn folded(constant: Rounded) -> Self {
        Self::constant(constant.value)
    }

    /// Nothing is positive here: a function of the number like any other.
    fn abs(self) -> Self {
        self.other()
    }

    fn sin_cos(self) -> (Self, Self) {
        let half = self.other();
        let square = half * half;
        let length = (Self::ONE + square).reciprocal();
        ((half + half) * length, (Self::ONE + -square) * length)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}

/// The largest denominator of a number that is taken for a fraction.
const MOST_DENOMINATOR: f64 = 16_777_216.0;

/// How far from a fraction its rounding may be, where a few operations were folded.
const FOLDED: f64 = 16.0 * f64::EPSILON;

/// Numerator and denominator of a fraction, by its expansion into a continued one. Distances of such fractions are larger than
/// rounding.
fn fraction(value: f64) -> Option<[f64; 2]> {
    let magnitude = value.abs();
    if !(1e-6..1e6).contains(&magnitude) {
        return None;
    }
    let ([mut p, mut q], [mut p_before, mut q_before]) = ([1.0, 0.0], [0.0, 1.0]);
    let mut rest = magnitude;
    loop {
        let whole = libm::floor(rest);
        [p, p_before] = [whole * p + p_before, p];
        [q, q_before] = [whole * q + q_before, q];
        if q > MOST_DENOMINATOR {
            return None;
        }
        if (magnitude - p / q).abs() <= FOLDED * magnitude {
            return Some([p.copysign(value), q]);
        }
        rest = 1.0 / (rest - whole);
    }
}

impl Add for Field {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::below_twice(self.0 + other.0)
    }
}

impl Sub for Field {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::below_twice(self.0 + (PRIME - other.0))
    }
}

impl Mul for Field {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // What 2^61 divides counts as one.
        let product = u128::from(self.0) * u128::from(other.0);
        #[expect(clippy::cast_possible_truncation, reason = "each has 61 bits")]
        let (low, high) = (product as u64 & PRIME, (product >> 61) as u64);
        Self::below_twice(low + high)
    }
}

impl Div for Field {
    type Output = Self;

    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "a quotient is a product with the reciprocal"
    )]
    fn div(self, other: Self) -> Self {
        self * other.reciprocal()
    }
}

impl Neg for Field {
    type Output = Self;

    fn neg(self) -> Self {
        Self::below_twice(PRIME - self.0)
    }
}
