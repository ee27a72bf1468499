//! A cart swings up its pole and stops below it, pushed by no more than the motor can.
//!
//! The cost is that of standing still, upright, where the cart began, after three seconds, and a little of the force. The start of the search
//! is no force at all.

use kane::discrete::rk4;
use nalgebra::{SMatrix, SVector};

use crate::cart_pole::Prepared;
use crate::ilqr::{Cost, Ilqr, Motion, Quadratic};

/// The time of a step, s.
pub const DT: f64 = 0.02;

/// Three seconds.
const N_STEPS: usize = 150;

/// The motor's greatest force, N: half the weight of cart and pole.
pub const FORCE: f64 = 12.0;

/// Weights of the last state: cart's position, pole's angle, their speeds.
const LAST: [f64; 4] = [500.0, 500.0, 50.0, 50.0];

/// The weight of a force over a second.
const OF_FORCE: f64 = 0.01;

/// Standing still, upright.
#[derive(Clone, Copy, Debug)]
pub struct Upright;

impl Cost<Prepared<f64>, 4, 1> for Upright {
    fn of(&self, (q, u): (&[f64; 2], &[f64; 2]), force: Option<&SVector<f64, 1>>) -> f64 {
        let away = [q[0], q[1], u[0], u[1]];
        let last = || {
            let terms = away.iter().zip(LAST);
            terms.map(|(away, weight)| 0.5 * weight * away * away).sum()
        };
        force.map_or_else(last, |force| 0.5 * DT * OF_FORCE * force[0] * force[0])
    }

    fn near(
        &self,
        (q, u): (&[f64; 2], &[f64; 2]),
        force: Option<&SVector<f64, 1>>,
    ) -> Quadratic<4, 1> {
        let away = SVector::from([q[0], q[1], u[0], u[1]]);
        let weights = match force {
            Some(_) => SVector::zeros(),
            None => SVector::from(LAST),
        };
        Quadratic {
            x: weights.component_mul(&away),
            xx: SMatrix::from_diagonal(&weights),
            f: DT * OF_FORCE * force.copied().unwrap_or_default(),
            ff: SMatrix::identity() * (DT * OF_FORCE),
        }
    }
}

/// The motion from hanging down at rest.
pub fn run() -> Motion<[f64; 2], [f64; 2], 1> {
    let system = Prepared::nominal();
    let ilqr = Ilqr {
        system: &system,
        cost: Upright,
        dt: DT,
        actuated: [0],
        limits: SVector::from([FORCE]),
        step: rk4::step,
        linearized: rk4::linearized,
    };
    let hanging = ([0.0, std::f64::consts::PI], [0.0; 2]);
    let mut motion = ilqr.driven(hanging, &[SVector::zeros(); N_STEPS]);
    ilqr.optimize(&mut motion, (1e-6, 500));
    motion
}
