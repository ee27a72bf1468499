//! Functions of a frame, compiled: through the runtime's traits as by name, and velocities as rates of poses.

use kane::functions::{
    Acceleration, GeneralizedForce, Imu, Jacobian, JacobianDotU, JacobianPacked,
    LinearAcceleration, LinearGeneralizedForce, LinearJacobian, LinearJacobianDotU,
    LinearJacobianPacked, LinearOperationalInverseInertia, LinearVelocity, Local,
    OperationalInverseInertia, PointJacobian, Pose, Position, Seen, Velocity,
};
use kane_test_robots::panda_frames::{
    NQ, NU, Prepared,
    frames::{PandaHandTcp, PandaLink4},
    panda_hand_tcp_pose, panda_hand_tcp_pose_and_panda_hand_tcp_velocity, panda_hand_tcp_velocity,
    panda_hand_tcp_velocity_local,
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// Sums of some hundred products in another order.
const EXACT: Tolerance = Tolerance::relative_beyond(1.0, 1e-13);

/// The same where the mass matrix is inverted.
const INVERTED: Tolerance = Tolerance::relative_beyond(1.0, 1e-11);

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

/// Rows of a Jacobian times speeds.
fn times<U: kane::Array<f64>>(rows: &[U; 3], u: &[f64]) -> [f64; 3] {
    rows.each_ref()
        .map(|row| row.as_ref().iter().zip(u).map(|(a, b)| a * b).sum())
}

fn jacobian<F, S: Jacobian<f64, F>>(system: &S, q: &S::Q) -> [[S::U; 3]; 2] {
    let [mut linear, mut angular] = [[kane::Array::filled(f64::NAN); 3]; 2];
    system.jacobian(q, &mut linear, &mut angular);
    [linear, angular]
}

#[test]
fn jacobians_times_speeds_are_velocities() {
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let found = jacobian::<PandaHandTcp, _>(&system, &q).map(|rows| times(&rows, &u));
        let expected = velocity::<PandaHandTcp, _>(&system, &q, &u);
        assert_close(
            "inertial",
            found.as_flattened(),
            expected.as_flattened(),
            EXACT,
        );
        let found = jacobian::<Local<PandaHandTcp>, _>(&system, &q).map(|rows| times(&rows, &u));
        let expected = velocity::<Local<PandaHandTcp>, _>(&system, &q, &u);
        assert_close(
            "local",
            found.as_flattened(),
            expected.as_flattened(),
            EXACT,
        );
    }
}

#[test]
fn motions_of_the_origin_are_the_linear_part_of_the_frame_s() {
    type Hand = PandaHandTcp;
    type Own = Local<Hand>;
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let u_dot = std::array::from_fn(|place| q[place] - 2.0 * u[place]);
        let [mut found, mut linear, mut angular] = [[f64::NAN; 3]; 3];
        Position::<f64, PandaHandTcp>::position(&system, &q, &mut found);
        let expected = &pose::<PandaHandTcp, _>(&system, &q)[9..];
        assert_close("position", &found, expected, EXACT);

        LinearVelocity::<f64, Own>::linear_velocity(&system, &q, &u, &mut found);
        let [expected, _] = velocity::<Own, _>(&system, &q, &u);
        assert_close("velocity", &found, &expected, EXACT);

        LinearAcceleration::<f64, Hand>::linear_acceleration(&system, &q, &u, &u_dot, &mut found);
        Acceleration::<f64, Hand>::acceleration(&system, &q, &u, &u_dot, &mut linear, &mut angular);
        assert_close("acceleration", &found, &linear, EXACT);

        LinearJacobianDotU::<f64, Hand>::linear_jacobian_dot_u(&system, &q, &u, &mut found);
        system.jacobian_dot_u(&q, &u, &mut linear, &mut angular);
        assert_close("drift", &found, &linear, EXACT);

        let mut rows = [[f64::NAN; NU]; 3];
        LinearJacobian::<f64, Hand>::linear_jacobian(&system, &q, &mut rows);
        let [expected, _] = jacobian::<Hand, _>(&system, &q);
        assert_close("rows", rows.as_flattened(), expected.as_flattened(), EXACT);

        let mut columns = [[f64::NAN; 4]; 3];
        LinearJacobianPacked::<f64, PandaLink4>::linear_jacobian_packed(&system, &q, &mut columns);
        let [expected, _] = jacobian::<PandaLink4, _>(&system, &q);
        for (packed, whole) in columns.iter().zip(&expected) {
            assert_close("columns", packed, &whole[..4], EXACT);
        }
    }
}

#[test]
fn forces_at_the_origin_are_wrenches_without_a_moment() {
    type Both = (PandaHandTcp, PandaLink4);
    let system = Prepared::<f64>::nominal();
    for (q, _) in states() {
        let force = [3.0, -1.0, 2.0];
        let [mut tau, mut of_wrench] = [[f64::NAN; NU]; 2];
        system.linear_generalized_force(&q, &force, &mut tau);
        system.generalized_force(&q, &force, &[0.0; 3], &mut of_wrench);
        assert_close("forces", &tau, &of_wrench, EXACT);

        let (mut points, mut frames) = ([[f64::NAN; 6]; 6], [[f64::NAN; 12]; 12]);
        LinearOperationalInverseInertia::<f64, Both>::linear_operational_inverse_inertia(
            &system,
            &q,
            &mut points,
        );
        system.operational_inverse_inertia(&q, &mut frames);
        let linear = [0, 1, 2, 6, 7, 8];
        let expected = linear.map(|row| linear.map(|column| frames[row][column]));
        let (points, expected) = (points.as_flattened(), expected.as_flattened());
        assert_close("inertia", points, expected, INVERTED);
    }
}

#[test]
fn only_joints_between_two_frames_move_them_against_each_other() {
    type Between = Seen<PandaHandTcp, PandaLink4>;
    let speeds = <Prepared<f64> as Jacobian<f64, Between>>::SPEEDS;
    assert_eq!(speeds, [4, 5, 6]);
    let system = Prepared::<f64>::nominal();
    for (q, _) in states() {
        for row in jacobian::<Between, _>(&system, &q).as_flattened() {
            assert_eq!(row[..4], [0.0; 4]);
        }
    }
}

#[test]
fn packed_columns_are_those_of_the_speeds_that_move_the_frame() {
    let speeds = <Prepared<f64> as JacobianPacked<f64, PandaLink4>>::SPEEDS;
    assert_eq!(speeds, [0, 1, 2, 3]);
    let system = Prepared::<f64>::nominal();
    for (q, _) in states() {
        let [mut linear, mut angular] = [[[f64::NAN; 4]; 3]; 2];
        JacobianPacked::<f64, PandaLink4>::jacobian_packed(&system, &q, &mut linear, &mut angular);
        let whole = jacobian::<PandaLink4, _>(&system, &q);
        for (packed, whole) in [linear, angular]
            .as_flattened()
            .iter()
            .zip(whole.as_flattened())
        {
            assert_eq!(packed[..], whole[..4]);
            assert_eq!(whole[4..], [0.0; 3]);
        }
    }
}

#[test]
fn accelerations_are_those_of_the_jacobian_and_its_rate() {
    let system = Prepared::<f64>::nominal();
    for (q, u) in states() {
        let u_dot = std::array::from_fn(|place| q[place] - 2.0 * u[place]);
        let [mut linear, mut angular] = [[f64::NAN; 3]; 2];
        JacobianDotU::<f64, PandaHandTcp>::jacobian_dot_u(
            &system,
            &q,
            &u,
            &mut linear,
            &mut angular,
        );
        let of_u_dot = jacobian::<PandaHandTcp, _>(&system, &q).map(|rows| times(&rows, &u_dot));
        let expected = [linear, angular];
        let expected: Vec<f64> = expected
            .as_flattened()
            .iter()
            .zip(of_u_dot.as_flattened())
            .map(|(a, b)| a + b)
            .collect();
        Acceleration::<f64, PandaHandTcp>::acceleration(
            &system,
            &q,
            &u,
            &u_dot,
            &mut linear,
            &mut angular,
        );
        assert_close(
            "acceleration",
            &[linear, angular].concat(),
            &expected,
            EXACT,
        );

        // Along its own axes, less gravity.
        Acceleration::<f64, Local<PandaHandTcp>>::acceleration(
            &system,
            &q,
            &u,
            &u_dot,
            &mut linear,
            &mut angular,
        );
        let pose = pose::<PandaHandTcp, _>(&system, &q);
        let expected: [f64; 3] = std::array::from_fn(|i| linear[i] + 9.81 * pose[3 * i + 2]);
        let [mut force, mut turning] = [[f64::NAN; 3]; 2];
        Imu::<f64, PandaHandTcp>::imu(&system, &q, &u, &u_dot, &mut force, &mut turning);
        assert_close("specific force", &force, &expected, EXACT);
        let [_, expected] = velocity::<Local<PandaHandTcp>, _>(&system, &q, &u);
        assert_close("angular velocity", &turning, &expected, EXACT);
    }
}

#[test]
fn forces_and_points_follow_from_the_jacobian() {
    let system = Prepared::<f64>::nominal();
    let (force, moment, point) = ([3.0, -1.0, 2.0], [0.5, 0.25, -0.75], [0.1, -0.2, 0.3]);
    for (q, u) in states() {
        let mut tau = [f64::NAN; NU];
        GeneralizedForce::<f64, PandaHandTcp>::generalized_force(
            &system, &q, &force, &moment, &mut tau,
        );
        let [linear, angular] = jacobian::<PandaHandTcp, _>(&system, &q);
        let expected: [f64; NU] = std::array::from_fn(|speed| {
            (0..3)
                .map(|row| linear[row][speed] * force[row] + angular[row][speed] * moment[row])
                .sum()
        });
        assert_close("tau", &tau, &expected, EXACT);

        let [mut of_point, mut turning] = [[[f64::NAN; NU]; 3]; 2];
        PointJacobian::<f64, PandaHandTcp>::point_jacobian(
            &system,
            &q,
            &point,
            &mut of_point,
            &mut turning,
        );
        assert_eq!(turning, angular);
        let pose = pose::<PandaHandTcp, _>(&system, &q);
        let lever: [f64; 3] =
            std::array::from_fn(|i| (0..3).map(|j| pose[3 * j + i] * point[j]).sum());
        let [v, w] = [linear, angular].map(|rows| times(&rows, &u));
        let cross =
            |i: usize| w[(i + 1) % 3] * lever[(i + 2) % 3] - w[(i + 2) % 3] * lever[(i + 1) % 3];
        let expected: [f64; 3] = std::array::from_fn(|i| v[i] + cross(i));
        assert_close("point", &times(&of_point, &u), &expected, EXACT);
    }
}
