//! A Panda carries two kilograms to a point half a metre away in half a second, with torques that its drives have.

use kane::discrete::rk4;
use nalgebra::{SVector, Vector3};

use crate::arm::{READY, Reach, Weights, holding, limits, loaded, position};
use crate::ilqr::{Ilqr, Motion};
use crate::panda::{NU, Prepared};

/// The time of a step, s.
pub const DT: f64 = 0.01;

/// Half a second.
const N_STEPS: usize = 50;

/// From the payload's place at the start, m: to the side, and up.
const AWAY: [f64; 3] = [-0.1, 0.45, 0.2];

/// The arm with what it carries.
pub fn system() -> Prepared<f64> {
    loaded(2.0, [0.0, 0.02, 0.05])
}

/// Where to, inertial components, m.
pub fn goal() -> Vector3<f64> {
    position(&system(), &READY) + Vector3::from(AWAY)
}

/// The motion from rest.
pub fn run() -> Motion<[f64; NU], [f64; NU], NU> {
    let system = system();
    let holding = holding(&system, &READY);
    let ilqr = Ilqr {
        system: &system,
        cost: Reach {
            system: &system,
            goal: goal(),
            free: holding,
            always: Weights {
                way: 0.0,
                speed: 1e-4,
                torque: 1e-6,
            },
            last: Weights {
                way: 1e4,
                speed: 10.0,
                torque: 0.0,
            },
        },
        dt: DT,
        actuated: [0, 1, 2, 3, 4, 5, 6],
        limits: limits(),
        step: rk4::step,
        linearized: rk4::linearized,
    };
    let start: SVector<f64, NU> = holding;
    let mut motion = ilqr.driven((READY, [0.0; NU]), &[start; N_STEPS]);
    ilqr.optimize(&mut motion, (1e-6, 200));
    motion
}
