//! Coordinates reached by a direction, and their derivatives.

use super::derivatives::Variable;
use crate::manifold::{TangentMap, q_plus};
use crate::vector::plus;
use crate::{Array, Real, System};

/// Moves coordinates by a direction; quaternions then have length one.
pub(super) fn move_on<R: Real, S: System<R>>(system: &S, q: &mut S::Q, direction: &S::U) {
    *q = q_plus(system, q, direction);
    system.normalize(q);
}

/// The derivatives of the coordinates reached by a direction.
pub(super) struct Reached<R: Real, S: System<R>> {
    pub(super) by_q: TangentMap<R, S>,
    pub(super) by_direction: TangentMap<R, S>,
}

impl<R: Real, S: System<R>> Reached<R, S> {
    pub(super) fn by(direction: &S::U) -> Self {
        let [by_q, by_direction] = TangentMap::of_q_plus(direction);
        Self { by_q, by_direction }
    }

    /// The change reached, from changes of the coordinates before and of the direction.
    pub(super) fn changed(&self, q: &S::U, direction: &S::U) -> S::U {
        plus(&self.by_q.times(q), &self.by_direction.times(direction))
    }

    /// The changes reached, from a variable's changes of the direction, a column for each of its entries, by rows.
    pub(super) fn change_rows<Row: Array<R>, M: Array<Row>>(
        &self,
        variable: Variable,
        directions: &mut M,
    ) {
        self.by_direction.turn_rows(directions);
        if variable == Variable::Q {
            self.by_q.add_to(directions);
        }
    }

    /// Turns a multiplier into those of the coordinates before and of the direction.
    pub(super) fn back(&self, multiplier: &S::U) -> (S::U, S::U) {
        (
            self.by_q.transposed_times(multiplier),
            self.by_direction.transposed_times(multiplier),
        )
    }
}
