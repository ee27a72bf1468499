//! Model predictive control of a Panda: a thousand times a second the next fifth of a second is planned anew.
//!
//! At each millisecond the plan that is there, 20 steps of 10 ms from the measured state, is improved once by
//! [`ilqr`](super::ilqr), and its first torques are held. The plant is simulated with a payload; the plan knows of it. The derivatives are those of
//! the generated code, or, to compare, differences of the same step.

use kane::discrete::{StepDerivatives, euler, rk4};
use nalgebra::{SVector, Vector3};

use crate::arm::{READY, Reach, Weights, holding, limits, loaded, position};
use crate::ilqr::{Ilqr, Linearized};
use crate::panda::{NU, Prepared};

/// How many steps the plan looks ahead.
pub const HORIZON: usize = 20;

/// The time of these, s.
const DT: f64 = 0.01;

/// The time between plans, s.
const PERIOD: f64 = 0.001;

/// From the payload's place at the start, m.
const AWAY: [f64; 3] = [0.05, 0.25, 0.1];

/// What came of it.
#[derive(Clone, Debug)]
pub struct Report {
    /// The distance from the goal after each period, m.
    pub ways: Vec<f64>,
    /// The parts of the drives' torques that were used, period by period.
    pub parts: Vec<f64>,
    /// The joints' speeds at the end, rad/s.
    pub speeds: [f64; NU],
}

/// How a plan's steps are linearised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivatives {
    /// By the generated derivatives.
    Generated,
    /// By differences of the step.
    Differenced,
}

/// A semi-implicit step, and its derivatives by central differences.
///
/// For comparison: 42 more steps, and half the digits.
fn differenced(
    system: &Prepared<f64>,
    tau: &[f64; NU],
    dt: f64,
    (q, u): (&mut [f64; NU], &mut [f64; NU]),
    derivatives: &mut StepDerivatives<[[f64; NU]; NU]>,
) {
    const STEP: f64 = 1e-6;
    let out = derivatives;
    for (variable, by_q, by_u) in [
        (0, &mut out.q_by_q, &mut out.u_by_q),
        (1, &mut out.q_by_u, &mut out.u_by_u),
        (2, &mut out.q_by_tau, &mut out.u_by_tau),
    ] {
        for place in 0..NU {
            let [ahead, behind] = [STEP, -STEP].map(|by| {
                let mut given = [*q, *u, *tau];
                given[variable][place] += by;
                let [mut q, mut u, tau] = given;
                euler::step(system, &tau, dt, &mut q, &mut u);
                (q, u)
            });
            for row in 0..NU {
                by_q[row][place] = (ahead.0[row] - behind.0[row]) / (2.0 * STEP);
                by_u[row][place] = (ahead.1[row] - behind.1[row]) / (2.0 * STEP);
            }
        }
    }
    euler::step(system, tau, dt, q, u);
}

/// Controls the arm for so many periods; `timed` is given each planning to run, for those who hold a clock.
pub fn run(
    derivatives: Derivatives,
    n_periods: usize,
    timed: &mut dyn FnMut(&mut dyn FnMut()),
) -> Report {
    let linearized: Linearized<Prepared<f64>, NU> = match derivatives {
        Derivatives::Generated => euler::linearized,
        Derivatives::Differenced => differenced,
    };
    let system = loaded(1.5, [0.0, 0.01, 0.04]);
    let goal = position(&system, &READY) + Vector3::from(AWAY);
    let controller = Ilqr {
        system: &system,
        cost: Reach {
            system: &system,
            goal,
            free: holding(&system, &READY),
            always: Weights {
                way: 100.0,
                speed: 0.05,
                torque: 1e-5,
            },
            last: Weights {
                way: 2000.0,
                speed: 20.0,
                torque: 0.0,
            },
        },
        dt: DT,
        actuated: [0, 1, 2, 3, 4, 5, 6],
        limits: limits(),
        step: euler::step,
        linearized,
    };
    let (mut q, mut u) = (READY, [0.0; NU]);
    let mut torques = vec![holding(&system, &READY); HORIZON];
    let mut damping = 0.0;
    let mut report = Report {
        ways: Vec::with_capacity(n_periods),
        parts: Vec::with_capacity(NU * n_periods),
        speeds: u,
    };
    for _ in 0..n_periods {
        timed(&mut || {
            let mut plan = controller.driven((q, u), &torques);
            let cost = controller.total(&plan);
            let _ = controller.improve(&mut plan, cost, &mut damping);
            torques.clone_from(&plan.forces);
        });
        let tau = torques[0];
        let parts: SVector<f64, NU> = tau.abs().component_div(&controller.limits);
        report.parts.extend(&parts);
        rk4::step(&system, &tau.into(), PERIOD, &mut q, &mut u);
        report.ways.push((position(&system, &q) - goal).norm());
    }
    report.speeds = u;
    report
}
