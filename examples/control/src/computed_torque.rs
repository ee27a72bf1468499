//! Computed torque: the Panda follows a path in joint space.
//!
//! `τ = M(q) a + b(q, u)`, `a = u̇_d + 2 ω (u_d - u) + ω² (q_d - q)`: the `inverse_dynamics` of the acceleration that leads
//! back to the path. Where the robot accelerates by `u̇`, the error `e = q_d - q` obeys `ë + 2 ω ė + ω² e = a - u̇`: it fades
//! where the controller knows the robot, and stays below `max |a - u̇| / ω²` where it does not.

use std::{array::from_fn, f64::consts::TAU, fmt};

use kane::{Real, integrate::rk4_step};

use crate::{
    CallTimes, Desired, PERIOD,
    desired::progress,
    in_double, in_scalar,
    panda::{self, EFFORT_LIMITS, NQ, NU, Parameters, Prepared, VELOCITY_LIMITS},
    periods, raise,
};

/// What the controller computes in.
pub type Scalar = f64;

/// `ω`, rad/s.
const BANDWIDTH: Scalar = 40.0;

/// The law, and what it knows of the robot.
#[derive(Debug)]
pub struct Controller {
    robot: Prepared<Scalar>,
}

impl Controller {
    /// Believes that the robot carries so much, kg.
    pub fn new(payload_mass: Scalar) -> Self {
        let robot = Prepared::new(&carrying(payload_mass));
        Self { robot }
    }

    /// `τ`.
    pub fn torque(
        &self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, NU>,
    ) -> [Scalar; NU] {
        let a = acceleration(q, u, desired);
        let mut tau = [0.0; NU];
        panda::inverse_dynamics(&self.robot, q, u, &a, &mut tau);
        tau
    }
}

/// `a`.
pub(crate) fn acceleration(
    q: &[Scalar; NQ],
    u: &[Scalar; NU],
    desired: &Desired<Scalar, NU>,
) -> [Scalar; NU] {
    desired.acceleration(BANDWIDTH, q, u)
}

/// A point at the hand's tip, kg.
fn carrying<R: Real>(payload_mass: R) -> Parameters<R> {
    Parameters {
        payload_mass,
        ..Parameters::default()
    }
}

/// The path `q = c + r sin(2π n s)`, `s` from 0 to 1, is closed.
pub(crate) const CENTER: [f64; NQ] = [0.0, -0.4, 0.0, -2.0, 0.0, 1.8, 0.8];
const RADIUS: [f64; NQ] = [0.8, 0.5, 0.4, 0.6, 0.8, 0.6, 1.0];
const TURNS: [f64; NQ] = [1.0, 2.0, 2.0, 1.0, 2.0, 2.0, 1.0];
/// How long it takes, s.
pub(crate) const DURATION: f64 = 10.0;

/// Where to be at time `t`, s: the path, its derivatives by `s`, and the chain rule.
pub(crate) fn desired(t: f64) -> Desired<f64, NU> {
    let progress = progress(t, DURATION);
    let (sine, cosine) = Real::sin_cos_array(TURNS.map(|turns| TAU * turns * progress.s));
    let first: [f64; NQ] = from_fn(|i| RADIUS[i] * TAU * TURNS[i] * cosine[i]);
    let second: [f64; NQ] = from_fn(|i| -RADIUS[i] * (TAU * TURNS[i]).powi(2) * sine[i]);
    Desired {
        q: from_fn(|i| CENTER[i] + RADIUS[i] * sine[i]),
        u: from_fn(|i| first[i] * progress.s_dot),
        u_dot: from_fn(|i| second[i] * progress.s_dot.powi(2) + first[i] * progress.s_ddot),
    }
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// The greatest error of a joint, rad.
    pub error: f64,
    /// What it stays below but for sampling, `max |a - u̇| / ω²`, rad.
    pub bound: f64,
    /// The greatest torque, as a part of the joint's limit.
    pub effort: f64,
    /// The greatest speed, as a part of the joint's limit.
    pub speed: f64,
}

/// Follows the path with a payload, by a controller that believes in another, kg.
pub fn run(payload_mass: f64, believed: Scalar, calls: &mut CallTimes) -> Report {
    let controller = Controller::new(believed);
    let plant = Prepared::new(&carrying(payload_mass));
    let (mut q, mut u) = (CENTER, [0.0; NU]);
    let mut report = Report::default();
    for period in 0..periods(DURATION) {
        let desired = desired(period as f64 * PERIOD);
        let (q_m, u_m) = (in_scalar(&q), in_scalar(&u));
        let tau = calls.time(|| controller.torque(&q_m, &u_m, &desired.in_scalar()));
        let tau = in_double(tau);
        raise(&mut report.error, (0..NQ).map(|i| desired.q[i] - q[i]));
        raise(
            &mut report.bound,
            unforeseen(&plant, &q, &u, &desired, &tau),
        );
        raise(
            &mut report.effort,
            (0..NU).map(|i| tau[i] / EFFORT_LIMITS[i]),
        );
        raise(
            &mut report.speed,
            (0..NU).map(|i| u[i] / VELOCITY_LIMITS[i]),
        );
        rk4_step(&plant, &tau, PERIOD, &mut q, &mut u);
    }
    report
}

/// `(a - u̇) / ω²`.
fn unforeseen(
    plant: &Prepared<f64>,
    q: &[f64; NQ],
    u: &[f64; NU],
    desired: &Desired<f64, NU>,
    tau: &[f64; NU],
) -> [f64; NU] {
    let [omega] = in_double([BANDWIDTH]);
    let a = desired.acceleration(omega, q, u);
    let mut u_dot = [0.0; NU];
    panda::forward_dynamics(plant, q, u, tau, &mut u_dot);
    from_fn(|i| (a[i] - u_dot[i]) / (omega * omega))
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "error up to {:.3} mrad (bound but for sampling {:.3}), torque up to {:.0} % and speed up to {:.0} % of the limits",
            1e3 * self.error,
            1e3 * self.bound,
            1e2 * self.effort,
            1e2 * self.speed,
        )
    }
}
