use kane::functions::ForwardDynamics;
use kane::{Load, Real, System};

/// A mass of 1 kg that slides on a spring of `stiffness` (N/m): `u_dot = tau - stiffness q`.
pub(crate) struct Oscillator<R> {
    pub(crate) stiffness: R,
}

impl<R: Real> System<R> for Oscillator<R> {
    type Q = [R; 1];
    type U = [R; 1];
    type Loads = [Load<R>; 1];
    type Scalars = [R; 1];
    type Vectors = [[R; 3]; 1];
    type Rotations = [[[R; 3]; 3]; 1];

    const NAME: &'static str = "oscillator";
    const BODY_NAMES: &'static [&'static str] = &["slider"];
    const COORDINATE_NAMES: &'static [&'static str] = &["slider_s1"];
    const SPEED_NAMES: &'static [&'static str] = &["slider_s1_dot"];
    const LOWER_BODIES: &'static [usize] = &[0];
    const SPEED_BODIES: &'static [usize] = &[0];

    fn q_dot(&self, _: &[R; 1], u: &[R; 1], q_dot: &mut [R; 1]) {
        *q_dot = *u;
    }
}

impl<R: Real> ForwardDynamics<R> for Oscillator<R> {
    fn forward_dynamics(&self, q: &[R; 1], _: &[R; 1], tau: &[R; 1], u_dot: &mut [R; 1]) {
        u_dot[0] = tau[0] - self.stiffness * q[0];
    }
}
