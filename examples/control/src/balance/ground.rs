//! The ground of the plant: under each foot a spring and a damper, and friction.

use std::array::from_fn;

use super::sizes::FEET;
use crate::solo12::{self, NQ, NU, Prepared, contacts};

/// Of the ground in each direction, N/m: the robot's weight sinks in by 0.6 mm.
const STIFFNESS: f64 = 1e4;
/// N s/m.
const DAMPING: f64 = 60.0;
/// The coefficient of friction.
const FRICTION: f64 = 0.8;

/// Where the feet are, m, and how they move, m/s.
#[derive(Clone, Copy, Debug)]
pub(super) struct Feet {
    pub(super) position: [[f64; 3]; FEET],
    velocity: [[f64; 3]; FEET],
}

impl Feet {
    pub(super) fn new(robot: &Prepared<f64>, q: &[f64; NQ], u: &[f64; NU]) -> Self {
        let (mut position, mut velocity) = ([[0.0; 3]; FEET], [[0.0; 3]; FEET]);
        {
            let [fl, fr, hl, hr] = &mut position;
            let [fl_v, fr_v, hl_v, hr_v] = &mut velocity;
            contacts(robot, q, u, fl, fr, hl, hr, fl_v, fr_v, hl_v, hr_v);
        }
        Self { position, velocity }
    }
}

/// The generalized forces of forces at the feet, N.
pub(super) fn generalized(
    robot: &Prepared<f64>,
    q: &[f64; NQ],
    forces: &[[f64; 3]; FEET],
) -> [f64; NU] {
    let mut tau = [[0.0; NU]; FEET];
    solo12::fl_foot_linear_generalized_force(robot, q, &forces[0], &mut tau[0]);
    solo12::fr_foot_linear_generalized_force(robot, q, &forces[1], &mut tau[1]);
    solo12::hl_foot_linear_generalized_force(robot, q, &forces[2], &mut tau[2]);
    solo12::hr_foot_linear_generalized_force(robot, q, &forces[3], &mut tau[3]);
    from_fn(|i| tau.iter().map(|tau| tau[i]).sum())
}

/// The plane `z = 0`. Friction is a spring and a damper from each foot to where it sticks, and no more than Coulomb's: what pulls more
/// takes that place along.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// Where the feet stick, x and y, m.
    anchors: [[f64; 2]; FEET],
    /// How far each has slipped, m.
    pub(super) slipped: [f64; FEET],
}

impl Ground {
    /// The feet stick where they are.
    pub(super) fn new(feet: &Feet) -> Self {
        let anchors = feet.position.map(|[x, y, _]| [x, y]);
        Self {
            anchors,
            slipped: [0.0; FEET],
        }
    }

    /// How far a foot sinks in under a force, N; m.
    pub(super) fn sinking(force: f64) -> f64 {
        force / STIFFNESS
    }

    /// On the feet, N.
    pub(super) fn forces(&self, feet: &Feet) -> [[f64; 3]; FEET] {
        from_fn(|foot| {
            let (position, velocity) = (&feet.position[foot], &feet.velocity[foot]);
            let pressed = -STIFFNESS * position[2] - DAMPING * velocity[2];
            // What is not a number presses as such.
            let normal = if position[2] >= 0.0 || pressed <= 0.0 {
                0.0
            } else {
                pressed
            };
            let [x, y] = from_fn(|i| {
                -STIFFNESS * (position[i] - self.anchors[foot][i]) - DAMPING * velocity[i]
            });
            let (pull, most) = (x.hypot(y), FRICTION * normal);
            let part = if pull > most { most / pull } else { 1.0 };
            [part * x, part * y, normal]
        })
    }

    /// Moves on where feet stick that slip.
    pub(super) fn slip(&mut self, feet: &Feet) {
        for (foot, force) in self.forces(feet).iter().enumerate() {
            let anchor: [f64; 2] = from_fn(|i| {
                let spring = force[i] + DAMPING * feet.velocity[foot][i];
                feet.position[foot][i] + spring / STIFFNESS
            });
            let [x, y] = from_fn(|i| anchor[i] - self.anchors[foot][i]);
            self.anchors[foot] = anchor;
            self.slipped[foot] += x.hypot(y);
        }
    }
}

/// By how much of what friction can bear a force pulls; infinite where nothing presses.
pub(super) fn part_of_friction([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y) / (FRICTION * z)
}
