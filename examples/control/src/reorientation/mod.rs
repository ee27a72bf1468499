//! Reorientation: eight bodies that float in space turn their hub by moving the others, with nothing to push against.
//!
//! `τ` moves the joints, `u̇_J = u̇_d + 2 ω (u_d - u) + ω² (q_d - q)`, and nothing acts on the hub, which follows from
//! `M_HH u̇_H + M_HJ u̇_J + b_H = 0`. Momentum stays zero, and yet a body that goes in a circle leaves the hub turned when it
//! is back. In the hub's axes that turn depends on the circle alone: every stroke is rehearsed once, and then the one that
//! makes most of the turn still missing is made, and measured, until little is missing.

mod stroke;

use std::{array::from_fn, fmt};

use kane::{
    eight_body::{self, NB, NQ, NU, Prepared},
    integrate::rk4_step,
    view,
};
use nalgebra::{Matrix6, Rotation3, Vector3, Vector6};

use crate::{CallTimes, Desired, PERIOD, in_double, in_scalar, periods, raise};
use stroke::{Repertoire, Stroke};

/// What the controller computes in.
pub type Scalar = f64;

/// `ω`, rad/s.
const BANDWIDTH: Scalar = 20.0;
/// Places of the hub's coordinates and speeds.
const HUB: [usize; 6] = [0, 1, 2, 24, 25, 26];

/// The law, and what it knows of the bodies.
#[derive(Debug)]
pub struct Controller {
    system: Prepared<Scalar>,
}

impl Controller {
    /// Believes that the bodies are these.
    pub fn new(system: Prepared<Scalar>) -> Self {
        Self { system }
    }

    /// `τ`, which is zero for the hub.
    #[allow(
        clippy::large_stack_arrays,
        reason = "a mass matrix of 48 speeds, for one call at a time"
    )]
    pub fn torque(
        &self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, NU>,
    ) -> [Scalar; NU] {
        let mut u_dot = desired.acceleration(BANDWIDTH, q, u);
        for i in HUB {
            u_dot[i] = 0.0;
        }
        let (mut held, mut m) = ([0.0; NU], [[0.0; NU]; NU]);
        eight_body::inverse_dynamics(&self.system, q, u, &u_dot, &mut held);
        eight_body::mass_matrix(&self.system, q, &mut m);

        // With `u̇_H = 0` something would hold the hub; it accelerates as if that were let go.
        let Some(of_hub) = Matrix6::from_fn(|i, j| m[HUB[i]][HUB[j]]).cholesky() else {
            // Where the hub's angles are singular, rather no torque than a wrong one.
            return [0.0; NU];
        };
        let hub_dot = of_hub.solve(&Vector6::from_fn(|i, _| -held[HUB[i]]));
        from_fn(|i| {
            if HUB.contains(&i) {
                0.0
            } else {
                held[i] + Vector6::from_fn(|j, _| m[i][HUB[j]]).dot(&hub_dot)
            }
        })
    }
}

/// The bodies, as they are.
#[derive(Debug)]
struct Plant {
    system: Prepared<f64>,
    q: [f64; NQ],
    u: [f64; NU],
    report: Report,
}

impl Plant {
    fn at_rest() -> Self {
        Self {
            system: Prepared::nominal(),
            q: [0.0; NQ],
            u: [0.0; NU],
            report: Report::default(),
        }
    }

    fn make(
        &mut self,
        stroke: &Stroke,
        mut torque: impl FnMut(&[Scalar; NQ], &[Scalar; NU], &Desired<Scalar, NU>) -> [Scalar; NU],
    ) {
        let joints = (0..NQ).filter(|i| !HUB.contains(i));
        for period in 0..periods(Stroke::DURATION) {
            let desired = stroke.desired(period as f64 * PERIOD);
            let errors = joints.clone().map(|i| desired.q[i] - self.q[i]);
            raise(&mut self.report.joint_error, errors);
            let tau = torque(
                &in_scalar(&self.q),
                &in_scalar(&self.u),
                &desired.in_scalar(),
            );
            rk4_step(
                &self.system,
                &in_double(tau),
                PERIOD,
                &mut self.q,
                &mut self.u,
            );
            let mut momentum = [0.0; 3];
            eight_body::angular_momentum(&self.system, &self.q, &self.u, &mut momentum);
            raise(&mut self.report.momentum, momentum);
        }
        self.report.strokes += 1;
    }

    /// Inertial components to those in the hub's axes.
    fn attitude(&self) -> Rotation3<f64> {
        let mut rotations = [[[0.0; 3]; 3]; NB];
        eight_body::rotation(&self.system, &self.q, &mut rotations);
        view::rotation(&rotations[0])
    }
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// By what angle the hub turned, rad.
    pub turn: f64,
    /// By what angle it is not where it ought to be, rad.
    pub error: f64,
    /// How many strokes it took.
    pub strokes: usize,
    /// The greatest error of a joint, rad, m.
    pub joint_error: f64,
    /// The greatest angular momentum about an inertial axis, kg m²/s: that of the integrator's error.
    pub momentum: f64,
}

/// Turns the hub by `turn`, rad, its axes, to within `tolerance`, rad, in at most `strokes` strokes.
pub fn run(turn: [f64; 3], tolerance: f64, strokes: usize, calls: &mut CallTimes) -> Report {
    let controller = Controller::new(Prepared::nominal());
    let repertoire = Repertoire::rehearse(|stroke| {
        let mut plant = Plant::at_rest();
        plant.make(stroke, |q, u, desired| controller.torque(q, u, desired));
        plant.attitude().scaled_axis()
    });
    let goal = Rotation3::new(Vector3::from(turn));
    let mut plant = Plant::at_rest();
    loop {
        let attitude = plant.attitude();
        let missing = (goal * attitude.inverse()).scaled_axis();
        plant.report.turn = attitude.angle();
        plant.report.error = missing.norm();
        if plant.report.error < tolerance || plant.report.strokes == strokes {
            return plant.report;
        }
        plant.make(&repertoire.best(&missing), |q, u, desired| {
            calls.time(|| controller.torque(q, u, desired))
        });
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the hub turned by {:.2} degrees in {} strokes, {:.3} degrees are missing; joints within {:.2} mrad or mm of where they ought to be, angular momentum below {:.0e} kg m²/s",
            self.turn.to_degrees(),
            self.strokes,
            self.error.to_degrees(),
            1e3 * self.joint_error,
            self.momentum,
        )
    }
}
