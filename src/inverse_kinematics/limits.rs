//! Limits of coordinates, and which speeds lead to them.

use crate::joint::Chart;
use crate::{Real, System, manifold};

/// The limits of the coordinates, rad, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<R, const NQ: usize> {
    /// The lower limits; `-∞` if there is none.
    pub lower: [R; NQ],
    /// The upper limits; `∞` if there is none.
    pub upper: [R; NQ],
}

impl<R: Real + PartialOrd, const NQ: usize> Limits<R, NQ> {
    /// No limits.
    #[must_use]
    pub fn none() -> Self {
        Self {
            lower: [R::from_f64(f64::NEG_INFINITY); NQ],
            upper: [R::from_f64(f64::INFINITY); NQ],
        }
    }

    /// The limits of the model, [`System::LOWER_LIMITS`] and [`System::UPPER_LIMITS`].
    #[must_use]
    pub fn of<S: System<R, Q = [R; NQ]>>() -> Self {
        let mut limits = Self::none();
        for (limit, given) in limits.lower.iter_mut().zip(S::LOWER_LIMITS) {
            *limit = R::from_f64(*given);
        }
        for (limit, given) in limits.upper.iter_mut().zip(S::UPPER_LIMITS) {
            *limit = R::from_f64(*given);
        }
        limits
    }

    /// Brings each coordinate that is beyond a limit back to it.
    pub(super) fn clamp(&self, q: &mut [R; NQ]) {
        for ((q, lower), upper) in q.iter_mut().zip(self.lower).zip(self.upper) {
            if *q < lower {
                *q = lower;
            }
            if *q > upper {
                *q = upper;
            }
        }
    }

    /// Draws every coordinate that has two limits from between them. Of the others it draws angles whose rates are speeds, from a full
    /// turn. Changes `seed` with each draw.
    pub(super) fn draw<S: System<R, Q = [R; NQ]>>(&self, q: &mut [R; NQ], seed: &mut u64) {
        let turns = turns::<R, S, NQ>();
        let ranges = self.lower.into_iter().zip(self.upper).zip(turns);
        for (q, ((lower, upper), turns)) in q.iter_mut().zip(ranges) {
            let part = R::from_f64(uniform(seed));
            let drawn = lower + part * (upper - lower);
            // Neither infinite nor NaN: that is what lacks a limit on one side or both.
            if drawn >= lower && drawn <= upper && upper - lower < R::from_f64(f64::INFINITY) {
                *q = drawn;
            } else if turns {
                let half = R::from_f64(core::f64::consts::PI);
                *q = (part + part - R::from_f64(1.0)) * half;
            }
        }
    }

    /// The limit that coordinate `i` would pass with `value`, if any.
    pub(super) fn passed(&self, i: usize, value: R) -> Option<R> {
        let (lower, upper) = (*self.lower.get(i)?, *self.upper.get(i)?);
        if value < lower {
            Some(lower)
        } else if value > upper {
            Some(upper)
        } else {
            None
        }
    }
}

/// For each speed the coordinate whose rate it is; none for components of angular velocities.
pub(super) fn rated_coordinates<R: Real, S: System<R>, const NU: usize>() -> [Option<usize>; NU] {
    let mut coordinates = [None; NU];
    for (q, u) in manifold::rates::<R, S>() {
        if let Some(place) = coordinates.get_mut(u) {
            *place = Some(q);
        }
    }
    coordinates
}

/// For each coordinate whether it is an angle whose rate is a speed.
fn turns<R: Real, S: System<R>, const NQ: usize>() -> [bool; NQ] {
    let mut turns = [false; NQ];
    let hinges = S::JOINTS
        .iter()
        .filter(|joint| joint.chart == Chart::AngleRates);
    for place in hinges.flat_map(|joint| &joint.q[..3]).flatten() {
        if let Some(own) = turns.get_mut(*place) {
            *own = true;
        }
    }
    turns
}

/// A number from 0 to 1, of Steele, Lea and Flood's `SplitMix64`.
#[expect(clippy::cast_precision_loss, reason = "53 bits are what f64 holds")]
fn uniform(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut bits = *seed;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^= bits >> 31;
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}
