use kane::{Chart, Joint, Real, System};

use super::arrays;

/// Three joints without masses: a free one with a quaternion, a spherical one with angles and angular velocities, a hinge.
pub(crate) struct Turning;

impl<R: Real> System<R> for Turning {
    arrays!(R; 11, 10, 3);

    const NAME: &'static str = "turning";
    const BODY_NAMES: &'static [&'static str] = &["hinged", "floating", "ball"];
    const COORDINATE_NAMES: &'static [&'static str] = &[
        "ball_theta1",
        "ball_theta2",
        "ball_theta3",
        "hinged_theta2",
        "floating_e0",
        "floating_e1",
        "floating_e2",
        "floating_e3",
        "floating_s1",
        "floating_s2",
        "floating_s3",
    ];
    const SPEED_NAMES: &'static [&'static str] = &[
        "ball_w1",
        "ball_w2",
        "ball_w3",
        "floating_w1",
        "floating_w2",
        "floating_w3",
        "floating_s1_dot",
        "floating_s2_dot",
        "floating_s3_dot",
        "hinged_theta2_dot",
    ];
    const LOWER_BODIES: &'static [usize] = &[0, 0, 0];
    const SPEED_BODIES: &'static [usize] = &[2, 2, 2, 1, 1, 1, 1, 1, 1, 0];
    const JOINTS: &'static [Joint] = &[
        Joint {
            name: "hinged",
            chart: Chart::AngleRates,
            q: [None, Some(3), None, None, None, None, None],
            u: [None, Some(9), None, None, None, None],
        },
        Joint {
            name: "floating",
            chart: Chart::EulerParameters,
            q: [
                Some(4),
                Some(5),
                Some(6),
                Some(7),
                Some(8),
                Some(9),
                Some(10),
            ],
            u: [Some(3), Some(4), Some(5), Some(6), Some(7), Some(8)],
        },
        Joint {
            name: "ball",
            chart: Chart::Angles,
            q: [Some(0), Some(1), Some(2), None, None, None, None],
            u: [Some(0), Some(1), Some(2), None, None, None],
        },
    ];

    fn q_dot(&self, q: &[R; 11], u: &[R; 10], q_dot: &mut [R; 11]) {
        let half = R::from_f64(0.5);
        let [e0, e1, e2, e3] = [q[4], q[5], q[6], q[7]];
        let [w1, w2, w3] = [u[3], u[4], u[5]];
        let ((s2, c2), (s3, c3)) = (q[1].sin_cos(), q[2].sin_cos());
        let rate1 = (c3 * u[0] - s3 * u[1]) / c2;
        *q_dot = [
            rate1,
            s3 * u[0] + c3 * u[1],
            u[2] - s2 * rate1,
            u[9],
            -half * (e1 * w1 + e2 * w2 + e3 * w3),
            half * (e0 * w1 + e2 * w3 - e3 * w2),
            half * (e0 * w2 + e3 * w1 - e1 * w3),
            half * (e0 * w3 + e1 * w2 - e2 * w1),
            u[6],
            u[7],
            u[8],
        ];
    }
}
