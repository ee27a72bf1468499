//! Conversion between charts, against products of rotations about the axes and against finite differences.

use kane::chart::{ConvertError, Turning, convert};
use kane::{Chart, Joint, System};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

fn three(random: &mut Random, size: f64) -> [f64; 3] {
    [0; 3].map(|_| size * random.symmetric())
}

type Matrix = [[f64; 3]; 3];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Body to lower-body components: about x, then the new y, then the newest z.
fn of_angles([a, b, c]: [f64; 3]) -> Matrix {
    let about = |angle: f64, first: usize, second: usize| {
        let mut m = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        (m[first][first], m[second][second]) = (libm_cos(angle), libm_cos(angle));
        (m[second][first], m[first][second]) = (libm_sin(angle), -libm_sin(angle));
        m
    };
    product(&product(&about(a, 1, 2), &about(b, 2, 0)), &about(c, 0, 1))
}

// The platform's own, for these values come from elsewhere than those under test.
#[expect(
    clippy::disallowed_methods,
    reason = "a reference for a test, which no output holds"
)]
fn libm_sin(x: f64) -> f64 {
    x.sin()
}

#[expect(
    clippy::disallowed_methods,
    reason = "a reference for a test, which no output holds"
)]
fn libm_cos(x: f64) -> f64 {
    x.cos()
}

/// Body to lower-body components: `v + 2 e0 (e × v) + 2 e × (e × v)`, column by column.
fn of_quaternion([e0, e1, e2, e3]: [f64; 4]) -> Matrix {
    let cross = |[ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]| {
        [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
    };
    let e = [e1, e2, e3];
    let columns = [0, 1, 2].map(|axis| {
        let mut v = [0.0; 3];
        v[axis] = 1.0;
        let once = cross(e, v);
        let twice = cross(e, once);
        std::array::from_fn::<f64, 3, _>(|i| v[i] + 2.0 * e0 * once[i] + 2.0 * twice[i])
    });
    std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]))
}

fn assert_near(found: &Matrix, expected: &Matrix, distance: f64, theta: [f64; 3]) {
    let [found, expected] = [found, expected].map(|matrix| matrix.as_flattened());
    assert_close(
        format!("{theta:?}"),
        found,
        expected,
        Tolerance::absolute(distance),
    );
}

#[test]
fn a_quaternion_turns_as_its_angles_do() {
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let theta = three(&mut random, 7.0);
        let turning = Turning::from_angles(theta, [0.0; 3]);
        // A dozen roundings of numbers below one.
        assert_near(&of_quaternion(turning.e), &of_angles(theta), 2e-15, theta);
    }
}

#[test]
fn angles_of_a_quaternion_turn_as_it_does_wherever_it_is() {
    let mut random = Random::new(2);
    for near in [1.0, 1e-3, 1e-6, 1e-9, 1e-12, 0.0] {
        for _ in 0..200 {
            let [theta1, away, theta3] = three(&mut random, 3.0);
            let right = std::f64::consts::FRAC_PI_2.copysign(random.symmetric());
            let theta = [theta1, right + near * away, theta3];
            let turning = Turning::from_angles(theta, [0.0; 3]);
            let found = of_angles(turning.angles());
            // Two dozen roundings, near the singularity too.
            assert_near(&found, &of_quaternion(turning.e), 4e-15, theta);
        }
    }
}

#[test]
fn rates_come_back_from_the_angular_velocity() {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let [theta1, theta2, theta3] = three(&mut random, 1.4);
        let (theta, rates) = (
            [2.0 * theta1, theta2, 2.0 * theta3],
            three(&mut random, 5.0),
        );
        let turning = Turning::from_rates(theta, rates);
        // Division by cos(1.4) = 0.17 costs a factor of six, and the tangent as much.
        let at = format!("{theta:?}");
        assert_close(&at, &turning.rates(), &rates, Tolerance::absolute(5e-13));
        assert_close(&at, &turning.angles(), &theta, Tolerance::absolute(2e-14));
    }
}

#[test]
fn the_angular_velocity_is_that_of_the_turning_body() {
    let mut random = Random::new(4);
    let h = 1e-5;
    for _ in 0..200 {
        let (theta, rates) = (three(&mut random, 3.0), three(&mut random, 2.0));
        let w = Turning::from_rates(theta, rates).w;
        let at = |t: f64| of_angles(std::array::from_fn(|i| theta[i] + t * rates[i]));
        // R^T R_dot is the tilde of w, body components.
        let (before, after, here) = (at(-h), at(h), at(0.0));
        let rate: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| (after[i][j] - before[i][j]) / (2.0 * h))
        });
        let back: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| here[j][i]));
        let tilde = product(&back, &rate);
        // The differences are right to h² times third derivatives below 100, and rounding over h.
        let expected = [tilde[2][1], tilde[0][2], tilde[1][0]];
        assert_close("angular velocity", &w, &expected, Tolerance::absolute(1e-8));
    }
}

/// A system of one joint called `ball`.
macro_rules! of_one_joint {
    ($name:ident: $n_q:literal, $n_u:literal, $chart:ident, $q:expr, $u:expr) => {
        struct $name;

        impl System<f64> for $name {
            crate::common::arrays!(f64; $n_q, $n_u, 1);

            const NAME: &'static str = stringify!($name);
            const BODY_NAMES: &'static [&'static str] = &["body"];
            const COORDINATE_NAMES: &'static [&'static str] = &[""; $n_q];
            const SPEED_NAMES: &'static [&'static str] = &[""; $n_u];
            const LOWER_BODIES: &'static [usize] = &[0];
            const SPEED_BODIES: &'static [usize] = &[0; $n_u];
            const JOINTS: &'static [Joint] = &[Joint {
                name: "ball",
                chart: Chart::$chart,
                q: $q,
                u: $u,
            }];

            fn q_dot(&self, _: &Self::Q, _: &Self::U, _: &mut Self::Q) {}
        }
    };
}

const THREE: [Option<usize>; 6] = [Some(0), Some(1), Some(2), None, None, None];
of_one_joint!(Angles: 3, 3, Angles, [Some(0), Some(1), Some(2), None, None, None, None], THREE);
of_one_joint!(Quaternion: 4, 3, EulerParameters, [Some(0), Some(1), Some(2), Some(3), None, None, None], THREE);
of_one_joint!(XY: 2, 2, AngleRates, [Some(0), Some(1), None, None, None, None, None], [Some(0), Some(1), None, None, None, None]);
of_one_joint!(XZ: 2, 2, AngleRates, [Some(0), None, Some(1), None, None, None, None], [Some(0), None, Some(1), None, None, None]);
of_one_joint!(BeyondQ: 3, 3, Angles, [Some(0), Some(1), Some(3), None, None, None, None], THREE);
of_one_joint!(BeyondU: 3, 2, Angles, [Some(0), Some(1), Some(2), None, None, None, None], THREE);

#[test]
fn joints_of_one_name_that_lock_another_axis_are_others() {
    let other = Some(ConvertError::OtherJoints { joint: 0 });
    assert_eq!(convert::<XY, XZ>(&[0.1; 2], &[0.2; 2]).err(), other);
    assert_eq!(convert::<XY, Angles>(&[0.1; 2], &[0.2; 2]).err(), other);
    let same = convert::<XY, XY>(&[0.1, 0.2], &[0.3, 0.4]);
    assert_eq!(same, Ok(([0.1, 0.2], [0.3, 0.4])));
}

#[test]
fn places_that_a_state_has_not_are_refused_on_either_side() {
    let other = Some(ConvertError::OtherJoints { joint: 0 });
    assert_eq!(
        convert::<BeyondQ, Angles>(&[0.1; 3], &[0.2; 3]).err(),
        other
    );
    assert_eq!(
        convert::<Angles, BeyondQ>(&[0.1; 3], &[0.2; 3]).err(),
        other
    );
    assert_eq!(
        convert::<BeyondU, Angles>(&[0.1; 3], &[0.2; 2]).err(),
        other
    );
    assert_eq!(
        convert::<Quaternion, BeyondU>(&[0.5; 4], &[0.2; 3]).err(),
        other
    );
}

#[test]
fn a_quaternion_of_any_length_has_the_angles_of_its_orientation() {
    let (theta, w) = ([0.4, -0.7, 1.1], [0.3, -0.2, 0.1]);
    let Turning { e, .. } = Turning::from_angles(theta, w);
    let rounded = Tolerance::absolute(1e-15);
    for length in [1.0, 2.0, 0.01] {
        let found = convert::<Quaternion, Angles>(&e.map(|entry| length * entry), &w);
        let Ok((angles, speeds)) = found else {
            panic!("{found:?}")
        };
        assert_close(length, &angles, &theta, rounded);
        assert_eq!(speeds, w);
        let back = convert::<Angles, Quaternion>(&angles, &w).map_or([f64::NAN; 4], |(q, _)| q);
        assert_close(length, &back, &e, rounded);
    }
}
