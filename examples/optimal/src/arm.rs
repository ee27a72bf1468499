//! What reaching with the Panda is: its payload at a point, at rest, with little effort.

use kane::System;
use kane::functions::{InverseDynamics, Jacobian, Pose};
use nalgebra::{SMatrix, SVector, Vector3};

use crate::ilqr::{Cost, Quadratic};
use crate::panda::{NU, Parameters, Prepared, frames};

/// Changes of a state: twice the speeds.
pub const N2: usize = 2 * NU;

/// The joints' angles from which reaches begin, rad: the hand before the arm, downward.
pub const READY: [f64; NU] = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8];

/// The arm with a payload: mass, kg, and mass centre from the hand's tip, m.
pub fn loaded(mass: f64, center: [f64; 3]) -> Prepared<f64> {
    Prepared::new(&Parameters {
        payload_mass: mass,
        payload_mass_center_x: center[0],
        payload_mass_center_y: center[1],
        payload_mass_center_z: center[2],
    })
}

/// The greatest torques, N m.
pub fn limits() -> SVector<f64, NU> {
    SVector::from_column_slice(<Prepared<f64> as System<f64>>::EFFORT_LIMITS)
}

/// The torques that hold the arm still, N m.
pub fn holding(system: &Prepared<f64>, q: &[f64; NU]) -> SVector<f64, NU> {
    let mut tau = [0.0; NU];
    system.inverse_dynamics(q, &[0.0; NU], &[0.0; NU], &mut tau);
    SVector::from(tau)
}

/// Where the payload is, inertial components, m.
pub fn position(system: &Prepared<f64>, q: &[f64; NU]) -> Vector3<f64> {
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    Pose::<f64, frames::Payload>::pose(system, q, &mut rotation, &mut position);
    Vector3::from(position)
}

/// Weights of a node's cost.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    /// Of the way to the goal, 1/m².
    pub way: f64,
    /// Of joints' speeds, s²/rad².
    pub speed: f64,
    /// Of torques beyond those that hold the goal, 1/(N m)².
    pub torque: f64,
}

/// The payload at a point, at rest.
#[derive(Clone, Copy, Debug)]
pub struct Reach<'s> {
    /// The arm.
    pub system: &'s Prepared<f64>,
    /// Inertial components, m.
    pub goal: Vector3<f64>,
    /// Torques that cost nothing, N m.
    pub free: SVector<f64, NU>,
    /// Of every node.
    pub always: Weights,
    /// Of the last one, without torques.
    pub last: Weights,
}

impl Reach<'_> {
    fn weights<T>(&self, torques: Option<&T>) -> Weights {
        if torques.is_some() {
            self.always
        } else {
            self.last
        }
    }
}

impl Cost<Prepared<f64>, N2, NU> for Reach<'_> {
    fn of(&self, (q, u): (&[f64; NU], &[f64; NU]), torques: Option<&SVector<f64, NU>>) -> f64 {
        let weights = self.weights(torques);
        let way = position(self.system, q) - self.goal;
        let speed = SVector::from(*u).norm_squared();
        let torque = torques.map_or(0.0, |torques| (torques - self.free).norm_squared());
        0.5 * (weights.way * way.norm_squared() + weights.speed * speed + weights.torque * torque)
    }

    fn near(
        &self,
        (q, u): (&[f64; NU], &[f64; NU]),
        torques: Option<&SVector<f64, NU>>,
    ) -> Quadratic<N2, NU> {
        let weights = self.weights(torques);
        let way = position(self.system, q) - self.goal;
        let (mut linear, mut angular) = ([[0.0; NU]; 3], [[0.0; NU]; 3]);
        Jacobian::<f64, frames::Payload>::jacobian(self.system, q, &mut linear, &mut angular);
        let j = kane::view::matrix(&linear);
        let mut near: Quadratic<N2, NU> = Quadratic {
            x: SVector::zeros(),
            xx: SMatrix::zeros(),
            f: torques.map_or(SVector::zeros(), |torques| {
                weights.torque * (torques - self.free)
            }),
            ff: SMatrix::identity() * weights.torque,
        };
        // Without the curvature of the way itself, as Gauss and Newton have it.
        near.x
            .fixed_rows_mut::<NU>(0)
            .copy_from(&(weights.way * j.transpose() * way));
        let speeds = weights.speed * SVector::from(*u);
        near.x.fixed_rows_mut::<NU>(NU).copy_from(&speeds);
        let of_q = weights.way * j.transpose() * j;
        near.xx.fixed_view_mut::<NU, NU>(0, 0).copy_from(&of_q);
        let of_u = SMatrix::<f64, NU, NU>::identity() * weights.speed;
        near.xx.fixed_view_mut::<NU, NU>(NU, NU).copy_from(&of_u);
        near
    }
}
