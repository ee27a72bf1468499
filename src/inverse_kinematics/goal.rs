//! [`Goal`]: the desired pose of a frame, and the error from it.

use core::{fmt, marker::PhantomData};

use crate::functions::{Jacobian, Pose};
use crate::{Array, Real, System, rotation, three::square};

use super::equations::Equations;

/// The desired pose of the frame `F`, with its weights.
///
/// `F` is any frame with both [`Pose`] and [`Jacobian`]: one of the types in the generated module's `frames`, or
/// [`Seen`](crate::functions::Seen) for a pose relative to another frame, which then replaces the inertial frame below.
pub struct Goal<R, F> {
    /// Inertial components to components along the frame's axes, row by row, as [`Pose`] writes it.
    pub rotation: [[R; 3]; 3],
    /// The frame's origin from the inertial origin, inertial components, m, as [`Pose`] writes it.
    pub position: [R; 3],
    /// The weight of the squared distance, 1/m²; if it is zero or negative, any position will do. Weights count against one another: all of
    /// them times a number are the same goals. If one is NaN, so is every step, and [`Remaining::weighted`](super::Remaining::weighted).
    pub position_weight: R,
    /// The weight of the squared angle, 1/rad²; if it is zero or negative, any orientation will do.
    pub orientation_weight: R,
    frame: PhantomData<F>,
}

// Derived, these would ask the frame's type for the same.
impl<R: fmt::Debug, F> fmt::Debug for Goal<R, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Goal")
            .field("rotation", &self.rotation)
            .field("position", &self.position)
            .field("position_weight", &self.position_weight)
            .field("orientation_weight", &self.orientation_weight)
            .finish()
    }
}

impl<R: PartialEq, F> PartialEq for Goal<R, F> {
    fn eq(&self, other: &Self) -> bool {
        self.rotation == other.rotation
            && self.position == other.position
            && self.position_weight == other.position_weight
            && self.orientation_weight == other.orientation_weight
    }
}

impl<R: Copy, F> Clone for Goal<R, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Copy, F> Copy for Goal<R, F> {}

impl<R: Real, F> Goal<R, F> {
    /// A position and an orientation: a radian weighs as much as a metre.
    #[must_use]
    pub fn pose(rotation: [[R; 3]; 3], position: [R; 3]) -> Self {
        let one = R::from_f64(1.0);
        Self {
            rotation,
            position,
            position_weight: one,
            orientation_weight: one,
            frame: PhantomData,
        }
    }

    /// A position, with any orientation: for feet, and for points to look at.
    #[must_use]
    pub fn position(position: [R; 3]) -> Self {
        let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
        let rotation = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        Self::pose(rotation, position).weighing(one, zero)
    }

    /// An orientation, at any position: for cameras, and for cups that must not spill.
    #[must_use]
    pub fn orientation(rotation: [[R; 3]; 3]) -> Self {
        let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
        Self::pose(rotation, [zero; 3]).weighing(zero, one)
    }

    /// The same goal with other weights, 1/m² and 1/rad².
    #[must_use]
    pub fn weighing(self, position_weight: R, orientation_weight: R) -> Self {
        Self {
            position_weight,
            orientation_weight,
            ..self
        }
    }
}

/// One or several goals of the system `S`, which has `NU` speeds.
///
/// Implemented for [`Goal`], for arrays of goals, and for tuples of up to six. The goals of a tuple may be of different frames,
/// and tuples of tuples hold more. Not meant to be implemented for other types.
pub trait Goals<R: Real, S: System<R>, const NU: usize> {
    /// Adds the error at `q` to the equations of a step.
    fn add(&self, system: &S, q: &S::Q, equations: &mut Equations<R, NU>);
}

impl<R, F, S, const NU: usize> Goals<R, S, NU> for Goal<R, F>
where
    R: Real + PartialOrd,
    S: Pose<R, F> + Jacobian<R, F> + System<R, U = [R; NU]>,
{
    fn add(&self, system: &S, q: &S::Q, equations: &mut Equations<R, NU>) {
        let zero = R::from_f64(0.0);
        let (mut rotation, mut position) = ([[zero; 3]; 3], [zero; 3]);
        system.pose(q, &mut rotation, &mut position);
        let (mut linear, mut angular) = ([[zero; NU]; 3], [[zero; NU]; 3]);
        system.jacobian(q, &mut linear, &mut angular);

        let way = <[R; 3]>::from_fn(|i| self.position[i] - position[i]);
        let (turn, cosine) = rotation::error_and_cosine(&rotation, &self.rotation);
        // `(4 sin(angle / 4))²`, from `2 sin(angle / 2)`.
        let (one, two) = (R::from_f64(1.0), R::from_f64(2.0));
        // NaN stays, so that it shows.
        let counted = |weight: R| if weight < zero { zero } else { weight };
        let (of_position, of_turn) = (
            counted(self.position_weight),
            counted(self.orientation_weight),
        );
        equations.weigh(of_position, square(way));
        equations.weigh(of_turn, square(turn) * two / (one + cosine));
        let speeds = <S as Jacobian<R, F>>::SPEEDS;
        for i in 0..3 {
            equations.add(&linear[i], way[i], of_position, speeds);
            equations.add(&angular[i], turn[i], of_turn, speeds);
        }
        if of_position != zero {
            equations.remaining.raise_position(&way);
        }
        if of_turn != zero {
            equations.remaining.raise_orientation(&turn);
        }
    }
}

impl<R, S, G, const NU: usize, const N: usize> Goals<R, S, NU> for [G; N]
where
    R: Real,
    S: System<R>,
    G: Goals<R, S, NU>,
{
    fn add(&self, system: &S, q: &S::Q, equations: &mut Equations<R, NU>) {
        for goal in self {
            goal.add(system, q, equations);
        }
    }
}

macro_rules! tuples {
    ($(($($goal:ident . $place:tt),+))+) => {$(
        impl<R, S, $($goal,)+ const NU: usize> Goals<R, S, NU> for ($($goal,)+)
        where
            R: Real,
            S: System<R>,
            $($goal: Goals<R, S, NU>,)+
        {
            fn add(&self, system: &S, q: &S::Q, equations: &mut Equations<R, NU>) {
                $(self.$place.add(system, q, equations);)+
            }
        }
    )+};
}

tuples! {
    (A.0)
    (A.0, B.1)
    (A.0, B.1, C.2)
    (A.0, B.1, C.2, D.3)
    (A.0, B.1, C.2, D.3, E.4)
    (A.0, B.1, C.2, D.3, E.4, F.5)
}
