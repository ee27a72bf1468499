//! Inverse kinematics: coordinates that bring frames to their goals.
//!
//! A solver takes [`Goal`]s of one or several frames, [`Limits`], and an initial `q`. It improves `q`, and returns as [`Remaining`] its error
//! from the goals. No coordinate passes its limits. Nothing allocates, and with generated systems nothing panics. The feature `std` is not needed.
//! The solver does not avoid collisions, and it does not find every solution.
//!
//! The method is damped least squares (Levenberg, Marquardt). A step is the `u`, for unit time, that minimizes
//! `(J u - e)ᵀ W (J u - e) + λ |u|²`. `e` is the error, `W` holds the weights, and the damping `λ` falls with [`Remaining::weighted`].
//! So steps are short if the goals are far or out of reach, and near the goals each step squares the error. A joint that would
//! pass its limit is held at it, and the step is computed again for the other joints.
//!
//! ```
//! use kane::functions::{Jacobian, Pose};
//! use kane::inverse_kinematics::{Goal, InverseKinematics, Limits, Remaining};
//! use kane::System;
//!
//! /// Moves the frame `F` of any robot to a position, as nearly as it can.
//! fn reach<F, S, const NQ: usize, const NU: usize>(
//!     robot: &S,
//!     position: [f64; 3],
//!     q: &mut [f64; NQ],
//! ) -> Remaining<f64>
//! where
//!     S: Pose<f64, F> + Jacobian<f64, F> + System<f64, Q = [f64; NQ], U = [f64; NU]>,
//! {
//!     let solver = InverseKinematics::new(Limits::of::<S>());
//!     solver.solve(robot, &Goal::<f64, F>::position(position), q, 100)
//! }
//! ```
//! With a generated module, `(Goal::<f64, frames::LeftFoot>::position(..), Goal::<f64, frames::Hand>::pose(..))` sets goals for two frames together.

mod equations;

mod goal;
mod limits;

pub use equations::{Equations, Remaining};
pub use goal::{Goal, Goals};
pub use limits::Limits;

use crate::{Real, System, manifold};
use limits::rated_coordinates;

/// The number of rounds, in one step, that hold joints at their limits and solve for the others again.
const ROUNDS: usize = 8;

/// The least `f` in the damping `λ = f w`, where `w` is [`Remaining::weighted`]: a step is at most `1 / √(2 f)` long, two radians:
/// farther away the Jacobian says nothing.
const LEAST_FACTOR: f64 = 0.125;

/// A solver for a system with `NQ` coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InverseKinematics<R, const NQ: usize> {
    /// The limits of the coordinates.
    pub limits: Limits<R, NQ>,
    /// [`Self::solve`] ends if no component of the error exceeds this, m and rad. Default 1e-6, 1e-5 in single precision.
    pub tolerance: R,
    /// The minimum damping, which remains at the goal, as a part of the greatest diagonal entry of `Jᵀ W J`. It bounds steps where the
    /// Jacobian is singular, and must be far above rounding. Default 1e-12, 1e-4 in single precision.
    pub least_damping: R,
}

/// A step, and the error before it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use = "a step moves nothing"]
pub struct Step<R, const NU: usize> {
    /// The speeds that lead as near to the goals as possible in unit time: rad and m.
    /// Divided by a time they are speeds for a controller.
    pub u: [R; NU],
    /// The error before the step.
    pub remaining: Remaining<R>,
}

impl<R: Real + PartialOrd, const NQ: usize> InverseKinematics<R, NQ> {
    /// A solver that respects the limits.
    #[must_use]
    pub fn new(limits: Limits<R, NQ>) -> Self {
        // In single precision the sum is one.
        let is_double = R::from_f64(1.0 + 1e-9) > R::from_f64(1.0);
        let (tolerance, least_damping) = if is_double {
            (1e-6, 1e-12)
        } else {
            (1e-5, 1e-4)
        };
        Self {
            limits,
            tolerance: R::from_f64(tolerance),
            least_damping: R::from_f64(least_damping),
        }
    }

    /// One step from `q`, for control loops.
    ///
    /// The damping `λ` is [`Remaining::weighted`] plus the least damping. So unless a limit is met, `|u|`, the root of a sum of squared rad and m,
    /// is at most `1 / √2`, and toward goals that are far away it is shorter the farther they are. Divided by a short period, `u` can exceed
    /// the speeds of a robot: limit them. A coordinate beyond its limit is led back to it at once, however far.
    ///
    /// `q + u` passes no limit but by rounding; [`Self::advance`] does not even do that.
    pub fn step<S, G, const NU: usize>(&self, system: &S, goals: &G, q: &[R; NQ]) -> Step<R, NU>
    where
        S: System<R, Q = [R; NQ], U = [R; NU]>,
        G: Goals<R, S, NU>,
    {
        let equations = missing(system, goals, q);
        Step {
            u: self.within_limits::<S, NU>(&equations, R::from_f64(1.0), q),
            remaining: equations.remaining,
        }
    }

    /// The coordinates after a step: [`q_plus`](manifold::q_plus), then every coordinate brought back to within its limits.
    /// Quaternions keep their length; [`scale_quaternions`](manifold::scale_quaternions) gives them length one.
    #[must_use]
    pub fn advance<S, const NU: usize>(&self, system: &S, q: &[R; NQ], u: &[R; NU]) -> [R; NQ]
    where
        S: System<R, Q = [R; NQ], U = [R; NU]>,
    {
        let mut next = manifold::q_plus(system, q, u);
        self.limits.clamp(&mut next);
        next
    }

    /// Steps from `q` until the error is within the tolerance, or after `steps` steps; returns the error at the last `q`.
    ///
    /// A step that would increase the error is not taken, but tried again with more damping. So `q`, once it is within its limits,
    /// never becomes worse than at the start. From afar, this may stop where no small step helps; [`Self::search`] then starts
    /// elsewhere. Each step costs a pose and a Jacobian of each goal, and on the order of `NU³ / 6` multiplications.
    ///
    /// A quaternion of four zeros is no orientation: it stays, and the result means nothing.
    pub fn solve<S, G, const NU: usize>(
        &self,
        system: &S,
        goals: &G,
        q: &mut [R; NQ],
        steps: usize,
    ) -> Remaining<R>
    where
        S: System<R, Q = [R; NQ], U = [R; NU]>,
        G: Goals<R, S, NU>,
    {
        let (one, four) = (R::from_f64(1.0), R::from_f64(4.0));
        let (least, greatest) = (R::from_f64(LEAST_FACTOR), R::from_f64(1e6));
        manifold::scale_quaternions(system, q);
        self.limits.clamp(q);
        let mut equations = missing(system, goals, q);
        let mut damping = one;
        for _ in 0..steps {
            if equations.remaining.is_within(self.tolerance) || damping > greatest {
                break;
            }
            let u = self.within_limits::<S, NU>(&equations, damping, q);
            let next = self.advance(system, q, &u);
            let then = missing(system, goals, &next);
            if then.remaining.weighted < equations.remaining.weighted {
                (*q, equations) = (next, then);
                damping = damping / four;
                damping = if damping > least { damping } else { least };
            } else {
                damping = damping * four;
            }
        }
        equations.remaining
    }

    /// Like [`Self::solve`], and if that does not reach the goals, again from other starting points: up to `starts` times in total, at least once,
    /// the first from `q`. `q` becomes the best found.
    ///
    /// Another starting point has each coordinate with two limits at a random value between them. Without them, an angle whose rate is a
    /// speed is random too; translations and orientations with angular velocities start as in `q`. The same call always tries the same
    /// starting points. Of the poses that an arm of six or seven joints can reach, with 100 steps
    /// each, one start finds about half, ten find 99 of a hundred, fifty all of a thousand that were tried.
    pub fn search<S, G, const NU: usize>(
        &self,
        system: &S,
        goals: &G,
        q: &mut [R; NQ],
        steps: usize,
        starts: usize,
    ) -> Remaining<R>
    where
        S: System<R, Q = [R; NQ], U = [R; NU]>,
        G: Goals<R, S, NU>,
    {
        let begin = *q;
        let mut best = self.solve(system, goals, q, steps);
        let mut seed = 0;
        for _ in 1..starts {
            if best.is_within(self.tolerance) {
                break;
            }
            let mut other = begin;
            self.limits.draw::<S>(&mut other, &mut seed);
            if other == begin {
                break;
            }
            let remaining = self.solve(system, goals, &mut other, steps);
            let is_lost = best.weighted.partial_cmp(&best.weighted).is_none();
            if is_lost || remaining.is_within(self.tolerance) || remaining.weighted < best.weighted
            {
                (*q, best) = (other, remaining);
            }
        }
        best
    }

    /// The solution of the equations, with every joint that would pass a limit held at it.
    fn within_limits<S, const NU: usize>(
        &self,
        equations: &Equations<R, NU>,
        damping: R,
        q: &[R; NQ],
    ) -> [R; NU]
    where
        S: System<R, Q = [R; NQ], U = [R; NU]>,
    {
        let coordinates = rated_coordinates::<R, S, NU>();
        let least = self.least_damping * equations.scale();
        let damping = damping * equations.remaining.weighted + least;
        let mut held = [None; NU];
        let mut u = equations.solve(damping, &held);
        for _ in 0..ROUNDS {
            if !self.hold(&coordinates, q, &u, &mut held) {
                return u;
            }
            u = equations.solve(damping, &held);
        }
        // Whatever still passes a limit stops there, and the others go on as if it did not.
        self.hold(&coordinates, q, &u, &mut held);
        for (u, held) in u.iter_mut().zip(held) {
            *u = held.unwrap_or(*u);
        }
        u
    }

    /// Holds all speeds that would lead beyond a limit; true where there is another one.
    fn hold<const NU: usize>(
        &self,
        coordinates: &[Option<usize>; NU],
        q: &[R; NQ],
        u: &[R; NU],
        held: &mut [Option<R>; NU],
    ) -> bool {
        let mut more = false;
        for ((held, &u), coordinate) in held.iter_mut().zip(u).zip(coordinates) {
            if let (None, &Some(place)) = (*held, coordinate)
                && let Some(&q) = q.get(place)
                && let Some(limit) = self.limits.passed(place, q + u)
            {
                *held = Some(limit - q);
                more = true;
            }
        }
        more
    }
}

/// The error at `q`.
fn missing<R, S, G, const NU: usize>(system: &S, goals: &G, q: &S::Q) -> Equations<R, NU>
where
    R: Real,
    S: System<R>,
    G: Goals<R, S, NU>,
{
    let mut equations = Equations::none();
    goals.add(system, q, &mut equations);
    equations
}
