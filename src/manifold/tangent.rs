//! Derivatives of [`q_plus`](super::q_plus) and [`q_minus`](super::q_minus): a square block for each orientation, one or
//! minus one for every other speed.

use super::turn::{self, Matrix, Vector};
use super::turnings;
use crate::vector::unit;
use crate::{Array, Real, System};

/// A linear map from directions to directions, rad and m along the axes of `u`: a derivative of [`q_plus`](super::q_plus) or
/// [`q_minus`](super::q_minus).
///
/// For speeds that are rates of coordinates it is the identity, or its negative. For each orientation it has a block of three speeds.
#[derive(Debug)]
pub struct TangentMap<R: Real, S: System<R>> {
    /// The diagonal entry elsewhere.
    diagonal: R,
    /// One block per body.
    blocks: S::Rotations,
}

// Derived, these would ask the system for the same.
impl<R: Real, S: System<R>> Clone for TangentMap<R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real, S: System<R>> Copy for TangentMap<R, S> {}

impl<R: Real, S: System<R>> TangentMap<R, S> {
    fn new(direction: &S::U, diagonal: f64, block: fn(Vector<R>) -> Matrix<R>) -> Self {
        let diagonal = R::from_f64(diagonal);
        let mut blocks = S::Rotations::filled([[diagonal; 3]; 3]);
        for joint in turnings::<R, S>() {
            if let Some(own) = blocks.as_mut().get_mut(joint.body) {
                *own = block(joint.turn(direction));
            }
        }
        Self { diagonal, blocks }
    }

    /// The derivative of `q_plus(q, direction)` by `q`: for an orientation the inverse rotation.
    #[must_use]
    pub fn of_q_plus_by_q(direction: &S::U) -> Self {
        Self::new(direction, 1.0, turn::matrix_of_inverse)
    }

    /// The derivative of `q_plus(q, direction)` by `direction`: for an orientation the right Jacobian of SO(3).
    #[must_use]
    pub fn of_q_plus_by_direction(direction: &S::U) -> Self {
        Self::new(direction, 1.0, turn::jacobian)
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
        self.mapped(direction, turn::times)
    }

    /// The transposed map times a multiplier: `a · map(b) = transposed(a) · b`.
    #[must_use]
    pub fn transposed_times(&self, multiplier: &S::U) -> S::U {
        self.mapped(multiplier, turn::transposed_times)
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

    /// The map as a matrix, `[[R; NU]; NU]`, row by row.
    #[must_use]
    pub fn matrix<M: Array<S::U>>(&self) -> M {
        M::from_fn(|row| self.transposed_times(&unit(row)))
    }
}
