//! Forward dynamics that checks a state before it solves.
//!
//! [`forward_dynamics`] takes a state, and [`Limits`] on how near to a singularity it may be. It gives `u_dot`, or an error that names the
//! body and leaves `u_dot` unchanged. It works for scalars that are one number (`f32`, `f64`, newtypes of them), not for lanes. The result
//! has the same bits as that of the unchecked function.

use core::error::Error;
use core::fmt;

use crate::functions::{ForwardDynamics, ForwardDynamicsPivots, Singularity};
use crate::{Array, Real, System};

/// What [`forward_dynamics`] requires of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The least distance `|cos(theta_2)|` of any body's angles from their singularity. Default 0.01 (0.6°
    /// away): the mass matrix's condition number grows with `1 / distance²`, so this costs four of the seven
    /// digits of `f32`.
    pub least_distance: f64,
    /// The limit that every pivot of the mass matrix must exceed, in the pivot's own unit, kg m² or kg. Default 0, that is,
    /// positive definite: how small a pivot may be depends on the system, and units differ from one pivot to the next.
    pub least_pivot: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            least_distance: 0.01,
            least_pivot: 0.0,
        }
    }
}

/// Why there is no `u_dot`: the place, the value found, the value required.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CheckError {
    /// A body's angles are too near their singularity.
    Singularity {
        /// The body's name.
        body: &'static str,
        /// `|cos(theta_2)|`, or NaN.
        distance: f64,
        /// [`Limits::least_distance`].
        least: f64,
    },
    /// The mass matrix is not positive definite, or a pivot is smaller than required.
    Pivot {
        /// The name of the speed's body.
        body: &'static str,
        /// The speed's name.
        speed: &'static str,
        /// The pivot, kg m² or kg, or NaN.
        pivot: f64,
        /// [`Limits::least_pivot`], which it must exceed.
        least: f64,
    },
    /// The result is infinite or NaN, because an argument is, or is too large.
    NotFinite {
        /// The name of the speed's body.
        body: &'static str,
        /// The speed's name.
        speed: &'static str,
        /// The derivative of the speed.
        u_dot: f64,
    },
}

impl fmt::Display for CheckError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singularity {
                body,
                distance,
                least,
            } => write!(
                f,
                "the angles of body `{body}` are {distance:e} from their singularity, at least {least:e} is required"
            ),
            Self::Pivot {
                body,
                speed,
                pivot,
                least,
            } => write!(
                f,
                "the mass matrix has the pivot {pivot:e} at speed `{speed}` of body `{body}`, more than {least:e} is required"
            ),
            Self::NotFinite { body, speed, u_dot } => {
                write!(
                    f,
                    "the derivative of speed `{speed}` of body `{body}` is {u_dot}, a finite number is required"
                )
            }
        }
    }
}

impl Error for CheckError {}

/// Writes the `u_dot` that solves `M u_dot + bias = tau`, like
/// [`ForwardDynamics::forward_dynamics`], if the state passes the checks.
///
/// ```
/// # #[cfg(feature = "eight_body")] {
/// use kane::checked::{CheckError, Limits, forward_dynamics};
/// use kane::eight_body::{NQ, NU, Prepared};
///
/// let system = Prepared::<f64>::nominal();
/// let (mut q, u, tau, mut u_dot) = ([0.0; NQ], [0.0; NU], [0.0; NU], [0.0; NU]);
/// assert!(forward_dynamics(&system, &q, &u, &tau, &mut u_dot, &Limits::default()).is_ok());
///
/// q[4] = core::f64::consts::FRAC_PI_2; // theta_2 of the second body, between its free theta_1 and theta_3
/// let error = forward_dynamics(&system, &q, &u, &tau, &mut u_dot, &Limits::default());
/// assert!(matches!(error, Err(CheckError::Singularity { body: "shoulder", .. })));
/// # }
/// ```
///
/// # Errors
/// The first failure, in the order of these checks, then of bodies and speeds: a body's
/// angles too near their singularity, a pivot that does not exceed its limit, a result that is not finite. Lengths of quaternions are not
/// checked, nor are arguments on which the result does not depend.
/// `u_dot` does not change. A distance, pivot or result that is NaN never passes.
pub fn forward_dynamics<R, S>(
    system: &S,
    q: &S::Q,
    u: &S::U,
    tau: &S::U,
    u_dot: &mut S::U,
    limits: &Limits,
) -> Result<(), CheckError>
where
    R: Real + Into<f64>,
    S: ForwardDynamics<R> + ForwardDynamicsPivots<R> + Singularity<R>,
{
    let mut distances = S::Scalars::filled(R::from_f64(0.0));
    system.singularity(q, &mut distances);
    let least = limits.least_distance;
    if let Some((body, distance)) = first_failing(distances.as_ref(), |distance| distance >= least)
    {
        let body = name(S::BODY_NAMES, body);
        return Err(CheckError::Singularity {
            body,
            distance,
            least,
        });
    }

    let mut pivots = S::U::filled(R::from_f64(0.0));
    system.forward_dynamics_pivots(q, &mut pivots);
    let least = limits.least_pivot;
    if let Some((speed, pivot)) =
        first_failing(pivots.as_ref(), |pivot| pivot > least && pivot.is_finite())
    {
        let (body, speed) = speed_names::<R, S>(speed);
        return Err(CheckError::Pivot {
            body,
            speed,
            pivot,
            least,
        });
    }

    let mut result = *u_dot;
    system.forward_dynamics(q, u, tau, &mut result);
    if let Some((speed, u_dot)) = first_failing(result.as_ref(), f64::is_finite) {
        let (body, speed) = speed_names::<R, S>(speed);
        return Err(CheckError::NotFinite { body, speed, u_dot });
    }
    *u_dot = result;
    Ok(())
}

/// The first value that does not pass, with its index.
fn first_failing<R: Real + Into<f64>>(
    values: &[R],
    passes: impl Fn(f64) -> bool,
) -> Option<(usize, f64)> {
    let numbers = values.iter().map(|value| (*value).into());
    numbers.enumerate().find(|(_, number)| !passes(*number))
}

/// The names of a speed's body and of the speed.
fn speed_names<R: Real, S: System<R>>(speed: usize) -> (&'static str, &'static str) {
    let body = S::SPEED_BODIES.get(speed).copied().unwrap_or(usize::MAX);
    (name(S::BODY_NAMES, body), name(S::SPEED_NAMES, speed))
}

/// The name at `index`; lists that are too short (a hand-written system's mistake) give `?`, not a panic.
fn name(names: &[&'static str], index: usize) -> &'static str {
    names.get(index).copied().unwrap_or("?")
}
