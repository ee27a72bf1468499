use kane::System;
use kane::functions::{
    Bias, ForwardDynamics, InverseDynamics, KineticEnergy, MassMatrix, PotentialEnergy,
};

use super::{CartPole, arrays};

/// A cart and a pole of which one term may be wrong.
#[derive(Clone, Copy)]
pub(crate) struct Faulty {
    pub(crate) mass: f64,
    pub(crate) wrong: Option<Wrong>,
    /// By what part the term is wrong.
    pub(crate) part: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wrong {
    Accelerations,
    Coriolis,
    Weight,
    Energy,
    Linearity,
    Mass,
}

impl Faulty {
    fn right(self) -> CartPole<f64> {
        CartPole {
            mass: self.mass,
            gravity: 9.81,
        }
    }

    /// Zero, or by what part a wrong term is wrong.
    fn part(self, term: Wrong) -> f64 {
        if self.wrong == Some(term) {
            self.part
        } else {
            0.0
        }
    }

    /// One, or what a wrong term is multiplied with.
    fn factor(self, term: Wrong) -> f64 {
        1.0 + self.part(term)
    }
}

impl System<f64> for Faulty {
    arrays!(f64; 2, 2, 2);

    const NAME: &'static str = "faulty";
    const BODY_NAMES: &'static [&'static str] = CartPole::<f64>::BODY_NAMES;
    const COORDINATE_NAMES: &'static [&'static str] = CartPole::<f64>::COORDINATE_NAMES;
    const SPEED_NAMES: &'static [&'static str] = CartPole::<f64>::SPEED_NAMES;
    const LOWER_BODIES: &'static [usize] = CartPole::<f64>::LOWER_BODIES;
    const SPEED_BODIES: &'static [usize] = CartPole::<f64>::SPEED_BODIES;

    fn q_dot(&self, _: &[f64; 2], u: &[f64; 2], q_dot: &mut [f64; 2]) {
        *q_dot = *u;
    }
}

impl MassMatrix<f64> for Faulty {
    fn mass_matrix(&self, q: &[f64; 2], m: &mut [[f64; 2]; 2]) {
        self.right().mass_matrix(q, m);
        m[0][0] += self.part(Wrong::Mass) * q[0];
    }
}

impl Bias<f64> for Faulty {
    fn bias(&self, q: &[f64; 2], u: &[f64; 2], bias: &mut [f64; 2]) {
        self.right().bias(q, u, bias);
        bias[0] *= self.factor(Wrong::Coriolis);
        bias[1] *= self.factor(Wrong::Weight);
    }
}

impl ForwardDynamics<f64> for Faulty {
    fn forward_dynamics(&self, q: &[f64; 2], u: &[f64; 2], tau: &[f64; 2], u_dot: &mut [f64; 2]) {
        self.right().forward_dynamics(q, u, tau, u_dot);
        u_dot[1] *= self.factor(Wrong::Accelerations);
    }
}

impl InverseDynamics<f64> for Faulty {
    fn inverse_dynamics(&self, q: &[f64; 2], u: &[f64; 2], u_dot: &[f64; 2], tau: &mut [f64; 2]) {
        let mut m = [[0.0; 2]; 2];
        self.mass_matrix(q, &mut m);
        self.bias(q, u, tau);
        for (tau, row) in tau.iter_mut().zip(m) {
            *tau += row[0] * u_dot[0] + row[1] * u_dot[1];
        }
        tau[0] += self.part(Wrong::Linearity) * self.mass * self.mass;
    }
}

impl KineticEnergy<f64> for Faulty {
    fn kinetic_energy(&self, q: &[f64; 2], u: &[f64; 2], energy: &mut f64) {
        self.right().kinetic_energy(q, u, energy);
        *energy *= self.factor(Wrong::Energy);
    }
}

impl PotentialEnergy<f64> for Faulty {
    fn potential_energy(&self, q: &[f64; 2], energy: &mut f64) {
        self.right().potential_energy(q, energy);
    }
}
