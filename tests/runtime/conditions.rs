//! Systems under conditions: what they have of the system, and what they have not.

use kane::conditions::{Driven, Loaded};
use kane::functions::{ForwardDynamics, HybridDynamics, LoadedForwardDynamics};
use kane::integrate::rk4_step;
use kane::{Chart, Cost, Frame, Joint, Load, System};
use kane_test_support::compare::{Tolerance, assert_close, assert_within};

use crate::common::arrays;

const ROUNDED: Tolerance = Tolerance::absolute(1e-15);

/// A ball on a quaternion, with a value in every constant. It can neither be copied nor printed.
struct Ball;

impl System<f64> for Ball {
    arrays!(f64; 4, 3, 1);

    const NAME: &'static str = "ball";
    const BODY_NAMES: &'static [&'static str] = &["body"];
    const COORDINATE_NAMES: &'static [&'static str] = &["e0", "e1", "e2", "e3"];
    const SPEED_NAMES: &'static [&'static str] = &["w1", "w2", "w3"];
    const LOWER_BODIES: &'static [usize] = &[0];
    const SPEED_BODIES: &'static [usize] = &[0, 0, 0];
    const JOINTS: &'static [Joint] = &[Joint {
        name: "socket",
        chart: Chart::EulerParameters,
        q: [Some(0), Some(1), Some(2), Some(3), None, None, None],
        u: [Some(0), Some(1), Some(2), None, None, None],
    }];
    const FRAMES: &'static [Frame] = &[Frame {
        name: "mark",
        body: Some(0),
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        position: [0.1, 0.2, 0.3],
    }];
    const LOWER_LIMITS: &'static [f64] = &[-1.0, -2.0, -3.0, -4.0];
    const UPPER_LIMITS: &'static [f64] = &[1.0, 2.0, 3.0, 4.0];
    const VELOCITY_LIMITS: &'static [f64] = &[5.0, 6.0, 7.0];
    const EFFORT_LIMITS: &'static [f64] = &[8.0, 9.0, 10.0];
    const FRICTION: &'static [f64] = &[0.1, 0.2, 0.3];
    const FINGERPRINT: u64 = 11;
    const OPERATIONS: &'static [Cost] = &[Cost::new("loaded_forward_dynamics", [0, 3, 0, 0])];

    fn q_dot(&self, [e0, e1, e2, e3]: &[f64; 4], [w1, w2, w3]: &[f64; 3], q_dot: &mut [f64; 4]) {
        *q_dot = [
            -0.5 * (e1 * w1 + e2 * w2 + e3 * w3),
            0.5 * (e0 * w1 + e2 * w3 - e3 * w2),
            0.5 * (e0 * w2 + e3 * w1 - e1 * w3),
            0.5 * (e0 * w3 + e1 * w2 - e2 * w1),
        ];
    }

    fn normalize(&self, q: &mut [f64; 4]) {
        kane::manifold::scale_quaternions(self, q);
    }
}

impl LoadedForwardDynamics<f64> for Ball {
    fn loaded_forward_dynamics(
        &self,
        _: &[f64; 4],
        _: &[f64; 3],
        tau: &[f64; 3],
        loads: &[Load<f64>; 1],
        u_dot: &mut [f64; 3],
    ) {
        *u_dot = [0, 1, 2].map(|i| tau[i] + loads[0].moment[i]);
    }
}

impl HybridDynamics<f64> for Ball {
    const PRESCRIBED: &'static [bool] = &[true, false, false];

    fn hybrid_dynamics(
        &self,
        _: &[f64; 4],
        _: &[f64; 3],
        u_dot: &[f64; 3],
        tau: &[f64; 3],
        whole_u_dot: &mut [f64; 3],
        whole_tau: &mut [f64; 3],
    ) {
        *whole_u_dot = [u_dot[0], tau[1], tau[2]];
        *whole_tau = *whole_u_dot;
    }
}

const LOADS: [Load<f64>; 1] = [Load {
    force: [0.0; 3],
    moment: [0.5, -0.25, 1.0],
}];

fn loaded() -> Loaded<'static, f64, Ball> {
    Loaded {
        system: &Ball,
        loads: LOADS,
    }
}

fn driven() -> Driven<'static, f64, Ball> {
    Driven {
        system: &Ball,
        u_dot: [2.0, f64::NAN, f64::NAN],
    }
}

fn has_the_constants_of_the_ball<S: System<f64>>(_: &S) {
    assert_eq!(S::NAME, Ball::NAME);
    assert_eq!(S::BODY_NAMES, Ball::BODY_NAMES);
    assert_eq!(S::COORDINATE_NAMES, Ball::COORDINATE_NAMES);
    assert_eq!(S::SPEED_NAMES, Ball::SPEED_NAMES);
    assert_eq!(S::LOWER_BODIES, Ball::LOWER_BODIES);
    assert_eq!(S::SPEED_BODIES, Ball::SPEED_BODIES);
    assert_eq!(S::JOINTS, Ball::JOINTS);
    assert_eq!(S::FRAMES, Ball::FRAMES);
    assert_eq!(S::LOWER_LIMITS, Ball::LOWER_LIMITS);
    assert_eq!(S::UPPER_LIMITS, Ball::UPPER_LIMITS);
    assert_eq!(S::VELOCITY_LIMITS, Ball::VELOCITY_LIMITS);
    assert_eq!(S::EFFORT_LIMITS, Ball::EFFORT_LIMITS);
    assert_eq!(S::FRICTION, Ball::FRICTION);
    assert_eq!(S::FINGERPRINT, Ball::FINGERPRINT);
    // Its functions are others.
    assert_eq!(S::OPERATIONS, []);
}

#[test]
fn a_system_under_conditions_has_all_constants_of_the_system_but_its_costs() {
    has_the_constants_of_the_ball(&loaded());
    has_the_constants_of_the_ball(&driven());
}

/// A step of half a second from rest at `q`.
fn step<S>(system: &S, mut q: [f64; 4]) -> ([f64; 4], [f64; 3])
where
    S: ForwardDynamics<f64> + System<f64, Q = [f64; 4], U = [f64; 3]>,
{
    let mut u = [0.0; 3];
    rk4_step(system, &[1.0, 2.0, 4.0], 0.5, &mut q, &mut u);
    (q, u)
}

#[test]
fn a_step_under_conditions_heeds_the_system_s_own_normalize() {
    let long = [0.6 * 1.001, 0.0, 0.8 * 1.001, 0.0];
    for (what, q) in [
        ("loaded", step(&loaded(), long).0),
        ("driven", step(&driven(), long).0),
    ] {
        let square: f64 = q.iter().map(|entry| entry * entry).sum();
        assert_within(what, square - 1.0, 1e-14);
    }
}

#[test]
fn steps_move_by_what_is_given() {
    let (_, pushed) = step(&loaded(), [1.0, 0.0, 0.0, 0.0]);
    assert_close("loaded", &pushed, &[0.75, 0.875, 2.5], ROUNDED);
    let (_, moved) = step(&driven(), [1.0, 0.0, 0.0, 0.0]);
    assert_close("driven", &moved, &[1.0, 1.0, 2.0], ROUNDED);
}

#[test]
fn conditions_are_copied_and_printed_whatever_the_system_is() {
    let (pushed, moved) = (loaded(), driven());
    let copies = (pushed, moved);
    assert_eq!(copies.0.loads, pushed.loads);
    assert_eq!(copies.1.u_dot[0], moved.u_dot[0]);
    assert_eq!(
        format!("{moved:?}"),
        r#"Driven { system: "ball", u_dot: [2.0, NaN, NaN] }"#
    );
    assert!(format!("{pushed:?}").starts_with(r#"Loaded { system: "ball", loads: [Load {"#));
}
