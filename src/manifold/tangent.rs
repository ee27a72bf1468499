//! Derivatives of [`q_plus`](super::q_plus) and [`q_minus`](super::q_minus): a square block for each orientation, one or
//! minus one for every other speed.

use core::fmt;

use super::{combined, entry, put, rates, three_rows, turn, turnings};
use crate::three::{Matrix, Vector, times, transposed_times};
use crate::vector::unit;
use crate::{Array, Real, System};

/// A linear map from directions to directions, rad and m along the axes of `u`: a derivative of [`q_plus`](super::q_plus) or
/// [`q_minus`](super::q_minus).
///
/// For speeds that are rates of coordinates it is the identity, or its negative. For each orientation it has a block of three speeds.
pub struct TangentMap<R: Real, S: System<R>> {
    /// The diagonal entry elsewhere.
    diagonal: R,
    /// One block per body.
    blocks: S::Rotations,
}

// Derived, these would ask the system for the same.
impl<R: Real, S: System<R>> fmt::Debug for TangentMap<R, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TangentMap")
            .field("diagonal", &self.diagonal)
            .field("blocks", &self.blocks)
            .finish()
    }
}

impl<R: Real, S: System<R>> Clone for TangentMap<R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real, S: System<R>> Copy for TangentMap<R, S> {}

impl<R: Real, S: System<R>> TangentMap<R, S> {
    fn new(direction: &S::U, diagonal: f64, block: fn(Vector<R>) -> Matrix<R>) -> Self {
        let mut map = Self::diagonal(diagonal);
        for joint in turnings::<R, S>() {
            put(&mut map.blocks, joint.body, block(joint.turn(direction)));
        }
        map
    }

    /// A map with this diagonal entry; its blocks are still to be written.
    fn diagonal(entry: f64) -> Self {
        let diagonal = R::from_f64(entry);
        Self {
            diagonal,
            blocks: S::Rotations::filled([[diagonal; 3]; 3]),
        }
    }

    /// The derivative of `q_plus(q, direction)` by `q`: for an orientation the inverse rotation.
    #[must_use]
    pub fn of_q_plus_by_q(direction: &S::U) -> Self {
        Self::of_q_plus(direction)[0]
    }

    /// The derivative of `q_plus(q, direction)` by `direction`: for an orientation the right Jacobian of SO(3).
    #[must_use]
    pub fn of_q_plus_by_direction(direction: &S::U) -> Self {
        Self::of_q_plus(direction)[1]
    }

    /// The derivatives of `q_plus(q, direction)` by `q` and by `direction`, which share sines.
    pub(crate) fn of_q_plus(direction: &S::U) -> [Self; 2] {
        let [mut by_q, mut by_direction] = [Self::diagonal(1.0); 2];
        for joint in turnings::<R, S>() {
            let [inverse, jacobian] = turn::inverse_and_jacobian(joint.turn(direction));
            put(&mut by_q.blocks, joint.body, inverse);
            put(&mut by_direction.blocks, joint.body, jacobian);
        }
        [by_q, by_direction]
    }

    /// The derivative of `q_minus(q, q_other)` by `q`, if its value is `direction`.
    #[must_use]
    pub fn of_q_minus_by_q(direction: &S::U) -> Self {
        Self::new(direction, -1.0, |d| {
            let back = turn::jacobian_inverse(d.map(|entry| -entry));
            back.map(|row| row.map(|entry| -entry))
        })
    }

    /// The derivative of `q_minus(q, q_other)` by `q_other`, if its value is `direction`.
    #[must_use]
    pub fn of_q_minus_by_q_other(direction: &S::U) -> Self {
        Self::new(direction, 1.0, turn::jacobian_inverse)
    }

    /// The map times a direction.
    #[must_use]
    pub fn times(&self, direction: &S::U) -> S::U {
        self.mapped(direction, times)
    }

    /// The transposed map times a multiplier: `a · map(b) = transposed(a) · b`.
    #[must_use]
    pub fn transposed_times(&self, multiplier: &S::U) -> S::U {
        self.mapped(multiplier, transposed_times)
    }

    fn mapped(&self, given: &S::U, times: fn(&Matrix<R>, Vector<R>) -> Vector<R>) -> S::U {
        let mut mapped = *given;
        for entry in mapped.as_mut() {
            *entry = self.diagonal * *entry;
        }
        for joint in turnings::<R, S>() {
            if let Some(block) = self.blocks.as_ref().get(joint.body) {
                joint.set(&mut mapped, times(block, joint.turn(given)));
            }
        }
        mapped
    }

    /// The map times a matrix with a row per speed, for a map that leaves all other speeds as they are.
    pub(crate) fn turn_rows<Row: Array<R>, M: Array<Row>>(&self, matrix: &mut M) {
        for joint in turnings::<R, S>() {
            let Some(block) = self.blocks.as_ref().get(joint.body) else {
                continue;
            };
            let rows = three_rows(matrix, joint.u);
            for (place, factors) in joint.u.into_iter().zip(block) {
                if let Some(row) = matrix.as_mut().get_mut(place) {
                    *row = combined(&rows, *factors);
                }
            }
        }
    }

    /// A matrix with a column per speed times the map, for a map that leaves all other speeds as they are.
    pub(crate) fn turn_columns<Row: Array<R>, M: Array<Row>>(&self, matrix: &mut M) {
        for joint in turnings::<R, S>() {
            if let Some(block) = self.blocks.as_ref().get(joint.body) {
                for row in matrix.as_mut() {
                    let turned = transposed_times(block, joint.u.map(|place| entry(row, place)));
                    for (place, own) in joint.u.into_iter().zip(turned) {
                        put(row, place, own);
                    }
                }
            }
        }
    }

    /// Adds the map to a matrix, `[[R; NU]; NU]`, row by row.
    pub(crate) fn add_to<Row: Array<R>, M: Array<Row>>(&self, matrix: &mut M) {
        let add = |row: &mut Row, column, own| put(row, column, entry(row, column) + own);
        rates::<R, S>().for_each(|(_, speed)| {
            if let Some(row) = matrix.as_mut().get_mut(speed) {
                add(row, speed, self.diagonal);
            }
        });
        for joint in turnings::<R, S>() {
            let Some(block) = self.blocks.as_ref().get(joint.body) else {
                continue;
            };
            for (place, own) in joint.u.into_iter().zip(block) {
                if let Some(row) = matrix.as_mut().get_mut(place) {
                    for (column, own) in joint.u.into_iter().zip(own) {
                        add(row, column, *own);
                    }
                }
            }
        }
    }

    /// The map as a matrix, `[[R; NU]; NU]`, row by row.
    #[must_use]
    pub fn matrix<M: Array<S::U>>(&self) -> M {
        M::from_fn(|row| self.transposed_times(&unit(row)))
    }
}
