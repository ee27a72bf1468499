//! Simulation to a tolerance, on the host.
//!
//! In: a system, a state, a control law `tau(t, q, u)` and the output times. Out: the states at these times.
//! The integrator is DOP853 (Hairer, Nørsett & Wanner 1993, II.10; the crate
//! `differential-equations`): explicit, order 8 with an error estimate of orders 5 and 3. It steps to each
//! output time exactly and interpolates nothing (the dense output of that crate's version 0.7.0 is of low order), so
//! times closer than its own steps cost a step each. Stiff systems take very many steps, and mostly end as
//! [`SimulateError::MaxSteps`]. At a discontinuity of the control law its steps become tiny: simulate up to it and restart there.

use core::cell::RefCell;
use core::error::Error;
use core::fmt;
use std::vec::Vec;

use differential_equations::error::Error as Failure;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::traits::State;

use crate::functions::ForwardDynamics;
use crate::{Array, System, manifold};

/// Error tolerances and the step limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The local error allowed, relative to the size of each coordinate and speed: a mean over all of them. Default 1e-9.
    pub relative: f64,
    /// The additional absolute local error allowed, rad, m, rad/s, m/s. Default 1e-12.
    pub absolute: f64,
    /// The maximum number of steps, rejected ones included. Default 1,000,000.
    pub max_steps: usize,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self {
            relative: 1e-9,
            absolute: 1e-12,
            max_steps: 1_000_000,
        }
    }
}

/// The state at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<Q, U> {
    /// Time, s.
    pub t: f64,
    /// Generalized coordinates.
    pub q: Q,
    /// Generalized speeds.
    pub u: U,
}

/// What [`simulate`] returns: the state at each of the times.
pub type Samples<S> = Vec<Sample<<S as System<f64>>::Q, <S as System<f64>>::U>>;

/// Why a simulation failed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SimulateError {
    /// The times do not increase, or one of them is not finite.
    Times {
        /// Index of the first time that is not greater than the one before it, or not finite.
        index: usize,
        /// That time, s.
        t: f64,
    },
    /// A tolerance is not positive and finite.
    Tolerance {
        /// [`Tolerance::relative`].
        relative: f64,
        /// [`Tolerance::absolute`].
        absolute: f64,
    },
    /// The initial state is not finite, the control law or the forward dynamics there is not, or a state that a step reaches.
    NotFinite {
        /// The time, s.
        t: f64,
    },
    /// The step became too small for the tolerance: near a singularity, where the control law jumps, or where it ceases to be finite.
    StepSize {
        /// The time reached, s.
        t: f64,
    },
    /// The maximum number of steps was not enough.
    MaxSteps {
        /// The time reached, s.
        t: f64,
        /// [`Tolerance::max_steps`].
        max_steps: usize,
    },
    /// The system is too stiff for an explicit method.
    Stiff {
        /// The time reached, s.
        t: f64,
    },
    /// The integrator refused for another reason.
    Integrator {
        /// The time reached, s.
        t: f64,
    },
}

impl fmt::Display for SimulateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Times { index, t } => {
                write!(
                    f,
                    "times[{index}] is {t} s, a finite time above the one before is required"
                )
            }
            Self::Tolerance { relative, absolute } => write!(
                f,
                "tolerances are {relative:e} relative and {absolute:e} absolute, both must be positive and finite"
            ),
            Self::NotFinite { t } => write!(f, "the motion is not finite at {t} s"),
            Self::StepSize { t } => {
                write!(
                    f,
                    "the step became too small at {t} s: a singularity or a jump is near"
                )
            }
            Self::MaxSteps { t, max_steps } => {
                write!(
                    f,
                    "reached {t} s in {max_steps} steps, more are not allowed"
                )
            }
            Self::Stiff { t } => write!(f, "the system is stiff at {t} s"),
            Self::Integrator { t } => write!(f, "the integrator refused to go on at {t} s"),
        }
    }
}

impl Error for SimulateError {}

/// Simulates `M u_dot + bias = tau`, `q_dot = q_dot(q, u)` from `q` and `u` at `times[0]`.
///
/// Returns one sample for each of `times` (s, increasing), the first being the initial state; none if `times` is
/// empty. Quaternions in `q` must have length one, to a few roundings: [`scale_quaternions`](crate::manifold::scale_quaternions) sees
/// to that. `control(t, q, u, tau)` overwrites `tau`, which is zero on entry. It is called at the integrator's
/// stages, several times per step, also for rejected steps. No step goes past one of `times`.
///
/// The law gets quaternions that do not have length one exactly: stages stray from it, and errors of steps add up. A law that needs length
/// one takes a copy of `q` and calls [`scale_quaternions`](crate::manifold::scale_quaternions) on it. Quaternions of samples have length one.
///
/// # Errors
/// See [`SimulateError`]. It never panics itself.
pub fn simulate<S: ForwardDynamics<f64>>(
    system: &S,
    q: &S::Q,
    u: &S::U,
    control: impl FnMut(f64, &S::Q, &S::U, &mut S::U),
    times: &[f64],
    tolerance: &Tolerance,
) -> Result<Samples<S>, SimulateError> {
    check(times, tolerance)?;
    let (Some(&start), Some(&end)) = (times.first(), times.last()) else {
        return Ok(Vec::new());
    };
    let motion = Motion {
        system,
        control: RefCell::new(control),
    };
    let initial = Point { q: *q, u: *u };
    if !motion.is_finite_at(start, &initial) {
        return Err(SimulateError::NotFinite { t: start });
    }
    let at = |t: f64, Point { q, u }: Point<S::Q, S::U>| Sample { t, q, u };
    // One time, or a system without coordinates: there is nothing to integrate.
    if times.len() == 1 || initial.len() == 0 {
        return Ok(times.iter().map(|&t| at(t, initial)).collect());
    }
    let mut method = ExplicitRungeKutta::dop853()
        .rtol(tolerance.relative)
        .atol(tolerance.absolute)
        .max_steps(tolerance.max_steps);
    method
        .init(&motion, start, end, &initial)
        .map_err(|failure| error(&failure, start, tolerance.max_steps))?;

    let mut samples = Vec::with_capacity(times.len());
    samples.push(at(start, initial));
    for ends in times.windows(2) {
        let &[before, t] = ends else { continue };
        // A remainder that rounding leaves is not worth a step.
        let rounding = 4.0 * f64::EPSILON * before.abs().max(t.abs());
        while t - method.t() > rounding.max(least_step(&method)) {
            advance(&mut method, &motion, t)
                .map_err(|failure| error(&failure, method.t(), tolerance.max_steps))?;
            if !method.y().is_finite() {
                return Err(SimulateError::NotFinite { t: method.t() });
            }
        }
        let mut point = *method.y();
        let remaining = t - method.t();
        if remaining > rounding {
            // So short a way is straight.
            let mut rate = point;
            motion.diff(method.t(), &point, &mut rate);
            point.mul_add_assign(remaining, &rate);
        }
        manifold::scale_quaternions(system, &mut point.q);
        samples.push(at(t, point));
    }
    Ok(samples)
}

/// The integrator refuses steps shorter than 1e-14 of the one before; ten times that is safe.
fn least_step<Y: State<f64>>(method: &impl OrdinaryNumericalMethod<f64, Y>) -> f64 {
    1e-13 * (method.t() - method.t_prev())
}

/// Tries one step toward `t`, not past it.
fn advance<Y: State<f64>>(
    method: &mut impl OrdinaryNumericalMethod<f64, Y>,
    motion: &impl ODE<f64, Y>,
    t: f64,
) -> Result<(), Failure<f64, Y>> {
    let (reached, planned) = (method.t(), method.h());
    let remaining = t - reached;
    // One hundredth more is no risk, and saves a tiny last step.
    let lands = 1.01 * planned >= remaining;
    if lands {
        method.set_h(remaining);
    } else if reached + planned <= reached {
        // The time would stand still: more steps would not help.
        return Err(Failure::StepSize {
            t: reached,
            y: method.y().clone(),
        });
    }
    method.step(motion)?;
    // A step cut short says nothing against the one that was planned.
    if lands && method.t() > reached && method.h() < planned {
        method.set_h(planned);
    }
    Ok(())
}

/// Checks that the integrator can work with the times and tolerances.
fn check(times: &[f64], tolerance: &Tolerance) -> Result<(), SimulateError> {
    let mut before = f64::NEG_INFINITY;
    for (index, &t) in times.iter().enumerate() {
        if !(t.is_finite() && t > before) {
            return Err(SimulateError::Times { index, t });
        }
        before = t;
    }
    let Tolerance {
        relative, absolute, ..
    } = *tolerance;
    if [relative, absolute]
        .iter()
        .all(|value| value.is_finite() && *value > 0.0)
    {
        Ok(())
    } else {
        Err(SimulateError::Tolerance { relative, absolute })
    }
}

/// The integrator's failure as our error.
fn error<Y: State<f64>>(
    failure: &Failure<f64, Y>,
    reached: f64,
    max_steps: usize,
) -> SimulateError {
    match failure {
        Failure::MaxSteps { t, .. } => SimulateError::MaxSteps { t: *t, max_steps },
        Failure::StepSize { t, .. } => SimulateError::StepSize { t: *t },
        Failure::Stiffness { t, .. } => SimulateError::Stiff { t: *t },
        _ => SimulateError::Integrator { t: reached },
    }
}

/// The differential equation of a controlled system.
struct Motion<'a, S, C> {
    system: &'a S,
    /// The integrator has the equation shared; it takes one derivative at a time.
    control: RefCell<C>,
}

impl<S, C> Motion<'_, S, C>
where
    S: ForwardDynamics<f64>,
    C: FnMut(f64, &S::Q, &S::U, &mut S::U),
{
    fn is_finite_at(&self, t: f64, point: &Point<S::Q, S::U>) -> bool {
        let mut rate = *point;
        self.diff(t, point, &mut rate);
        point.is_finite() && rate.is_finite()
    }
}

impl<S, C> ODE<f64, Point<S::Q, S::U>> for Motion<'_, S, C>
where
    S: ForwardDynamics<f64>,
    C: FnMut(f64, &S::Q, &S::U, &mut S::U),
{
    fn diff(&self, t: f64, point: &Point<S::Q, S::U>, rate: &mut Point<S::Q, S::U>) {
        let mut tau = S::U::filled(0.0);
        (self.control.borrow_mut())(t, &point.q, &point.u, &mut tau);
        self.system.q_dot(&point.q, &point.u, &mut rate.q);
        self.system
            .forward_dynamics(&point.q, &point.u, &tau, &mut rate.u);
    }
}

/// `q` and `u` as the integrator's state: `q` first.
#[derive(Clone, Copy, Debug)]
struct Point<Q, U> {
    q: Q,
    u: U,
}

impl<Q: Array<f64>, U: Array<f64>> Point<Q, U> {
    fn numbers(&self) -> impl Iterator<Item = &f64> {
        self.q.as_ref().iter().chain(self.u.as_ref())
    }

    fn numbers_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.q.as_mut().iter_mut().chain(self.u.as_mut())
    }

    fn is_finite(&self) -> bool {
        self.numbers().all(|number| number.is_finite())
    }
}

impl<Q: Array<f64>, U: Array<f64>> State<f64> for Point<Q, U> {
    fn len(&self) -> usize {
        Q::LEN + U::LEN
    }

    fn get_component(&self, index: usize) -> f64 {
        if index < Q::LEN {
            self.q[index]
        } else {
            self.u[index - Q::LEN]
        }
    }

    fn set_component(&mut self, index: usize, value: f64) {
        if index < Q::LEN {
            self.q[index] = value;
        } else {
            self.u[index - Q::LEN] = value;
        }
    }

    fn map_components_mut<F: FnMut(usize, &mut f64)>(&mut self, mut f: F) {
        for (index, number) in self.numbers_mut().enumerate() {
            f(index, number);
        }
    }

    fn zeros_like(&self) -> Self {
        Self::zeros()
    }

    fn zeros() -> Self {
        Self {
            q: Q::filled(0.0),
            u: U::filled(0.0),
        }
    }

    fn mul_add_assign(&mut self, alpha: f64, other: &Self) {
        for (number, other) in self.numbers_mut().zip(other.numbers()) {
            *number += alpha * other;
        }
    }

    fn scale_mut(&mut self, alpha: f64) {
        for number in self.numbers_mut() {
            *number *= alpha;
        }
    }
}
