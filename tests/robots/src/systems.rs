//! Functions of a whole system that no other test needs, as trait objects.
//!
//! Outputs are filled with NaN before the call: what a function leaves unwritten shows.

use kane::{
    Array, Joint,
    functions::{
        CenterOfMass, CenterOfMassJacobian, CenterOfMassVelocity, CentroidalMomentumMatrix,
        HybridDynamics, Regressor,
    },
};

use crate::robot::array;

/// A system with the functions of its mass centre.
pub trait Center {
    /// Each body's joint.
    fn joints(&self) -> &'static [Joint];
    /// The mass centre.
    fn position(&self, q: &[f64]) -> [f64; 3];
    /// Its velocity.
    fn velocity(&self, q: &[f64], u: &[f64]) -> [f64; 3];
    /// Its Jacobian, three rows.
    fn jacobian(&self, q: &[f64]) -> Vec<f64>;
    /// The centroidal momentum matrix, six rows.
    fn momentum_matrix(&self, q: &[f64]) -> Vec<f64>;
}

/// A system with its regressor.
pub trait Identified {
    /// Each body's joint.
    fn joints(&self) -> &'static [Joint];
    /// The regressor, a row for each speed.
    fn regressor(&self, q: &[f64], u: &[f64], u_dot: &[f64]) -> Vec<f64>;
}

/// A system of which some joints are prescribed.
pub trait Hybrid {
    /// Each body's joint.
    fn joints(&self) -> &'static [Joint];
    /// For each speed whether it is prescribed.
    fn prescribed(&self) -> &'static [bool];
    /// The whole accelerations and the whole forces.
    fn hybrid_dynamics(&self, q: &[f64], u: &[f64], u_dot: &[f64], tau: &[f64]) -> [Vec<f64>; 2];
}

fn rows<U: Array<f64>>(rows: &[U]) -> Vec<f64> {
    rows.iter().flat_map(AsRef::as_ref).copied().collect()
}

impl<S> Center for S
where
    S: CenterOfMass<f64>
        + CenterOfMassVelocity<f64>
        + CenterOfMassJacobian<f64>
        + CentroidalMomentumMatrix<f64>,
{
    fn joints(&self) -> &'static [Joint] {
        S::JOINTS
    }

    fn position(&self, q: &[f64]) -> [f64; 3] {
        let mut position = [f64::NAN; 3];
        self.center_of_mass(&array(q), &mut position);
        position
    }

    fn velocity(&self, q: &[f64], u: &[f64]) -> [f64; 3] {
        let mut velocity = [f64::NAN; 3];
        self.center_of_mass_velocity(&array(q), &array(u), &mut velocity);
        velocity
    }

    fn jacobian(&self, q: &[f64]) -> Vec<f64> {
        let mut jacobian = [S::U::filled(f64::NAN); 3];
        self.center_of_mass_jacobian(&array(q), &mut jacobian);
        rows(&jacobian)
    }

    fn momentum_matrix(&self, q: &[f64]) -> Vec<f64> {
        let [mut linear, mut angular] = [[S::U::filled(f64::NAN); 3]; 2];
        self.centroidal_momentum_matrix(&array(q), &mut linear, &mut angular);
        [rows(&linear), rows(&angular)].concat()
    }
}

impl<S: Regressor<f64>> Identified for S {
    fn joints(&self) -> &'static [Joint] {
        S::JOINTS
    }

    fn regressor(&self, q: &[f64], u: &[f64], u_dot: &[f64]) -> Vec<f64> {
        let mut y = S::Rows::filled(S::Row::filled([f64::NAN; 10]));
        Regressor::regressor(self, &array(q), &array(u), &array(u_dot), &mut y);
        let rows = y.as_ref().iter().flat_map(AsRef::as_ref);
        rows.flatten().copied().collect()
    }
}

impl<S: HybridDynamics<f64>> Hybrid for S {
    fn joints(&self) -> &'static [Joint] {
        S::JOINTS
    }

    fn prescribed(&self) -> &'static [bool] {
        S::PRESCRIBED
    }

    fn hybrid_dynamics(&self, q: &[f64], u: &[f64], u_dot: &[f64], tau: &[f64]) -> [Vec<f64>; 2] {
        let [mut whole_u_dot, mut whole_tau] = [S::U::filled(f64::NAN); 2];
        let given = (array(q), array(u), array(u_dot), array(tau));
        HybridDynamics::hybrid_dynamics(
            self,
            &given.0,
            &given.1,
            &given.2,
            &given.3,
            &mut whole_u_dot,
            &mut whole_tau,
        );
        [whole_u_dot, whole_tau].map(|whole| whole.as_ref().to_vec())
    }
}
