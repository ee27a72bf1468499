//! What is known of a value at drawn points.

use super::made::Operation;
use crate::{
    drawn::Field,
    expr::{Expr, signed},
    number::Number,
    random::Random,
};

/// At how many points values are known without rounding.
const EXACT_POINTS: usize = 2;

/// At how many points the sizes are known.
const POINTS: usize = 32;

/// A number at each of these.
type Numbers = [f64; POINTS];

/// By how much the sizes of equal terms may differ, by rounding.
const SAME_SIZE: f64 = 1.0 + 1e-9;

/// The exponent that the bits of 1 have.
const ZERO_EXPONENT: usize = 1023;

/// Powers of two by which inputs are scaled at all points but the first, so that no term is small beside others at all of them. So are
/// tangents of angles: at half of the points the cosine is small beside the sine.
const POWERS: usize = 16;

/// What is evaluated.
pub(super) trait Evaluated: Copy {
    /// Where what is drawn comes from.
    type Source;

    fn source() -> Self::Source;

    /// That of an input.
    fn drawn(source: &mut Self::Source) -> Self;

    /// That of a number that any other might stand for.
    fn drawn_number(source: &mut Self::Source) -> Self;

    /// That of a number which is what it is.
    fn number(number: f64) -> Self;

    /// That of what refers to the value.
    fn signed(&self, expr: Expr) -> Self;

    fn of(operation: Operation, a: &Self, b: &Self) -> Self;

    fn reciprocal(&self) -> Self;

    /// The sine and the cosine of an angle: their squares add up to one. A sum of angles is an angle like any other.
    fn on_circle(&self) -> [Self; 2];
}

/// The value modulo a prime, for all inputs drawn from all such numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Exact([Field; EXACT_POINTS]);

impl Exact {
    pub(super) fn first(self) -> Field {
        self.0[0]
    }
}

impl Evaluated for Exact {
    /// How many were drawn.
    type Source = u64;

    fn source() -> u64 {
        0
    }

    fn drawn(n_drawn: &mut u64) -> Self {
        Self([(); EXACT_POINTS].map(|()| {
            *n_drawn += 1;
            Field::drawn(*n_drawn)
        }))
    }

    fn drawn_number(n_drawn: &mut u64) -> Self {
        Self::drawn(n_drawn)
    }

    fn number(number: f64) -> Self {
        Self([Field::constant(number); EXACT_POINTS])
    }

    fn signed(&self, expr: Expr) -> Self {
        let Self([first, second]) = *self;
        Self([signed(expr, first), signed(expr, second)])
    }

    fn of(operation: Operation, a: &Self, b: &Self) -> Self {
        let (Self([a, c]), Self([b, d])) = (*a, *b);
        Self([operation.of(a, b), operation.of(c, d)])
    }

    fn reciprocal(&self) -> Self {
        Self(self.0.map(Field::reciprocal))
    }

    fn on_circle(&self) -> [Self; 2] {
        let both = self.0.map(Number::sin_cos);
        [
            Self(both.map(|(sine, _)| sine)),
            Self(both.map(|(_, cosine)| cosine)),
        ]
    }
}

/// How large its terms are, for inputs of a size that inputs have.
#[derive(Clone, Copy)]
pub(super) struct Sized {
    real: Numbers,
    /// The sum of the magnitudes of the terms: rounding takes that part of it.
    size: Numbers,
}

impl Sized {
    /// True if it has no terms that the other one has not.
    pub(super) fn is_within(&self, other: &Self) -> bool {
        let mut sizes = self.size.iter().zip(other.size);
        sizes.all(|(own, other)| *own <= SAME_SIZE * other)
    }

    fn whole(real: Numbers) -> Self {
        let size = real.map(f64::abs);
        Self { real, size }
    }
}

impl Evaluated for Sized {
    type Source = Random;

    fn source() -> Random {
        Random::new(1)
    }

    fn drawn(random: &mut Random) -> Self {
        Self::whole(std::array::from_fn(|point| {
            let number = random.number();
            if point == 0 {
                return number;
            }
            let power = random.below(2 * POWERS + 1);
            let exponent = ZERO_EXPONENT - POWERS + power;
            number * f64::from_bits((exponent as u64) << (f64::MANTISSA_DIGITS - 1))
        }))
    }

    fn drawn_number(random: &mut Random) -> Self {
        Self::whole(Self::drawn(random).size)
    }

    fn number(number: f64) -> Self {
        Self::whole([number; POINTS])
    }

    fn signed(&self, expr: Expr) -> Self {
        Self {
            real: self.real.map(|one| signed(expr, one)),
            ..*self
        }
    }

    fn of(operation: Operation, a: &Self, b: &Self) -> Self {
        let both = |a: &Numbers, b: &Numbers| -> Numbers {
            std::array::from_fn(|point| operation.of(a[point], b[point]))
        };
        Self {
            real: both(&a.real, &b.real),
            size: both(&a.size, &b.size),
        }
    }

    fn reciprocal(&self) -> Self {
        let of_size = |point: usize| self.size[point] / (self.real[point] * self.real[point]);
        Self {
            real: self.real.map(|one| 1.0 / one),
            size: std::array::from_fn(of_size),
        }
    }

    fn on_circle(&self) -> [Self; 2] {
        let secants = self.real.map(|tangent| (1.0 + tangent * tangent).sqrt());
        let sines = std::array::from_fn(|point| self.real[point] / secants[point]);
        [Self::whole(sines), Self::whole(secants.map(f64::recip))]
    }
}
