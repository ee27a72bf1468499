//! Functions of a frame, compiled: through the runtime's traits as by name, and velocities as rates of poses.

use kane::functions::{Local, Pose, Velocity};
use kane_test_robots::panda_frames::{
    NQ, NU, Prepared, frames::PandaHandTcp, panda_hand_tcp_pose,
    panda_hand_tcp_pose_and_panda_hand_tcp_velocity, panda_hand_tcp_velocity,
    panda_hand_tcp_velocity_local,
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// Sums of some hundred products in another order.
const EXACT: Tolerance = Tolerance::relative_beyond(1.0, 1e-13);

/// Differences of fourth order at a step of 1e-3: truncation and rounding leave less than this.
const DIFFERENCED: Tolerance = Tolerance::relative_beyond(1.0, 1e-9);

const STEP: f64 = 1e-3;

/// A pose: nine entries of the rotation, three of the position.
fn pose<F, S: Pose<f64, F>>(system: &S, q: &S::Q) -> [f64; 12] {
    let (mut rotation, mut position) = ([[f64::NAN; 3]; 3], [f64::NAN; 3]);
    system.pose(q, &mut rotation, &mut position);
    let mut entries = rotation.as_flattened().iter().chain(&position);
    std::array::from_fn(|_| *entries.next().expect("twelve entries"))
}

fn velocity<F, S: Velocity<f64, F>>(system: &S, q: &S::Q, u: &S::U) -> [[f64; 3]; 2] {
    let [mut linear, mut angular] = [[f64::NAN; 3]; 2];
    system.velocity(q, u, &mut linear, &mut angular);
    [linear, angular]
}

fn states() -> impl Iterator<Item = ([f64; NQ], [f64; NU])> {
    (1..=10).map(|seed| {
        let mut random = Random::new(seed);
        let q = [(); NQ].map(|()| random.between(-2.0, 2.0));
        (q, [(); NU].map(|()| random.between(-1.0, 1.0)))
    })
}

#[test]
fn traits_call_the_functions_of_the_frame() {
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let (mut rotation, mut position) = ([[f64::NAN; 3]; 3], [f64::NAN; 3]);
        panda_hand_tcp_pose(&system, &q, &mut rotation, &mut position);
        let by_name = [rotation.as_flattened(), &position].concat();
        assert_eq!(pose::<PandaHandTcp, _>(&system, &q)[..], by_name);

        let [mut linear, mut angular] = [[f64::NAN; 3]; 2];
        panda_hand_tcp_velocity(&system, &q, &u, &mut linear, &mut angular);
        assert_eq!(
            velocity::<PandaHandTcp, _>(&system, &q, &u),
            [linear, angular]
        );

        panda_hand_tcp_velocity_local(&system, &q, &u, &mut linear, &mut angular);
        assert_eq!(
            velocity::<Local<PandaHandTcp>, _>(&system, &q, &u),
            [linear, angular]
        );
    }
}

#[test]
fn velocities_are_rates_of_poses() {
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let at = |t: f64| {
            let moved = std::array::from_fn(|place| q[place] + t * u[place]);
            pose::<PandaHandTcp, _>(&system, &moved)
        };
        let (near, far) = ([at(STEP), at(-STEP)], [at(2.0 * STEP), at(-2.0 * STEP)]);
        let rate: [f64; 12] = std::array::from_fn(|place| {
            let [near, far] = [near, far].map(|[after, before]| after[place] - before[place]);
            (8.0 * near - far) / (12.0 * STEP)
        });
        let now = at(0.0);
        // Of the matrix to inertial components, A_dot A^T is the tilde of the angular velocity.
        let entry =
            |i: usize, j: usize| -> f64 { (0..3).map(|k| rate[3 * k + i] * now[3 * k + j]).sum() };
        let [linear, angular] = velocity::<PandaHandTcp, _>(&system, &q, &u);
        assert_close("linear", &linear, &rate[9..], DIFFERENCED);
        let turning = [entry(2, 1), entry(0, 2), entry(1, 0)];
        assert_close("angular", &angular, &turning, DIFFERENCED);

        let local = velocity::<Local<PandaHandTcp>, _>(&system, &q, &u);
        for (local, inertial) in local.iter().zip([linear, angular]) {
            let row = |i: usize| -> f64 { (0..3).map(|j| now[3 * i + j] * inertial[j]).sum() };
            assert_close("local", local, &[row(0), row(1), row(2)], EXACT);
        }
    }
}

#[test]
fn pose_and_velocity_in_one_are_those_alone() {
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let (mut rotation, mut position) = ([[f64::NAN; 3]; 3], [f64::NAN; 3]);
        let [mut linear, mut angular] = [[f64::NAN; 3]; 2];
        panda_hand_tcp_pose_and_panda_hand_tcp_velocity(
            &system,
            &q,
            &u,
            &mut rotation,
            &mut position,
            &mut linear,
            &mut angular,
        );
        let found = [rotation.as_flattened(), &position].concat();
        assert_close("pose", &found, &pose::<PandaHandTcp, _>(&system, &q), EXACT);
        let expected = velocity::<PandaHandTcp, _>(&system, &q, &u);
        assert_close(
            "velocity",
            &[linear, angular].concat(),
            expected.as_flattened(),
            EXACT,
        );
    }
}
