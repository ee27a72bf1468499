//! Every robot, compiled, against Pinocchio's values for the same file in the same 20 states.

use kane_test_support::{
    compare::{relative, relative_to},
    errors::Errors,
    numeric::{Matrix, condition},
};

use crate::common::{
    cross,
    mass::{mass_center, masses},
    motion::Motion,
    placements,
    reference::{Reference, Sample, index, number, text},
    robot,
};
use kane_test_robots::{Dynamics, Robot, SOLO12_ANGLES_NOTES};

/// How far values may be from Pinocchio's.
#[derive(Clone, Copy)]
struct Tolerances {
    /// Relative to a quantity's largest entry.
    values: f64,
    /// Of a solution with the mass matrix, relative to its largest entry and to the matrix's condition number.
    solution: f64,
}

/// Sums of some hundred products, rounded to 1e-16 each on both sides, leave 1e-14; the rest is room for sums that are
/// smaller than their terms, as a potential energy is: 4e-14 is met. A stable solution is the exact one of a mass matrix and
/// a right-hand side that are off by a few roundings, and the condition number multiplies that.
const EXACT: Tolerances = Tolerances {
    values: 1e-13,
    solution: 1e-14,
};

/// The files' right angles have ten digits or more: what snapping changes is at most 5e-12 an entry. That grows with the
/// joints between, is squared in the mass matrix, and shows most in sums that are smaller than their terms: 8e-11 is met.
const SNAPPED: Tolerances = Tolerances {
    values: 2e-10,
    solution: 1e-12,
};

fn pinocchio_agrees(name: &str) {
    let reference = Reference::new(name);
    let compiled = (robot(name).plain)();
    let mut errors = Errors::default();
    check_dynamics(&*compiled, &reference, EXACT, &mut errors);
    check_rest(&*compiled, name, &reference, EXACT, &mut errors);
    errors.show(name);
}

fn check_dynamics(
    robot: &dyn Dynamics,
    reference: &Reference,
    tolerances: Tolerances,
    errors: &mut Errors,
) {
    for sample in reference.samples() {
        let v = sample.numbers("v");
        let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
        let (q, u) = (&motion.q, &motion.u);
        let m = Matrix::new(u.len(), robot.mass_matrix(q));
        let mut compare = |key, found: &[f64], tolerance| {
            if let Some(expected) = sample.optional(key) {
                errors.add(key, relative(found, &expected), tolerance);
            }
        };
        compare(
            "M",
            &motion.pinocchio_mass_matrix(&m).entries,
            tolerances.values,
        );
        let bias = robot.bias(q, u);
        compare("bias", &motion.pinocchio_bias(&m, &bias), tolerances.values);
        let u_dot = motion.u_dot(&sample.numbers("a"));
        let tau = robot.inverse_dynamics(q, u, &u_dot);
        compare(
            "inverse_dynamics",
            &motion.pinocchio_tau(&tau),
            tolerances.values,
        );
        let tau = motion.tau(&sample.numbers("tau"));
        let u_dot = robot.forward_dynamics(q, u, &tau);
        compare(
            "forward_dynamics",
            &motion.pinocchio_a(&u_dot),
            tolerances.solution * condition(&m),
        );
        let rest = vec![0.0; v.len()];
        let weight = motion.pinocchio_tau(&robot.bias(q, &rest));
        compare("gravity_torque", &weight, tolerances.values);
        let weight = motion.pinocchio_tau(&robot.gravity_forces(q));
        compare("gravity_torque", &weight, tolerances.values);
    }
}

/// Placements, energies and momenta.
fn check_rest(
    robot: &dyn Robot,
    name: &str,
    reference: &Reference,
    tolerances: Tolerances,
    errors: &mut Errors,
) {
    let masses = masses(name, reference.is_floating());
    let mass = reference.moving_mass();
    for sample in reference.samples() {
        let v = sample.numbers("v");
        let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
        let (q, u) = (&motion.q, &motion.u);
        check_placements(robot, q, reference, sample, tolerances, errors);
        let mut compare = |key, found: &[f64]| {
            let error = relative(found, &sample.numbers(key));
            errors.add(key, error, tolerances.values);
        };
        let center = mass_center(robot, q, &masses);
        compare("com", &center);
        let momentum = robot.linear_momentum(q, u);
        compare("com_velocity", &momentum.map(|entry| entry / mass));
        let (about_origin, moved) = (robot.angular_momentum(q, u), cross(center, momentum));
        let about_center = [0, 1, 2].map(|i| about_origin[i] - moved[i]);
        compare("centroidal_momentum", &[momentum, about_center].concat());
        compare("kinetic_energy", &[robot.kinetic_energy(q, u)]);
        compare("potential_energy", &[robot.potential_energy(q)]);
    }
}

/// Every link, whether it is a body or fixed to one.
fn check_placements(
    robot: &dyn Robot,
    q: &[f64],
    reference: &Reference,
    sample: Sample<'_>,
    tolerances: Tolerances,
    errors: &mut Errors,
) {
    let Some(expected) = sample.optional("link_placements") else {
        return;
    };
    let found = placements(robot, q);
    let links = reference.links();
    assert_eq!(found.len(), links.len(), "each link is a body or a frame");
    let (mut rotations, mut origins) = (Vec::new(), Vec::new());
    for link in links {
        let placement = &found[link];
        rotations.extend_from_slice(placement.rotation.as_flattened());
        origins.extend_from_slice(&placement.origin);
    }
    let part = |range: std::ops::Range<usize>| {
        let parts = expected.chunks_exact(12).map(|link| &link[range.clone()]);
        parts.collect::<Vec<_>>().concat()
    };
    let error = relative_to(1.0, &rotations, &part(0..9));
    errors.add("link rotations", error, tolerances.values);
    let error = relative(&origins, &part(9..12));
    errors.add("link origins", error, tolerances.values);
}

/// Rates of angles are up to `1 / cos(theta_2)` times the angular velocity, at most 100 here: so many digits could be lost.
fn angles_agree_too(name: &str) {
    let reference = Reference::new(name);
    let compiled = (robot(name).angles.expect("it floats"))();
    let mut errors = Errors::default();
    for sample in reference.samples() {
        let v = sample.numbers("v");
        let motion = Motion::new(compiled.joints(), reference.joints(), sample, &v);
        assert!(motion.distance > 0.01, "{}", motion.distance);
    }
    check_dynamics(&*compiled, &reference, EXACT, &mut errors);
    check_rest(&*compiled, name, &reference, EXACT, &mut errors);
    errors.show(format!("{name}, angles"));
}

fn notes_agree_too(name: &str) {
    let mut errors = Errors::default();
    let compiled = robot(name)
        .notes
        .expect("it is compiled in the notes' formulation")();
    check_dynamics(&*compiled, &Reference::new(name), EXACT, &mut errors);
    errors.show(format!("{name}, the notes' formulation"));
}

#[test]
fn angles_agree_in_the_notes_formulation() {
    let mut errors = Errors::default();
    let compiled = SOLO12_ANGLES_NOTES();
    check_dynamics(&*compiled, &Reference::new("solo12"), EXACT, &mut errors);
    errors.show("solo12, angles, the notes' formulation");
}

fn snapping_costs_little(name: &str) {
    let reference = Reference::new(name);
    let compiled = (robot(name).snapped)();
    let mut errors = Errors::default();
    check_dynamics(&*compiled, &reference, SNAPPED, &mut errors);
    check_rest(&*compiled, name, &reference, SNAPPED, &mut errors);
    errors.show(format!("{name}, snapped"));
}

fn joints_and_limits_are_those_of_pinocchio(name: &str) {
    let reference = Reference::new(name);
    let robot = (robot(name).plain)();
    let (names, limits) = (robot.coordinate_names(), robot.limits());
    assert_eq!(robot.joints().len(), reference.joints().len());
    for (joint, expected) in robot.joints().iter().zip(reference.joints()) {
        assert_eq!(joint.name, text(&expected["name"]));
        if expected["type"] == "floating" {
            assert_eq!(joint.q, [0, 1, 2, 3, 4, 5, 6].map(Some));
            assert_eq!(joint.u, [0, 1, 2, 3, 4, 5].map(Some));
            let kinds = ["e0", "e1", "e2", "e3", "s1", "s2", "s3"];
            assert_eq!(names[..7], kinds.map(|kind| format!("root_joint_{kind}")));
            continue;
        }
        let places: Vec<usize> = joint.q.into_iter().flatten().collect();
        let speeds: Vec<usize> = joint.u.into_iter().flatten().collect();
        // In the same place as in Pinocchio's vectors, floating bases included.
        assert_eq!(places, [index(&expected["q_index"])]);
        assert_eq!(speeds, [index(&expected["v_index"])]);
        let (place, speed) = (places[0], speeds[0]);
        assert_eq!(names[place], joint.name.to_lowercase());
        let limit = |key: &str| expected["limit"].get(key).map_or(f64::INFINITY, number);
        let range = if expected["type"] == "continuous" {
            [f64::NEG_INFINITY, f64::INFINITY]
        } else {
            [limit("lower"), limit("upper")]
        };
        assert_eq!([limits.lower[place], limits.upper[place]], range);
        assert_eq!(limits.velocity[speed], limit("velocity"), "{}", joint.name);
        assert_eq!(limits.effort[speed], limit("effort"), "{}", joint.name);
    }
}

/// Makes a test of a check for each robot named.
macro_rules! robots {
    ($($check:ident: $($(#[$condition:meta])? $name:ident)+;)+) => {$(
        mod $check {$(
            $(#[$condition])?
            #[test]
            fn $name() {
                super::$check(stringify!($name));
            }
        )+}
    )+};
}

robots! {
    pinocchio_agrees: cartpole double_pendulum double_pendulum_continuous ur5 panda solo12 talos;
    angles_agree_too: solo12 #[cfg(every_system)] talos;
    notes_agree_too: cartpole double_pendulum double_pendulum_continuous ur5 panda solo12;
    snapping_costs_little: cartpole double_pendulum double_pendulum_continuous ur5 panda solo12 #[cfg(every_system)] talos;
    joints_and_limits_are_those_of_pinocchio: cartpole double_pendulum double_pendulum_continuous ur5 panda solo12 talos;
}
