//! Floating bases in both charts: conversion of states, length of quaternions, and what integration conserves.

use std::f64::consts::FRAC_PI_2;

use kane_test_support::{
    compare::{distance, relative},
    errors::Errors,
    numeric::dot,
    random::Random,
};

use crate::common::{
    cross,
    mass::{mass_center, masses},
    motion::Motion,
    placements,
    reference::Reference,
    robot,
};
use kane::{
    System,
    chart::{ConvertError, Turning, convert},
};
use kane_test_robots::{Robot, panda, solo12, solo12_angles};

type Quaternion = solo12::Prepared<f64>;
type Angles = solo12_angles::Prepared<f64>;
type Q<S> = <S as System<f64>>::Q;
type U<S> = <S as System<f64>>::U;

/// Relative to a quantity's largest entry: sums of some hundred products, each rounded to 1e-16.
const EXACT: f64 = 1e-13;
/// Of an integration in steps of 4 ms, relative: motions of some 0.1 s, of which a step is a 25th, so 2e-6 to fourth order,
/// times the method's own constants, which are below a hundredth. That it is of this order is tested by itself.
const DRIFT: f64 = 1e-7;

/// solo12 by a quaternion, and by angles.
fn both() -> [Box<dyn Robot>; 2] {
    let compiled = robot("solo12");
    [(compiled.plain)(), (compiled.angles.expect("it floats"))()]
}

/// The reference's states of solo12.
fn states() -> Vec<(Q<Quaternion>, U<Quaternion>)> {
    let reference = Reference::new("solo12");
    let [robot, _] = both();
    let states = reference.samples().map(|sample| {
        let v = sample.numbers("v");
        let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
        let q = motion.q.try_into().expect("as many coordinates");
        let u = motion.u.try_into().expect("as many speeds");
        (q, u)
    });
    states.collect()
}

/// Requires that two states are one motion, to `loss` times rounding.
fn same_motion(
    (q, u): (&Q<Quaternion>, &U<Quaternion>),
    (q_angles, u_angles): (&Q<Angles>, &U<Angles>),
    loss: f64,
    errors: &mut Errors,
) {
    let [by_quaternion, by_angles] = both();
    same_placements(q, q_angles, errors);
    let values = |robot: &dyn Robot, q: &[f64], u: &[f64]| {
        let energy = [robot.kinetic_energy(q, u)];
        [
            ("kinetic energy", energy.to_vec()),
            ("linear momentum", robot.linear_momentum(q, u).to_vec()),
            ("angular momentum", robot.angular_momentum(q, u).to_vec()),
        ]
    };
    let found = values(&*by_angles, q_angles, u_angles);
    for ((what, found), (_, expected)) in found.iter().zip(values(&*by_quaternion, q, u)) {
        errors.add(what, relative(found, &expected) / loss, EXACT);
    }
}

fn same_placements(q: &Q<Quaternion>, q_angles: &Q<Angles>, errors: &mut Errors) {
    let [by_quaternion, by_angles] = both();
    let (found, expected) = (
        placements(&*by_angles, q_angles),
        placements(&*by_quaternion, q),
    );
    assert!(found.keys().eq(expected.keys()));
    for (found, expected) in found.values().zip(expected.values()) {
        let rotations = [found, expected].map(|at| at.rotation.as_flattened().to_vec());
        errors.add("rotations", distance(&rotations[0], &rotations[1]), EXACT);
        errors.add("origins", relative(&found.origin, &expected.origin), EXACT);
    }
}

/// Of the two quaternions of a rotation the one that is nearer to the other's.
fn toward(mut q: Q<Quaternion>, other: &Q<Quaternion>) -> Q<Quaternion> {
    if dot(&q[..4], &other[..4]) < 0.0 {
        for e in &mut q[..4] {
            *e = -*e;
        }
    }
    q
}

#[test]
fn conversion_keeps_the_motion_and_returns() {
    let mut errors = Errors::default();
    for (q, u) in states() {
        let (q_angles, u_angles) = convert::<Quaternion, Angles>(&q, &u).expect("one model");
        let loss = loss(&q_angles);
        same_motion((&q, &u), (&q_angles, &u_angles), loss, &mut errors);
        let (q_back, u_back) =
            convert::<Angles, Quaternion>(&q_angles, &u_angles).expect("as well");
        errors.add("q there and back", distance(&toward(q_back, &q), &q), EXACT);
        errors.add("u there and back", relative(&u_back, &u) / loss, EXACT);
        let (again, u_again) = convert::<Quaternion, Angles>(&q_back, &u_back).expect("as before");
        errors.add("angles and back", distance(&again, &q_angles) / loss, EXACT);
        errors.add(
            "rates and back",
            relative(&u_again, &u_angles) / loss,
            EXACT,
        );
    }
    errors.show("solo12, in states of the reference");
}

/// How much larger rates of angles can be than the angular velocity: `1 / cos(theta_2)`. As much of the digits is lost.
fn loss(q: &Q<Angles>) -> f64 {
    let (_, c2) = kane::Real::sin_cos(q[1]);
    1.0 / c2.abs()
}

/// Orientations do not suffer where angles are singular; what is made of their rates, digits in proportion.
#[test]
fn conversion_is_exact_in_orientation_near_the_singularity() {
    let mut errors = Errors::default();
    let mut random = Random::new(1);
    for (q, u) in states() {
        for exponent in 1..=12 {
            let near = FRAC_PI_2 - 10_f64.powi(-exponent);
            for theta2 in [near, -near] {
                let theta = [3.0 * random.symmetric(), theta2, 3.0 * random.symmetric()];
                let mut q = q;
                let turning = Turning::from_angles(theta, [u[0], u[1], u[2]]);
                q[..4].copy_from_slice(&turning.e);
                let (q_angles, u_angles) =
                    convert::<Quaternion, Angles>(&q, &u).expect("one model");
                let loss = loss(&q_angles);
                // Half of the digits are gone from here on.
                if exponent <= 8 {
                    same_motion((&q, &u), (&q_angles, &u_angles), loss, &mut errors);
                }
                same_placements(&q, &q_angles, &mut errors);
                let (q_back, _) =
                    convert::<Angles, Quaternion>(&q_angles, &u_angles).expect("as well");
                errors.add("q there and back", distance(&toward(q_back, &q), &q), EXACT);
            }
        }
        let mut q = q;
        let turning = Turning::from_angles(
            [random.symmetric(), FRAC_PI_2, random.symmetric()],
            [0.0; 3],
        );
        q[..4].copy_from_slice(&turning.e);
        let (q_angles, _) = convert::<Quaternion, Angles>(&q, &u).expect("one model");
        same_placements(&q, &q_angles, &mut errors);
    }
    errors.show("solo12, near the singularity of its angles");
}

#[test]
fn conversion_to_another_robot_is_refused() {
    let (q, u) = states()[0];
    let refused = convert::<Quaternion, panda::Prepared<f64>>(&q, &u);
    assert_eq!(refused.err(), Some(ConvertError::OtherJoints { joint: 0 }));
}

#[test]
fn normalizing_keeps_the_rotation_and_brings_the_length_back() {
    let [robot, _] = both();
    for (q, _) in states() {
        for off in [0.1, -0.1, 1e-2, -1e-2, 1e-4, -1e-6, 0.0] {
            let mut scaled = q;
            for e in &mut scaled[..4] {
                *e *= 1.0 + off;
            }
            let normalized = robot.normalize(&scaled);
            assert_eq!(normalized[4..], q[4..], "all other coordinates are copied");
            let length = dot(&normalized[..4], &normalized[..4]).sqrt();
            // 1 + d becomes 1 - 1.5 d^2 (1 + d/3), twice; and rounding of a dozen operations.
            let remains = 1.5_f64.powi(3) * (off * off * (1.0 + off / 3.0)).powi(2) + 1e-15;
            assert!((length - 1.0).abs() <= remains, "{off}: {length:e}");
            // Against e / |e|: the direction, that is the rotation, is the same to rounding, however far the length was off.
            let direction: Vec<f64> = normalized[..4].iter().map(|e| e / length).collect();
            assert!(distance(&direction, &q[..4]) <= 1e-15, "{off}");
        }
    }
}

/// What integration of 0.2 s leaves of what stays as it is, in three states of the reference.
fn drift(dt: f64, steps: u16) -> Errors {
    let [robot, by_angles] = both();
    let masses = masses("solo12", true);
    let mass: f64 = masses.iter().sum();
    let about_center = |q: &[f64], u: &[f64]| {
        let center = mass_center(&*robot, q, &masses);
        let moved = cross(center, robot.linear_momentum(q, u));
        let about_origin = robot.angular_momentum(q, u);
        [0, 1, 2].map(|i| about_origin[i] - moved[i])
    };
    let energy = |q: &[f64], u: &[f64]| robot.kinetic_energy(q, u) + robot.potential_energy(q);
    let free = [0.0; solo12::NU];
    let mut errors = Errors::default();
    for (q_0, u_0) in states().into_iter().take(3) {
        let (mut q, mut u) = (q_0.to_vec(), u_0.to_vec());
        let (q_a, u_a) = convert::<Quaternion, Angles>(&q_0, &u_0).expect("one model");
        let (mut q_a, mut u_a) = (q_a.to_vec(), u_a.to_vec());
        for _ in 0..steps {
            (q, u) = robot.step(&q, &u, &free, dt);
            (q_a, u_a) = by_angles.step(&q_a, &u_a, &free, dt);
            let length = dot(&q[..4], &q[..4]).sqrt();
            errors.add("length of the quaternion", (length - 1.0).abs(), 1e-15);
        }
        let lost = (energy(&q, &u) - energy(&q_0, &u_0)).abs();
        errors.add("energy", lost / robot.kinetic_energy(&q_0, &u_0), DRIFT);
        let mut expected = robot.linear_momentum(&q_0, &u_0);
        expected[2] -= 9.81 * mass * dt * f64::from(steps);
        let error = relative(&robot.linear_momentum(&q, &u), &expected);
        errors.add("linear momentum", error, DRIFT);
        let error = relative(&about_center(&q, &u), &about_center(&q_0, &u_0));
        errors.add("angular momentum about the mass centre", error, DRIFT);
        let q_a = q_a.try_into().expect("as many coordinates");
        let u_a = u_a.try_into().expect("as many speeds");
        let (back, u_back) = convert::<Angles, Quaternion>(&q_a, &u_a).expect("one model");
        let q = q.try_into().expect("as many coordinates");
        errors.add(
            "q, integrated in angles",
            distance(&toward(back, &q), &q),
            DRIFT,
        );
        errors.add("u, integrated in angles", relative(&u_back, &u), DRIFT);
    }
    errors
}

/// Without `tau`, in free fall: energy stays, momentum changes by weight alone, and angles or a quaternion is one.
#[test]
fn integration_conserves_what_it_must_to_fourth_order() {
    let (coarse, fine) = (drift(4e-3, 50), drift(2e-3, 100));
    coarse.show("solo12 in free fall, steps of 4 ms");
    fine.show("solo12 in free fall, steps of 2 ms");
    for ((what, coarse), (_, fine)) in coarse.largest().iter().zip(fine.largest()) {
        // Half of the step leaves a 16th of an error of fourth order; rounding of 200 steps leaves 1e-13.
        assert!(
            *fine <= coarse / 12.0 + 1e-13,
            "{what}: {coarse:e}, {fine:e}"
        );
    }
}
