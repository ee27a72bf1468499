//! Inverse kinematics of two systems by hand: a gantry, whose steps have a closed form, and a wrist of one axis.

use kane::functions::{Jacobian, Pose};
use kane::inverse_kinematics::{Goal, InverseKinematics, Limits, Step};
use kane::{Chart, Joint, Real, System};
use kane_test_support::compare::{Tolerance, assert_close, assert_within, distance};

use crate::common::{Turning, arrays, one_coordinate};

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A point that slides along three axes: its coordinates are its position, m.
struct Gantry;

/// The one frame of each.
struct Tool;

impl System<f64> for Gantry {
    arrays!(f64; 3, 3, 1);

    const NAME: &'static str = "gantry";
    const BODY_NAMES: &'static [&'static str] = &["tool"];
    const COORDINATE_NAMES: &'static [&'static str] = &["x", "y", "z"];
    const SPEED_NAMES: &'static [&'static str] = &["x_dot", "y_dot", "z_dot"];
    const LOWER_BODIES: &'static [usize] = &[0];
    const SPEED_BODIES: &'static [usize] = &[0, 0, 0];
    const JOINTS: &'static [Joint] = &[Joint {
        name: "gantry",
        chart: Chart::AngleRates,
        q: [None, None, None, None, Some(0), Some(1), Some(2)],
        u: [None, None, None, Some(0), Some(1), Some(2)],
    }];
    const LOWER_LIMITS: &'static [f64] = &[-1.0, -1.0, f64::NEG_INFINITY];
    const UPPER_LIMITS: &'static [f64] = &[0.5, 1.0, f64::INFINITY];

    fn q_dot(&self, _: &[f64; 3], u: &[f64; 3], q_dot: &mut [f64; 3]) {
        *q_dot = *u;
    }
}

impl Pose<f64, Tool> for Gantry {
    fn pose(&self, q: &[f64; 3], rotation: &mut [[f64; 3]; 3], position: &mut [f64; 3]) {
        (*rotation, *position) = (IDENTITY, *q);
    }
}

impl Jacobian<f64, Tool> for Gantry {
    const SPEEDS: &'static [usize] = &[0, 1, 2];

    fn jacobian(&self, _: &[f64; 3], linear: &mut [[f64; 3]; 3], angular: &mut [[f64; 3]; 3]) {
        (*linear, *angular) = (IDENTITY, [[0.0; 3]; 3]);
    }
}

#[test]
fn a_step_is_that_of_damped_least_squares() {
    let solver = InverseKinematics::new(Limits::none());
    let goal = Goal::<f64, Tool>::position([0.3, -0.4, 1.2]).weighing(2.0, 0.0);
    let step = solver.step(&Gantry, &goal, &[0.0; 3]);
    let weighted = 0.3_f64.powi(2) + 0.4_f64.powi(2) + 1.2_f64.powi(2);
    let damping = weighted + 2.0 * solver.least_damping;
    for (u, e) in step.u.iter().zip(goal.position) {
        let expected = 2.0 * e / (2.0 + damping);
        assert!((u - expected).abs() < 1e-15, "{u} and not {expected}");
    }
    assert!((step.remaining.weighted - weighted).abs() < 1e-15);
    assert_eq!(step.remaining.position, 1.2);
    assert_eq!(step.remaining.orientation, 0.0);
}

#[test]
fn goals_add_up() {
    let solver = InverseKinematics::new(Limits::none());
    let goal = |x: f64| Goal::<f64, Tool>::position([x, 0.0, 0.0]);
    let mut q = [0.2; 3];
    let remaining = solver.solve(&Gantry, &[goal(1.0), goal(2.0)], &mut q, 200);
    // Between the two, and half a metre off each.
    assert!((q[0] - 1.5).abs() < 1e-6, "{q:?}");
    assert!((remaining.position - 0.5).abs() < 1e-6, "{remaining:?}");
    let mut other = [0.2; 3];
    let nested = ((goal(1.0),), [goal(2.0)]);
    assert_eq!(solver.solve(&Gantry, &nested, &mut other, 200), remaining);
    assert_eq!(other, q);
}

#[test]
fn weights_times_a_number_are_the_same_goals() {
    let solver = InverseKinematics::new(Limits::none());
    let goal = Goal::<f64, Tool>::position([0.3, -0.4, 1.2]);
    let plain = solver.step::<_, _, 3>(&Gantry, &goal, &[0.0; 3]);
    for weight in [1e-12, 1e12] {
        let step = solver.step::<_, _, 3>(&Gantry, &goal.weighing(weight, 0.0), &[0.0; 3]);
        for (u, plain) in step.u.iter().zip(plain.u) {
            assert!((u - plain).abs() < 1e-13, "{u} and not {plain}");
        }
    }
}

#[test]
fn a_joint_stops_at_its_limit_and_the_others_go_on() {
    let solver = InverseKinematics::new(Limits::of::<Gantry>());
    let goal = Goal::<f64, Tool>::position([0.8, 0.6, -3.0]);
    // It begins beyond a limit, and is brought back.
    let mut q = [0.0, -4.0, 0.0];
    let remaining = solver.solve(&Gantry, &goal, &mut q, 200);
    assert_eq!(q[0], 0.5);
    assert!(
        (q[1] - 0.6).abs() < 1e-5 && (q[2] + 3.0).abs() < 1e-5,
        "{q:?}"
    );
    assert!((remaining.position - 0.3).abs() < 1e-15, "{remaining:?}");
    // A joint at its limit leaves it when that helps.
    let goal = Goal::<f64, Tool>::position([0.1, 0.6, -3.0]);
    let remaining = solver.solve(&Gantry, &goal, &mut q, 50);
    assert!(remaining.is_within(1e-6), "{remaining:?}");
}

/// The length of the step to a goal that is this far, with its least damping.
fn step_length(away: f64, weight: f64) -> f64 {
    let solver = InverseKinematics::new(Limits::none());
    let goal = Goal::<f64, Tool>::position([0.6 * away, 0.0, -0.8 * away]).weighing(weight, 0.0);
    let step = solver.step::<_, _, 3>(&Gantry, &goal, &[0.0; 3]);
    step.u.iter().map(|u| u * u).sum::<f64>().sqrt()
}

#[test]
fn steps_are_no_longer_than_told_however_far_the_goal_is() {
    let longest = 0.5_f64.sqrt();
    for weight in [1e-9, 1.0, 1e9] {
        for exponent in -40..=80 {
            let length = step_length(f64::from(exponent).exp2(), weight);
            assert!(length <= longest + 1e-15, "{length} at {exponent}");
        }
        assert_within(
            "longest",
            step_length(2.0_f64.sqrt(), weight) - longest,
            1e-11,
        );
        // Far away it is shorter.
        assert!(step_length(1e3, weight) < 0.01);
    }
}

#[test]
fn near_a_goal_each_step_squares_the_error_at_least() {
    let solver = InverseKinematics::new(Limits::none());
    let hinge = Hinge { axis: 1 };
    for away in [0.3, 0.1, 1e-2, 1e-3, 1e-4] {
        let mut rotation = IDENTITY;
        hinge.pose(&[0.5 + away], &mut rotation, &mut [0.0; 3]);
        let step = solver.step(&hinge, &Goal::<f64, Tool>::orientation(rotation), &[0.5]);
        assert_within(away, step.u[0] - away, away * away);
    }
}

#[test]
fn an_advance_ends_at_the_limit_exactly() {
    let solver = InverseKinematics::new(Limits::of::<Gantry>());
    for begin in [0.1, 0.2, 0.3, 0.4] {
        let q = [begin, -0.5, 0.0];
        // A sum may pass the limit by rounding, and a longer step by more.
        for beyond in [0.0, 1e-16, 0.2] {
            let next = solver.advance(&Gantry, &q, &[0.5 - begin + beyond, -2.0, 7.0]);
            assert!(next[0] <= 0.5 && next[0] >= 0.5 - 1e-16, "{next:?}");
            assert_eq!(next[1..], [-1.0, 7.0]);
        }
    }
}

#[test]
fn a_goal_for_the_orientation_leaves_the_position_free() {
    let rotation = kane::rotation::exp(&[0.1, 0.2, 0.3]);
    let goal = Goal::<f64, Tool>::orientation(rotation);
    assert_eq!(goal, Goal::pose(rotation, [0.0; 3]).weighing(0.0, 1.0));
    let step = InverseKinematics::new(Limits::none()).step(&Gantry, &goal, &[3.0; 3]);
    assert_eq!(step.u, [0.0; 3]);
    assert_eq!(step.remaining.position, 0.0);
    assert!(step.remaining.orientation > 0.1);
}

#[test]
fn negative_weights_count_as_zero_and_nan_reaches_nothing() {
    let solver = InverseKinematics::new(Limits::none());
    let goal = Goal::<f64, Tool>::pose(kane::rotation::exp(&[0.1, 0.2, 0.3]), [1.0, 2.0, 0.0]);
    let step = |position, orientation| -> Step<f64, 3> {
        solver.step(&Gantry, &goal.weighing(position, orientation), &[0.0; 3])
    };
    assert_eq!(step(-2.0, 3.0), step(0.0, 3.0));
    assert_eq!(step(2.0, -3.0), step(2.0, 0.0));
    for weights in [(f64::NAN, 0.0), (0.0, f64::NAN), (1.0, f64::NAN)] {
        let unknown = goal.weighing(weights.0, weights.1);
        let mut q = [0.5; 3];
        let remaining = solver.solve(&Gantry, &unknown, &mut q, 20);
        assert_eq!(q, [0.5; 3]);
        assert!(remaining.weighted.is_nan() && !remaining.is_within(0.1));
        assert!(step(weights.0, weights.1).u[0].is_nan());
    }
}

/// Two sliders along the same axis, the first of which has a limit.
struct Telescope;

impl System<f64> for Telescope {
    arrays!(f64; 2, 2, 2);

    const NAME: &'static str = "telescope";
    const BODY_NAMES: &'static [&'static str] = &["tube", "tool"];
    const COORDINATE_NAMES: &'static [&'static str] = &["tube", "tool"];
    const SPEED_NAMES: &'static [&'static str] = &["tube_dot", "tool_dot"];
    const LOWER_BODIES: &'static [usize] = &[0, 1];
    const SPEED_BODIES: &'static [usize] = &[0, 1];
    const UPPER_LIMITS: &'static [f64] = &[0.1, f64::INFINITY];

    fn q_dot(&self, _: &[f64; 2], u: &[f64; 2], q_dot: &mut [f64; 2]) {
        *q_dot = *u;
    }
}

impl Pose<f64, Tool> for Telescope {
    fn pose(&self, q: &[f64; 2], rotation: &mut [[f64; 3]; 3], position: &mut [f64; 3]) {
        (*rotation, *position) = (IDENTITY, [q[0] + 2.0 * q[1], 0.0, 0.0]);
    }
}

impl Jacobian<f64, Tool> for Telescope {
    const SPEEDS: &'static [usize] = &[0, 1];

    fn jacobian(&self, _: &[f64; 2], linear: &mut [[f64; 2]; 3], angular: &mut [[f64; 2]; 3]) {
        (*linear, *angular) = ([[0.0; 2]; 3], [[0.0; 2]; 3]);
        linear[0] = [1.0, 2.0];
    }
}

#[test]
fn what_a_joint_held_at_its_limit_does_counts_for_the_others() {
    let solver = InverseKinematics::new(Limits::of::<Telescope>());
    let goal = Goal::<f64, Tool>::position([1.0, 0.0, 0.0]);
    let step = solver.step(&Telescope, &goal, &[0.0; 2]);
    // The least of `(0.1 + 2 u - 1)² + λ u²`.
    let damping = 0.5 + 4.0 * solver.least_damping;
    let expected = [0.1, 2.0 * (1.0 - 0.1) / (4.0 + damping)];
    assert_close("u", &step.u, &expected, Tolerance::absolute(1e-15));
}

/// A hinge about one axis of the inertial frame, by number.
struct Hinge {
    axis: usize,
}

one_coordinate!([f64] Hinge, "hinge", body "tool", coordinate "theta");

impl Pose<f64, Tool> for Hinge {
    fn pose(&self, q: &[f64; 1], rotation: &mut [[f64; 3]; 3], position: &mut [f64; 3]) {
        let (sine, cosine) = <f64 as Real>::sin_cos(q[0]);
        let (j, k) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        (*rotation, *position) = (IDENTITY, [0.0; 3]);
        (rotation[j][j], rotation[k][k]) = (cosine, cosine);
        (rotation[j][k], rotation[k][j]) = (sine, -sine);
    }
}

impl Jacobian<f64, Tool> for Hinge {
    const SPEEDS: &'static [usize] = &[0];

    fn jacobian(&self, _: &[f64; 1], linear: &mut [[f64; 1]; 3], angular: &mut [[f64; 1]; 3]) {
        (*linear, *angular) = ([[0.0]; 3], [[0.0]; 3]);
        angular[self.axis] = [1.0];
    }
}

#[test]
fn what_is_missing_of_a_turn_is_along_its_axis_for_any_angle() {
    for axis in 0..3 {
        for tenths in -31..=31 {
            let angle = f64::from(tenths) / 10.0;
            let hinge = Hinge { axis };
            let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
            hinge.pose(&[0.5 + angle], &mut rotation, &mut position);
            let goal = Goal::<f64, Tool>::pose(rotation, position);
            let mut solver = InverseKinematics::new(Limits::none());
            solver.tolerance = 1e-12;

            let step = solver.step(&hinge, &goal, &[0.5]);
            let chord = 2.0 * <f64 as Real>::sin_cos(angle / 2.0).0;
            let weighted = 8.0 * <f64 as Real>::sin_cos(angle / 4.0).0.powi(2);
            let expected = chord / (1.0 + weighted + solver.least_damping);
            assert!((step.remaining.weighted - weighted).abs() < 1e-13);
            assert!((step.u[0] - expected).abs() < 1e-13, "{axis} {angle}");
            assert!((step.remaining.orientation - chord.abs()).abs() < 1e-13);

            let mut q = [0.5];
            let remaining = solver.solve(&hinge, &goal, &mut q, 30);
            assert!(remaining.is_within(1e-12), "{axis} {angle}: {remaining:?}");
            assert!((q[0] - 0.5 - angle).abs() < 2e-12, "{axis} {angle}: {q:?}");
        }
    }
}

/// A frame on the ball of [`Turning`], whose angles have angular velocities as speeds.
struct OnBall;

impl Pose<f64, OnBall> for Turning {
    fn pose(&self, q: &[f64; 11], rotation: &mut [[f64; 3]; 3], position: &mut [f64; 3]) {
        let [(s1, c1), (s2, c2), (s3, c3)] = [q[0], q[1], q[2]].map(<f64 as Real>::sin_cos);
        *rotation = [
            [c2 * c3, s1 * s2 * c3 + c1 * s3, s1 * s3 - c1 * s2 * c3],
            [-c2 * s3, c1 * c3 - s1 * s2 * s3, s1 * c3 + c1 * s2 * s3],
            [s2, -s1 * c2, c1 * c2],
        ];
        *position = [0.0; 3];
    }
}

impl Jacobian<f64, OnBall> for Turning {
    const SPEEDS: &'static [usize] = &[0, 1, 2];

    fn jacobian(&self, q: &[f64; 11], linear: &mut [[f64; 10]; 3], angular: &mut [[f64; 10]; 3]) {
        let (mut rotation, mut position) = (IDENTITY, [0.0; 3]);
        self.pose(q, &mut rotation, &mut position);
        (*linear, *angular) = ([[0.0; 10]; 3], [[0.0; 10]; 3]);
        for (axis, row) in rotation.iter().enumerate() {
            for (i, entry) in row.iter().enumerate() {
                angular[i][axis] = *entry;
            }
        }
    }
}

#[test]
fn angles_near_their_singularity_reach_the_goal_and_stay_small() {
    let goal = Goal::<f64, OnBall>::pose(kane::rotation::exp(&[0.7, -0.4, 0.9]), [0.0; 3]);
    let solver = InverseKinematics::new(Limits::none());
    for away in [0.0, 1e-15, 1e-11, 1e-7, 1e-3] {
        let mut q = [0.0; 11];
        q[4] = 1.0;
        q[1] = core::f64::consts::FRAC_PI_2 - away;
        let remaining = solver.solve(&Turning, &goal, &mut q, 100);
        assert!(remaining.is_within(1e-6), "{away}: {remaining:?}");
        // Each of some steps changes an angle by half a turn at most.
        assert!(
            q[..3].iter().all(|angle| angle.abs() < 30.0),
            "{away}: {q:?}"
        );
        let (mut rotation, mut position) = (IDENTITY, [0.0; 3]);
        Turning.pose(&q, &mut rotation, &mut position);
        let missed = distance(rotation.as_flattened(), goal.rotation.as_flattened());
        assert_within(away, missed, 2e-6);
    }
}
