use kane::Real;
use kane::functions::{ForwardDynamics, KineticEnergy, PotentialEnergy};

use super::one_coordinate::one_coordinate;

/// A point of 1 kg on a massless rod of 1 m, `theta` (rad) from hanging: `u_dot = tau - gravity sin(theta)`.
pub(crate) struct Pendulum<R> {
    pub(crate) gravity: R,
}

impl Pendulum<f64> {
    /// The period of the swing from rest at `amplitude` (rad), by the arithmetic-geometric mean, s.
    pub(crate) fn period(&self, amplitude: f64) -> f64 {
        let (mut a, mut b) = (1.0, <f64 as Real>::sin_cos(amplitude / 2.0).1);
        while (a - b).abs() > 1e-15 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        core::f64::consts::TAU / (self.gravity.sqrt() * a)
    }
}

one_coordinate!(Pendulum, "pendulum", body "rod", coordinate "rod_theta1");

impl<R: Real> ForwardDynamics<R> for Pendulum<R> {
    fn forward_dynamics(&self, q: &[R; 1], _: &[R; 1], tau: &[R; 1], u_dot: &mut [R; 1]) {
        u_dot[0] = tau[0] - self.gravity * q[0].sin_cos().0;
    }
}

impl<R: Real> KineticEnergy<R> for Pendulum<R> {
    fn kinetic_energy(&self, _: &[R; 1], u: &[R; 1], energy: &mut R) {
        *energy = R::from_f64(0.5) * u[0] * u[0];
    }
}

impl<R: Real> PotentialEnergy<R> for Pendulum<R> {
    fn potential_energy(&self, q: &[R; 1], energy: &mut R) {
        *energy = -(self.gravity * q[0].sin_cos().1);
    }
}
