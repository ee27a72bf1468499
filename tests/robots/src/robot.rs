//! [`Robot`]: a system as a trait object, so that the tests are compiled once and not for each robot.
//!
//! Outputs are filled with NaN before the call: what a function leaves unwritten shows.

use kane::{
    Array, Frame, Joint, System,
    functions::{
        AngularMomentum, Bias, ForwardDynamics, GravityForces, InverseDynamics, KineticEnergy,
        LinearMomentum, MassCenterPosition, MassMatrix, OriginPosition, PotentialEnergy, Rotation,
    },
    integrate,
};

/// The functions that have two formulations, and what is constant. Slices are as long as the system's arrays.
pub trait Dynamics {
    /// Each body's joint.
    fn joints(&self) -> &'static [Joint];
    /// The coordinates' names.
    fn coordinate_names(&self) -> &'static [&'static str];
    /// The mass matrix, row by row.
    fn mass_matrix(&self, q: &[f64]) -> Vec<f64>;
    /// The bias.
    fn bias(&self, q: &[f64], u: &[f64]) -> Vec<f64>;
    /// The generalized forces against gravity.
    fn gravity_forces(&self, q: &[f64]) -> Vec<f64>;
    /// The generalized forces of a motion.
    fn inverse_dynamics(&self, q: &[f64], u: &[f64], u_dot: &[f64]) -> Vec<f64>;
    /// The accelerations under generalized forces.
    fn forward_dynamics(&self, q: &[f64], u: &[f64], tau: &[f64]) -> Vec<f64>;
}

/// A system with every function that the references have values for.
pub trait Robot: Dynamics {
    /// The bodies' names.
    fn body_names(&self) -> &'static [&'static str];
    /// What is fixed to them.
    fn frames(&self) -> &'static [Frame];
    /// Limits of coordinates and speeds.
    fn limits(&self) -> Limits;
    /// Inertial components to components in each body.
    fn rotation(&self, q: &[f64]) -> Vec<[[f64; 3]; 3]>;
    /// Each body's origin, body components.
    fn origin_position(&self, q: &[f64]) -> Vec<[f64; 3]>;
    /// Each body's mass centre, body components.
    fn mass_center_position(&self, q: &[f64]) -> Vec<[f64; 3]>;
    /// Kinetic energy.
    fn kinetic_energy(&self, q: &[f64], u: &[f64]) -> f64;
    /// Potential energy.
    fn potential_energy(&self, q: &[f64]) -> f64;
    /// Linear momentum, inertial components.
    fn linear_momentum(&self, q: &[f64], u: &[f64]) -> [f64; 3];
    /// Angular momentum about the inertial origin, inertial components.
    fn angular_momentum(&self, q: &[f64], u: &[f64]) -> [f64; 3];
    /// The coordinates with quaternions of length one.
    fn normalize(&self, q: &[f64]) -> Vec<f64>;
    /// `q` and `u` a step of the integrator later.
    fn step(&self, q: &[f64], u: &[f64], tau: &[f64], dt: f64) -> (Vec<f64>, Vec<f64>);
}

/// Limits of coordinates and speeds, in their order.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Least coordinates.
    pub lower: &'static [f64],
    /// Greatest coordinates.
    pub upper: &'static [f64],
    /// Greatest speeds.
    pub velocity: &'static [f64],
    /// Greatest forces.
    pub effort: &'static [f64],
}

impl<S> Dynamics for S
where
    S: MassMatrix<f64>
        + Bias<f64>
        + GravityForces<f64>
        + InverseDynamics<f64>
        + ForwardDynamics<f64>,
{
    fn joints(&self) -> &'static [Joint] {
        S::JOINTS
    }

    fn coordinate_names(&self) -> &'static [&'static str] {
        S::COORDINATE_NAMES
    }

    fn mass_matrix(&self, q: &[f64]) -> Vec<f64> {
        let mut m = S::Matrix::filled(S::U::filled(f64::NAN));
        MassMatrix::mass_matrix(self, &array(q), &mut m);
        m.as_ref().iter().flat_map(AsRef::as_ref).copied().collect()
    }

    fn bias(&self, q: &[f64], u: &[f64]) -> Vec<f64> {
        let mut bias = S::U::filled(f64::NAN);
        Bias::bias(self, &array(q), &array(u), &mut bias);
        bias.as_ref().to_vec()
    }

    fn gravity_forces(&self, q: &[f64]) -> Vec<f64> {
        let mut tau = S::U::filled(f64::NAN);
        GravityForces::gravity_forces(self, &array(q), &mut tau);
        tau.as_ref().to_vec()
    }

    fn inverse_dynamics(&self, q: &[f64], u: &[f64], u_dot: &[f64]) -> Vec<f64> {
        let mut tau = S::U::filled(f64::NAN);
        InverseDynamics::inverse_dynamics(self, &array(q), &array(u), &array(u_dot), &mut tau);
        tau.as_ref().to_vec()
    }

    fn forward_dynamics(&self, q: &[f64], u: &[f64], tau: &[f64]) -> Vec<f64> {
        let mut u_dot = S::U::filled(f64::NAN);
        ForwardDynamics::forward_dynamics(self, &array(q), &array(u), &array(tau), &mut u_dot);
        u_dot.as_ref().to_vec()
    }
}

impl<S> Robot for S
where
    S: Dynamics
        + ForwardDynamics<f64>
        + Rotation<f64>
        + OriginPosition<f64>
        + MassCenterPosition<f64>
        + KineticEnergy<f64>
        + PotentialEnergy<f64>
        + LinearMomentum<f64>
        + AngularMomentum<f64>,
{
    fn body_names(&self) -> &'static [&'static str] {
        S::BODY_NAMES
    }

    fn frames(&self) -> &'static [Frame] {
        S::FRAMES
    }

    fn limits(&self) -> Limits {
        Limits {
            lower: S::LOWER_LIMITS,
            upper: S::UPPER_LIMITS,
            velocity: S::VELOCITY_LIMITS,
            effort: S::EFFORT_LIMITS,
        }
    }

    fn rotation(&self, q: &[f64]) -> Vec<[[f64; 3]; 3]> {
        let mut out = S::Rotations::filled([[f64::NAN; 3]; 3]);
        Rotation::rotation(self, &array(q), &mut out);
        out.as_ref().to_vec()
    }

    fn origin_position(&self, q: &[f64]) -> Vec<[f64; 3]> {
        let mut out = S::Vectors::filled([f64::NAN; 3]);
        OriginPosition::origin_position(self, &array(q), &mut out);
        out.as_ref().to_vec()
    }

    fn mass_center_position(&self, q: &[f64]) -> Vec<[f64; 3]> {
        let mut out = S::Vectors::filled([f64::NAN; 3]);
        MassCenterPosition::mass_center_position(self, &array(q), &mut out);
        out.as_ref().to_vec()
    }

    fn kinetic_energy(&self, q: &[f64], u: &[f64]) -> f64 {
        let mut energy = f64::NAN;
        KineticEnergy::kinetic_energy(self, &array(q), &array(u), &mut energy);
        energy
    }

    fn potential_energy(&self, q: &[f64]) -> f64 {
        let mut energy = f64::NAN;
        PotentialEnergy::potential_energy(self, &array(q), &mut energy);
        energy
    }

    fn linear_momentum(&self, q: &[f64], u: &[f64]) -> [f64; 3] {
        let mut out = [f64::NAN; 3];
        LinearMomentum::linear_momentum(self, &array(q), &array(u), &mut out);
        out
    }

    fn angular_momentum(&self, q: &[f64], u: &[f64]) -> [f64; 3] {
        let mut out = [f64::NAN; 3];
        AngularMomentum::angular_momentum(self, &array(q), &array(u), &mut out);
        out
    }

    fn normalize(&self, q: &[f64]) -> Vec<f64> {
        let mut q = array(q);
        System::normalize(self, &mut q);
        q.as_ref().to_vec()
    }

    fn step(&self, q: &[f64], u: &[f64], tau: &[f64], dt: f64) -> (Vec<f64>, Vec<f64>) {
        let (mut q, mut u) = (array(q), array(u));
        integrate::rk4_step(self, &array(tau), dt, &mut q, &mut u);
        (q.as_ref().to_vec(), u.as_ref().to_vec())
    }
}

pub(crate) fn array<A: Array<f64>>(values: &[f64]) -> A {
    assert_eq!(values.len(), A::LEN, "as many numbers as the system has");
    A::from_fn(|place| values[place])
}
