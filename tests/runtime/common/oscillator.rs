use kane::Real;
use kane::functions::ForwardDynamics;

use super::one_coordinate::one_coordinate;

/// A mass of 1 kg that slides on a spring of `stiffness` (N/m): `u_dot = tau - stiffness q`.
pub(crate) struct Oscillator<R> {
    pub(crate) stiffness: R,
}

one_coordinate!(Oscillator, "oscillator", body "slider", coordinate "slider_s1");

impl<R: Real> ForwardDynamics<R> for Oscillator<R> {
    fn forward_dynamics(&self, q: &[R; 1], _: &[R; 1], tau: &[R; 1], u_dot: &mut [R; 1]) {
        u_dot[0] = tau[0] - self.stiffness * q[0];
    }
}
