//! Coordinates reached by a direction, and their derivatives.

use crate::manifold::{TangentMap, q_plus};
use crate::vector::plus;
use crate::{Real, System};

/// Moves coordinates by a direction; quaternions then have length one.
pub(super) fn move_on<R: Real, S: System<R>>(system: &S, q: &mut S::Q, direction: &S::U) {
    *q = q_plus(system, q, direction);
    system.normalize(q);
}

/// The derivatives of the coordinates reached by a direction.
pub(super) struct Reached<R: Real, S: System<R>> {
    by_q: TangentMap<R, S>,
    by_direction: TangentMap<R, S>,
}

impl<R: Real, S: System<R>> Reached<R, S> {
    pub(super) fn by(direction: &S::U) -> Self {
        Self {
            by_q: TangentMap::of_q_plus_by_q(direction),
            by_direction: TangentMap::of_q_plus_by_direction(direction),
        }
    }

    /// The change reached, from changes of the coordinates before and of the direction.
    pub(super) fn changed(&self, q: &S::U, direction: &S::U) -> S::U {
        plus(&self.by_q.times(q), &self.by_direction.times(direction))
    }

    /// Turns a multiplier into those of the coordinates before and of the direction.
    pub(super) fn back(&self, multiplier: &S::U) -> (S::U, S::U) {
        (
            self.by_q.transposed_times(multiplier),
            self.by_direction.transposed_times(multiplier),
        )
    }
}
