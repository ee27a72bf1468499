//! Checks that hold for every generated module. The tests that `kane generate --with-tests` writes call them.
//!
//! A check takes a system and a state, and returns nothing or a [`Mismatch`], the found and the expected number. All checks compute in
//! `f64`. Derivatives along the motion are central differences, extrapolated once. The checks share no code with the generator.

use core::error::Error;
use core::fmt;

use crate::functions::{
    Bias, ForwardDynamics, InverseDynamics, KineticEnergy, MassMatrix, PotentialEnergy,
};
use crate::{Array, System};

/// The coordinates, speeds and derivatives of the speeds at which a system is checked.
#[derive(Clone, Copy, Debug)]
pub struct State<const NQ: usize, const NU: usize> {
    /// Coordinates; quaternions have length one.
    pub q: [f64; NQ],
    /// Speeds.
    pub u: [f64; NU],
    /// Derivatives of the speeds.
    pub u_dot: [f64; NU],
}

/// A number is not what it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mismatch {
    /// What was compared.
    pub what: &'static str,
    /// Its place: the index of an entry, a row, or a speed.
    pub place: usize,
    /// The number found.
    pub found: f64,
    /// The number expected.
    pub expected: f64,
    /// The allowed difference between the two.
    pub tolerance: f64,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            what,
            place,
            found,
            expected,
            tolerance,
        } = self;
        write!(
            f,
            "{what}, {place}: found {found:e}, expected {expected:e} within {tolerance:e}"
        )
    }
}

impl Error for Mismatch {}

/// Rounding of two ways to one number, relative to the sum of the terms of both: these may themselves be sums of some hundred
/// terms, of which cancellation leaves a part in ten thousand.
const ROUNDING: f64 = 1e-10;

/// The fraction of the largest force that counts as a term of each other one.
const LARGER: f64 = 1e-5;

/// The truncation error of differences, relative to the rates: their step is [`STEP`], and the next term of the series is of its
/// fourth power.
const DIFFERENCE: f64 = 1e-7;

/// Rounding of the differenced numbers, relative to these, before division by the step.
const DIFFERENCED: f64 = 1e-12;

/// Step of differences, s.
const STEP: f64 = 1e-3;

/// Compares the output of a function with numbers that the generator evaluated from the model's equations, each with a rounding bound.
///
/// It compares entry by entry; for a large output it compares sums of `entries` entries each, with the weights of [`weight`].
///
/// # Errors
/// The first number that differs.
pub fn has_values(
    what: &'static str,
    found: &[f64],
    entries: usize,
    expected: &[(f64, f64)],
) -> Result<(), Mismatch> {
    let sums = found.chunks(entries.max(1)).map(sum);
    for (place, (found, &(expected, tolerance))) in sums.zip(expected).enumerate() {
        is_near(what, place, found, expected, tolerance)?;
    }
    let (n_found, n_expected) = (found.len().div_ceil(entries.max(1)), expected.len());
    is_near("length", 0, n_found as f64, n_expected as f64, 0.0)
}

/// The weight of an entry in a sum: never zero, and different for any two of a thousand, so that two entries that are exchanged show.
#[must_use]
pub fn weight(place: usize) -> f64 {
    // 1021 is prime, so multiples of 397 have all remainders.
    (1 + place % 1021 * 397 % 1021) as f64 / 1024.0
}

fn sum(entries: &[f64]) -> f64 {
    match entries {
        [entry] => *entry,
        entries => {
            let terms = entries.iter().enumerate();
            terms.map(|(place, entry)| weight(place) * entry).sum()
        }
    }
}

/// Checks that `M = M^T` and that all pivots of its elimination are positive, up to rounding.
///
/// The last speeds go first. They are those of outer bodies, except with `order = "notes"`, so that a light body on a heavy one loses no digits.
///
/// # Errors
/// The entry that differs from its mirror image, or the pivot.
pub fn mass_matrix_is_positive_definite<S: MassMatrix<f64>>(
    system: &S,
    q: &S::Q,
) -> Result<(), Mismatch> {
    let mut m = unwritten(system);
    system.mass_matrix(q, &mut m);
    let n = S::U::LEN;
    for row in 0..n {
        for column in 0..row {
            let (found, mirrored) = (m[row][column], m[column][row]);
            is_near("mass matrix, symmetry, row", row, found, mirrored, 0.0)?;
        }
    }
    let whole = m;
    for pivot in (0..n).rev() {
        let d = m[pivot][pivot];
        // A coordinate that moves no mass to speak of beside what moves with it.
        let rounding = n as f64 * f64::EPSILON * whole[pivot][pivot];
        if d.abs() <= rounding && rounding > 0.0 && rounding.is_finite() {
            // Then it moves nothing else either: the square of an entry is at most the product of its pivots.
            let is_nothing = |row: usize| {
                let entry = m[row][pivot];
                entry * entry <= 4.0 * rounding * whole[row][row]
            };
            if (0..pivot).all(is_nothing) {
                continue;
            }
        }
        if !d.is_finite() || d <= rounding {
            return Err(Mismatch {
                what: "mass matrix, pivot, which is to be positive",
                place: pivot,
                found: d,
                expected: whole[pivot][pivot].abs(),
                tolerance: whole[pivot][pivot].abs(),
            });
        }
        for row in 0..pivot {
            let factor = m[row][pivot] / d;
            for column in 0..pivot {
                m[row][column] -= factor * m[pivot][column];
            }
        }
    }
    Ok(())
}

/// Checks that the accelerations that forward dynamics gives for the forces of inverse dynamics need the same forces.
///
/// It compares forces because an ill-conditioned mass matrix keeps their digits, but not those of accelerations.
///
/// # Errors
/// The force that differs.
pub fn forward_undoes_inverse<S: InverseDynamics<f64> + ForwardDynamics<f64>>(
    system: &S,
    q: &S::Q,
    u: &S::U,
    u_dot: &S::U,
) -> Result<(), Mismatch> {
    let tau = forces(system, q, u, u_dot);
    let mut solved = S::U::filled(f64::NAN);
    system.forward_dynamics(q, u, &tau, &mut solved);
    let (found, scales) = (forces(system, q, u, &solved), scales(system, q, u, u_dot));
    for speed in 0..S::U::LEN {
        let tolerance = ROUNDING * scales[speed];
        is_near("force", speed, found[speed], tau[speed], tolerance)?;
    }
    Ok(())
}

/// Checks that the power of the forces of a motion, minus that of dampers, is the rate of kinetic plus potential energy.
///
/// The damper forces are the part of the forces that is odd in the speeds.
///
/// # Errors
/// The power and the rate.
pub fn power_is_the_rate_of_energy<S>(
    system: &S,
    q: &S::Q,
    u: &S::U,
    u_dot: &S::U,
) -> Result<(), Mismatch>
where
    S: InverseDynamics<f64> + Bias<f64> + KineticEnergy<f64> + PotentialEnergy<f64>,
{
    let tau = forces(system, q, u, u_dot);
    let (forward, backward) = (bias_at(system, q, u, 1.0), bias_at(system, q, u, -1.0));
    let (mut power, mut rates, mut damped) = (0.0, 0.0, 0.0);
    for speed in 0..S::U::LEN {
        let damping = 0.5 * (forward[speed] - backward[speed]);
        power += u[speed] * (tau[speed] - damping);
        rates += (u[speed] * (tau[speed] - damping)).abs();
        damped += (u[speed] * damping).abs();
    }
    let energies = |t: f64| {
        let (mut moved, mut kinetic, mut potential) = (*u, f64::NAN, f64::NAN);
        for (speed, rate) in moved.as_mut().iter_mut().zip(u_dot.as_ref()) {
            *speed += t * rate;
        }
        let q = moved_along(system, q, u, t);
        system.kinetic_energy(&q, &moved, &mut kinetic);
        system.potential_energy(&q, &mut potential);
        [kinetic, potential]
    };
    let [kinetic, potential] = energies(0.0).map(f64::abs);
    let differenced = DIFFERENCED * (kinetic + potential) / STEP;
    let tolerance = DIFFERENCE * rates + ROUNDING * damped + differenced;
    let rate = difference(|t| energies(t).iter().sum());
    is_near("power and rate of energy", 0, power, rate, tolerance)
}

/// Checks that `dM/dt - 2 C` does no work: half of `u^T (dM/dt) u` is the power of centrifugal, Coriolis and gyroscopic forces.
///
/// These forces are the part of `bias` that is of second order in the speeds.
///
/// # Errors
/// The power and half the rate.
pub fn bias_follows_the_mass_matrix<S: MassMatrix<f64> + Bias<f64>>(
    system: &S,
    q: &S::Q,
    u: &S::U,
) -> Result<(), Mismatch> {
    let [twice, once, none] = [2.0, 1.0, 0.0].map(|factor| bias_at(system, q, u, factor));
    let (mut power, mut rates, mut terms) = (0.0, 0.0, 0.0);
    for speed in 0..S::U::LEN {
        let quadratic = 0.5 * (twice[speed] - 2.0 * once[speed] + none[speed]);
        power += u[speed] * quadratic;
        rates += (u[speed] * quadratic).abs();
        let sum = twice[speed].abs() + once[speed].abs() + none[speed].abs();
        terms += u[speed].abs() * sum;
    }
    let energy = |t: f64| {
        let mut m = unwritten(system);
        system.mass_matrix(&moved_along(system, q, u, t), &mut m);
        let rows = m.as_ref().iter().zip(u.as_ref());
        let products = |row: &S::U| -> f64 {
            let row = row.as_ref().iter().zip(u.as_ref());
            row.map(|(entry, u)| entry * u).sum()
        };
        rows.map(|(row, u)| 0.5 * u * products(row)).sum::<f64>()
    };
    let differenced = DIFFERENCED * energy(0.0).abs() / STEP;
    let tolerance = DIFFERENCE * rates + ROUNDING * terms + differenced;
    let rate = difference(energy);
    is_near("power of bias and rate of M", 0, power, rate, tolerance)
}

/// Checks that inverse dynamics is linear in a parameter.
///
/// `below`, `at` and `above` are in equal steps of the parameter; the second difference of their forces must be zero.
///
/// # Errors
/// The force that is not linear.
pub fn inverse_dynamics_is_linear<S: InverseDynamics<f64>>(
    [below, at, above]: [&S; 3],
    q: &S::Q,
    u: &S::U,
    u_dot: &S::U,
) -> Result<(), Mismatch> {
    let [lower, middle, upper] = [below, at, above].map(|system| forces(system, q, u, u_dot));
    let [lower_scales, upper_scales] = [below, above].map(|system| scales(system, q, u, u_dot));
    for speed in 0..S::U::LEN {
        let found = 0.5 * (lower[speed] + upper[speed]);
        let tolerance = ROUNDING * (lower_scales[speed] + upper_scales[speed]);
        is_near("linear force", speed, found, middle[speed], tolerance)?;
    }
    Ok(())
}

fn is_near(
    what: &'static str,
    place: usize,
    found: f64,
    expected: f64,
    tolerance: f64,
) -> Result<(), Mismatch> {
    // What is not a number is near nothing, and beside infinite terms there is no rounding to allow for.
    if (found - expected).abs() <= tolerance && tolerance.is_finite() {
        return Ok(());
    }
    Err(Mismatch {
        what,
        place,
        found,
        expected,
        tolerance,
    })
}

fn forces<S: InverseDynamics<f64>>(system: &S, q: &S::Q, u: &S::U, u_dot: &S::U) -> S::U {
    let mut tau = S::U::filled(f64::NAN);
    system.inverse_dynamics(q, u, u_dot, &mut tau);
    tau
}

/// For each force the sum of its terms: of weight and springs, of motion, and of each acceleration. Outer bodies may weigh
/// nothing beside inner ones, so each force has its own scale; but a force that is the sum of larger ones, in axes of other
/// bodies, has the rounding of these.
fn scales<S: InverseDynamics<f64>>(system: &S, q: &S::Q, u: &S::U, u_dot: &S::U) -> S::U {
    let zero = S::U::filled(0.0);
    let (resting, moving) = (forces(system, q, &zero, &zero), forces(system, q, u, &zero));
    let mut scales =
        S::U::from_fn(|speed| resting[speed].abs() + (moving[speed] - resting[speed]).abs());
    for accelerated in 0..S::U::LEN {
        let mut one = zero;
        one[accelerated] = u_dot[accelerated];
        let forces = forces(system, q, &zero, &one);
        for speed in 0..S::U::LEN {
            scales[speed] += (forces[speed] - resting[speed]).abs();
        }
    }
    let scales_of = scales.as_ref().iter();
    let largest = scales_of.fold(0.0, |most: f64, scale| most.max(*scale));
    for scale in scales.as_mut() {
        *scale += LARGER * largest;
    }
    scales
}

/// A matrix for the system to write.
fn unwritten<S: MassMatrix<f64>>(_: &S) -> S::Matrix {
    S::Matrix::filled(S::U::filled(f64::NAN))
}

/// The bias at a multiple of the speeds.
fn bias_at<S: Bias<f64>>(system: &S, q: &S::Q, u: &S::U, factor: f64) -> S::U {
    let (mut scaled, mut bias) = (*u, S::U::filled(f64::NAN));
    for speed in scaled.as_mut() {
        *speed *= factor;
    }
    system.bias(q, &scaled, &mut bias);
    bias
}

/// The coordinates after this time at their present rates.
fn moved_along<S: System<f64>>(system: &S, q: &S::Q, u: &S::U, t: f64) -> S::Q {
    let (mut moved, mut rates) = (*q, S::Q::filled(f64::NAN));
    system.q_dot(q, u, &mut rates);
    for (coordinate, rate) in moved.as_mut().iter_mut().zip(rates.as_ref()) {
        *coordinate += t * rate;
    }
    moved
}

/// The derivative at zero.
fn difference(function: impl Fn(f64) -> f64) -> f64 {
    let central = |step: f64| (function(step) - function(-step)) / (2.0 * step);
    (4.0 * central(0.5 * STEP) - central(STEP)) / 3.0
}
