use kane::functions::{ForwardDynamics, ForwardDynamicsPivots, Singularity};
use kane::{Real, System};

use super::arrays;

/// A frame that slides, and on it a rotor with three free angles and a mass matrix that a test may choose:
/// for the checks, not for its motion.
pub(crate) struct Gimbal<R> {
    pub(crate) pivots: [R; 4],
}

impl<R: Real> System<R> for Gimbal<R> {
    arrays!(R; 4, 4, 2);

    const NAME: &'static str = "gimbal";
    const BODY_NAMES: &'static [&'static str] = &["frame", "rotor"];
    const COORDINATE_NAMES: &'static [&'static str] =
        &["frame_s1", "rotor_theta1", "rotor_theta2", "rotor_theta3"];
    const SPEED_NAMES: &'static [&'static str] = &[
        "frame_s1_dot",
        "rotor_theta1_dot",
        "rotor_theta2_dot",
        "rotor_theta3_dot",
    ];
    const LOWER_BODIES: &'static [usize] = &[0, 1];
    const SPEED_BODIES: &'static [usize] = &[0, 1, 1, 1];

    fn q_dot(&self, _: &[R; 4], u: &[R; 4], q_dot: &mut [R; 4]) {
        *q_dot = *u;
    }
}

impl<R: Real> ForwardDynamics<R> for Gimbal<R> {
    fn forward_dynamics(&self, _: &[R; 4], _: &[R; 4], tau: &[R; 4], u_dot: &mut [R; 4]) {
        *u_dot = core::array::from_fn(|speed| tau[speed] / self.pivots[speed]);
    }
}

impl<R: Real> ForwardDynamicsPivots<R> for Gimbal<R> {
    fn forward_dynamics_pivots(&self, _: &[R; 4], pivots: &mut [R; 4]) {
        *pivots = self.pivots;
    }
}

impl<R: Real> Singularity<R> for Gimbal<R> {
    fn singularity(&self, q: &[R; 4], distances: &mut [R; 2]) {
        *distances = [R::from_f64(1.0), Real::abs(q[2].sin_cos().1)];
    }
}
