//! What the identification of both arms achieves, with noise of several seeds.

use kane_identification::{
    Arm, Identifiable, Noise, Path, Report,
    consistent::consistent,
    drive::COEFFICIENTS,
    excitation::exciting,
    experiment,
    extremes::{largest, least},
    measurement::Measured,
    panda, physical, prior, pseudo_inertia, run, stack,
    stack::base_parameters,
    stack_torques, ur5,
};

use kane::Array;

type Ur5 = ur5::Prepared<f64>;
type Panda = panda::Prepared<f64>;

const SEEDS: std::ops::RangeInclusive<u64> = 1..=3;

/// What holds of both arms.
fn succeeds(report: &Report) {
    let seen = format!("{report}");
    assert!(report.condition < 250.0, "{seen}");
    assert!(report.effort < 1.0, "{seen}");
    // Of normal deviations, some fifty, the greatest is about three; their root mean square is about one.
    assert!(report.missed_at_most() < 4.5, "{seen}");
    assert!((0.6..1.4).contains(&report.missed()), "{seen}");
    assert!(report.moved_at_most() < 3.5, "{seen}");
    // All that is left of the error on a path that was not used is noise, a tenth of it at most the model's.
    assert!((4.0..6.0).contains(&report.prior.measured), "{seen}");
    assert!((0.95..1.05).contains(&report.consistent.measured), "{seen}");
    assert!(report.consistent.exact < 0.1, "{seen}");
    // Being consistent costs nothing: mostly it lowers the error.
    let no_worse = 1.1 * report.least_squares.exact;
    assert!(report.consistent.exact < no_worse, "{seen}");
    assert!(report.margin > 0.0, "{seen}");
    let [_, _, masses] = &report.masses;
    assert!(masses.iter().all(|mass| *mass > 0.0), "{seen}");
}

#[test]
fn the_ur5_is_identified() {
    for seed in SEEDS {
        let report = run::<Ur5>(seed);
        succeeds(&report);
        assert_eq!((report.columns, report.parameters.len()), (54, 52));
    }
}

#[test]
fn the_panda_is_identified() {
    for seed in SEEDS {
        let report = run::<Panda>(seed);
        succeeds(&report);
        assert_eq!((report.columns, report.parameters.len()), (64, 62));
    }
}

/// The states of any path, and the regressors there, in units of the joints' limits.
fn any_path<A: Arm>() -> (Measured<A>, nalgebra::DMatrix<f64>) {
    let (arm, mut chance) = (A::nominal(), Noise::new(3));
    let states = Path::random::<A>(10.0, &mut chance).states(200);
    let w = stack(&arm, &states, &limits::<A>());
    (Measured::new(&arm, states, 2, &mut chance), w)
}

fn limits<A: Arm>() -> A::U {
    A::U::from_fn(|i| A::EFFORT_LIMITS[i])
}

/// The chosen path has a lower condition number than one that is drawn by chance.
fn exciting_paths_are_better<A: Arm>() {
    let (arm, mut chance) = (A::nominal(), Noise::new(3));
    let prior = physical::base::<A>() * prior::wrong(&experiment::truth::<A>()).parameters();
    let chosen = exciting(&arm, 10.0, &prior, &mut chance).states(200);
    let condition = |w| Identifiable::of(&w).condition();
    let chosen = condition(stack(&arm, &chosen, &limits::<A>()));
    let any = condition(any_path::<A>().1);
    assert!(1.4 * chosen < any, "{chosen} {any}");
}

#[test]
fn exciting_paths_of_the_ur5_are_better() {
    exciting_paths_are_better::<Ur5>();
}

#[test]
fn exciting_paths_of_the_panda_are_better() {
    exciting_paths_are_better::<Panda>();
}

/// What inertial parameters and terms of base parameters give is what the generated module computes of the same model.
fn base_parameters_give_the_torques<A: Arm>() {
    let (measured, w) = any_path::<A>();
    let parameters = physical::base::<A>() * experiment::truth::<A>().parameters();
    let error = w * parameters - stack_torques::<A>(&measured.truth, &limits::<A>());
    let error = largest(&error);
    assert!(error < 1e-13, "{error}");
}

#[test]
fn base_parameters_give_the_torques_of_the_ur5() {
    base_parameters_give_the_torques::<Ur5>();
}

#[test]
fn base_parameters_give_the_torques_of_the_panda() {
    base_parameters_give_the_torques::<Panda>();
}

/// All base parameters can be identified, and all coefficients of drives but the rotors of the first two joints.
fn two_rotors_are_part_of_others<A: Arm>() {
    let (_, w) = any_path::<A>();
    let identifiable = Identifiable::of(&w);
    let left_out: Vec<usize> = (0..w.ncols())
        .filter(|j| !identifiable.columns.contains(j))
        .collect();
    let rotor = |joint| base_parameters::<A>() + COEFFICIENTS * joint + 2;
    assert_eq!(left_out, [rotor(0), rotor(1)]);
    let error = &identifiable.q * &identifiable.r * &identifiable.sums - &w;
    let error = largest(&error);
    assert!(error < 1e-12 * largest(&w), "{error}");
}

#[test]
fn two_rotors_of_the_ur5_are_part_of_others() {
    two_rotors_are_part_of_others::<Ur5>();
}

#[test]
fn two_rotors_of_the_panda_are_part_of_others() {
    two_rotors_are_part_of_others::<Panda>();
}

/// Base parameters that an arm has, without noise, are those of the consistent arm, from a prior that is wrong.
fn exact_parameters_are_reproduced<A: Arm>() {
    let (_, w) = any_path::<A>();
    let identifiable = Identifiable::of(&w);
    let truth = experiment::truth::<A>();
    let sums = &identifiable.sums * physical::base::<A>();
    let exact = &sums * truth.parameters();
    // So weak a prior decides nothing that torques tell.
    let found = consistent(&prior::wrong(&truth), 1e7, &identifiable, &sums, &exact);
    let error = &sums * found.parameters() - &exact;
    let error = largest(&error);
    assert!(error < 1e-10 * largest(&exact), "{error}");
    assert!(found.bodies.iter().all(|p| pseudo_inertia::margin(p) > 0.0));
}

#[test]
fn exact_parameters_of_the_ur5_are_reproduced() {
    exact_parameters_are_reproduced::<Ur5>();
}

#[test]
fn exact_parameters_of_the_panda_are_reproduced() {
    exact_parameters_are_reproduced::<Panda>();
}

/// The path keeps to the joints' limits.
fn paths_keep_to_limits<A: Arm>() {
    for state in &any_path::<A>().0.states {
        for i in 0..A::SPEED_NAMES.len() {
            let (lower, upper) = (A::LOWER_LIMITS[i], A::UPPER_LIMITS[i]);
            assert!(lower < state.q[i] && state.q[i] < upper, "{:?}", state.q);
            assert!(state.u[i].abs() < A::VELOCITY_LIMITS[i], "{:?}", state.u);
        }
    }
}

#[test]
fn paths_keep_to_the_limits_of_the_ur5() {
    paths_keep_to_limits::<Ur5>();
}

#[test]
fn paths_keep_to_the_limits_of_the_panda() {
    paths_keep_to_limits::<Panda>();
}

#[test]
fn derivatives_are_those_of_the_moved_parameters() {
    const STEP: f64 = 1e-5;
    let arm = experiment::truth::<Panda>();
    let mut chance = Noise::new(4);
    let size = arm.parameters().len();
    let theta = nalgebra::DVector::from_fn(size, |_, _| 0.3 * chance.normal());
    let derivative = arm.derivative(&theta);
    for j in 0..size {
        let at = |step: f64| {
            let mut theta = theta.clone();
            theta[j] += step;
            arm.moved(&theta).parameters()
        };
        let difference = (at(STEP) - at(-STEP)) / (2.0 * STEP) - derivative.column(j);
        let error = largest(&difference);
        assert!(error < 1e-7, "{j}: {error}");
    }
}

#[test]
fn what_is_not_a_number_is_the_largest_and_the_least_wherever_it_stands() {
    const NAN: f64 = f64::NAN;
    for numbers in [[NAN, 1.0, -2.0], [1.0, NAN, -2.0], [1.0, -2.0, NAN]] {
        assert!(largest(numbers).is_nan() && least(numbers).is_nan());
    }
    assert_eq!(
        (largest([1.0, -3.0, 2.0]), least([1.0, -3.0, 2.0])),
        (3.0, -3.0)
    );
    let none = [0.0; 0];
    assert_eq!((largest(none), least(none)), (0.0, f64::INFINITY));
}
