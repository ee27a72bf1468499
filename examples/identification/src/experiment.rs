//! The whole way: choose a path, measure, identify, and see on another path what it is worth.

use kane::Array;
use nalgebra::{DVector, Matrix4};

use crate::{
    Arm, Drive, Identifiable, Measured, Noise, Path, Physical,
    consistent::consistent,
    excitation::exciting,
    extremes::{largest, least},
    measurement::TORQUE_NOISE,
    names::{names, units},
    physical::base,
    prior,
    pseudo_inertia::{self, PARAMETERS},
    report::{Errors, Parameter, Report},
    stack, stack_torques,
};

/// How long one lap takes on the path by which it learns, s,
pub const LAP: f64 = 10.0;
/// at how many of its points torques are measured,
pub const POINTS: usize = 500;
/// and in how many laps.
pub const LAPS: usize = 10;
/// The same of the path on which it is tested, in one lap.
const TEST_LAP: f64 = 8.0;
const TEST_POINTS: usize = 400;
/// The standard deviation of the prior's log-Cholesky parameters: masses and lengths may well be half as large again.
const DOUBT: f64 = 0.5;
/// Which paths are drawn.
const PATHS: u64 = 1;

/// What an arm truly is.
pub fn truth<A: Arm>() -> Physical {
    Physical {
        bodies: inertial_parameters::<A>(),
        drives: A::DRIVES.iter().map(Drive::coefficients).collect(),
    }
}

/// The pseudo-inertias of the bodies that the URDF describes: the truth, and known to nobody else.
fn inertial_parameters<A: Arm>() -> Vec<Matrix4<f64>> {
    let mut pi = A::Inertial::filled([0.0; PARAMETERS]);
    A::nominal().inertial_parameters(&mut pi);
    pi.as_ref().iter().map(pseudo_inertia::of).collect()
}

/// Identifies an arm, with noise that follows from the seed.
pub fn run<A: Arm>(seed: u64) -> Report {
    let (arm, truth) = (A::nominal(), truth::<A>());
    let (prior, base) = (prior::wrong(&truth), base::<A>());
    let (mut chance, mut noise) = (Noise::new(PATHS), Noise::new(seed));
    let path = exciting(&arm, LAP, &(&base * prior.parameters()), &mut chance);
    let learnt = Measured::new(&arm, path.states(POINTS), LAPS, &mut noise);
    let noise_of_mean = learnt.deviations();
    let identifiable = Identifiable::of(&stack(&arm, &learnt.states, &noise_of_mean));
    let found = identifiable.least_squares(&stack_torques::<A>(&learnt.mean(), &noise_of_mean));
    let sums = &identifiable.sums * base;
    let found_arm = consistent(&prior, DOUBT, &identifiable, &sums, &found);
    let [of_truth, of_prior, of_found_arm] =
        [&truth, &prior, &found_arm].map(|arm| &sums * arm.parameters());

    let other = Path::random::<A>(TEST_LAP, &mut chance);
    let tested = Measured::new(&arm, other.states(TEST_POINTS), 1, &mut noise);
    let errors = |parameters: &DVector<f64>| errors(&arm, &tested, &identifiable, parameters);
    let deviations = identifiable.deviations();
    let (names, units) = (names::<A>(&identifiable), units::<A>(&identifiable));
    let parameters = names.into_iter().zip(units).enumerate();
    Report {
        arm: A::NAME,
        condition: identifiable.condition(),
        columns: identifiable.sums.ncols(),
        effort: largest([effort(&learnt), effort(&tested)]),
        prior: errors(&of_prior),
        least_squares: errors(&found),
        consistent: errors(&of_found_arm),
        parameters: parameters
            .map(|(i, (name, unit))| Parameter {
                name,
                unit,
                truth: of_truth[i],
                prior: of_prior[i],
                found: found[i],
                deviation: deviations[i],
                consistent: of_found_arm[i],
            })
            .collect(),
        masses: [&truth, &prior, &found_arm].map(masses),
        margin: least(found_arm.bodies.iter().map(pseudo_inertia::margin)),
    }
}

/// How far predicted torques are from those that are measured, and from the true ones.
fn errors<A: Arm>(
    arm: &A,
    tested: &Measured<A>,
    identifiable: &Identifiable,
    parameters: &DVector<f64>,
) -> Errors {
    let limits = A::U::from_fn(|i| A::EFFORT_LIMITS[i]);
    let w = stack(arm, &tested.states, &limits);
    let predicted = w.select_columns(&identifiable.columns) * parameters;
    let rms = |torques| {
        let error = &predicted - stack_torques::<A>(torques, &limits);
        error.norm() / (error.len() as f64).sqrt()
    };
    Errors {
        measured: rms(&tested.mean()) / TORQUE_NOISE,
        exact: rms(&tested.truth) / TORQUE_NOISE,
    }
}

/// The greatest torque, as a part of the joint's limit.
fn effort<A: Arm>(measured: &Measured<A>) -> f64 {
    let limits = A::U::from_fn(|i| A::EFFORT_LIMITS[i]);
    largest(&stack_torques::<A>(&measured.truth, &limits))
}

/// kg.
fn masses(arm: &Physical) -> Vec<f64> {
    arm.bodies.iter().map(|p| p[(3, 3)]).collect()
}
