use kane::functions::{
    Bias, ForwardDynamics, ForwardDynamicsPivots, KineticEnergy, MassMatrix, PotentialEnergy,
    Singularity,
};
use kane::{Real, System};

use super::arrays;

/// A cart of 1 kg that slides along x, and a point of `mass` (kg) on a massless rod of 1 m hinged to it,
/// `theta` (rad) from hanging.
pub(crate) struct CartPole<R> {
    pub(crate) mass: R,
    pub(crate) gravity: R,
}

impl<R: Real> System<R> for CartPole<R> {
    arrays!(R; 2, 2, 2);

    const NAME: &'static str = "cart_pole";
    const BODY_NAMES: &'static [&'static str] = &["cart", "pole"];
    const COORDINATE_NAMES: &'static [&'static str] = &["cart_s1", "pole_theta2"];
    const SPEED_NAMES: &'static [&'static str] = &["cart_s1_dot", "pole_theta2_dot"];
    const LOWER_BODIES: &'static [usize] = &[0, 1];
    const SPEED_BODIES: &'static [usize] = &[0, 1];

    fn q_dot(&self, _: &[R; 2], u: &[R; 2], q_dot: &mut [R; 2]) {
        *q_dot = *u;
    }
}

impl<R: Real> MassMatrix<R> for CartPole<R> {
    fn mass_matrix(&self, q: &[R; 2], m: &mut [[R; 2]; 2]) {
        let off = self.mass * q[1].sin_cos().1;
        *m = [[R::from_f64(1.0) + self.mass, off], [off, self.mass]];
    }
}

impl<R: Real> Bias<R> for CartPole<R> {
    fn bias(&self, q: &[R; 2], u: &[R; 2], bias: &mut [R; 2]) {
        let moment = self.mass * q[1].sin_cos().0;
        *bias = [-(moment * u[1] * u[1]), moment * self.gravity];
    }
}

impl<R: Real> ForwardDynamicsPivots<R> for CartPole<R> {
    fn forward_dynamics_pivots(&self, q: &[R; 2], pivots: &mut [R; 2]) {
        let mut m = [[R::from_f64(0.0); 2]; 2];
        self.mass_matrix(q, &mut m);
        *pivots = [m[0][0] - m[0][1] * m[0][1] / m[1][1], m[1][1]];
    }
}

impl<R: Real> ForwardDynamics<R> for CartPole<R> {
    fn forward_dynamics(&self, q: &[R; 2], u: &[R; 2], tau: &[R; 2], u_dot: &mut [R; 2]) {
        let (mut m, mut d, mut b) = ([[tau[0]; 2]; 2], *tau, *tau);
        self.mass_matrix(q, &mut m);
        self.forward_dynamics_pivots(q, &mut d);
        self.bias(q, u, &mut b);
        let f = [tau[0] - b[0], tau[1] - b[1]];
        u_dot[0] = (f[0] - m[0][1] / m[1][1] * f[1]) / d[0];
        u_dot[1] = (f[1] - m[0][1] * u_dot[0]) / d[1];
    }
}

impl<R: Real> Singularity<R> for CartPole<R> {
    fn singularity(&self, _: &[R; 2], distances: &mut [R; 2]) {
        *distances = [R::from_f64(1.0); 2];
    }
}

impl<R: Real> KineticEnergy<R> for CartPole<R> {
    fn kinetic_energy(&self, q: &[R; 2], u: &[R; 2], energy: &mut R) {
        let mut m = [[u[0]; 2]; 2];
        self.mass_matrix(q, &mut m);
        let twice = m[0][0] * u[0] * u[0]
            + R::from_f64(2.0) * m[0][1] * u[0] * u[1]
            + m[1][1] * u[1] * u[1];
        *energy = R::from_f64(0.5) * twice;
    }
}

impl<R: Real> PotentialEnergy<R> for CartPole<R> {
    fn potential_energy(&self, q: &[R; 2], energy: &mut R) {
        *energy = -(self.mass * self.gravity * q[1].sin_cos().1);
    }
}
