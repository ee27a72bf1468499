//! Identification: the Panda learns what it carries while it follows a path.
//!
//! Forces are linear in inertial parameters, `τ = τ₀ + Y π`: `τ₀` is the `inverse_dynamics` of the empty robot, `Y` the columns of the
//! `regressor` for the last body, of which the payload is part, and `π` has the payload's mass, first moments and inertia about
//! that body's origin. A Kalman filter learns `π`, which may wander, from `τ - τ₀` as it is measured, with means over some periods:
//! then the acceleration is that by which the speeds have changed. What has been learnt is added to the computed torque, `M a + b + Y(q, u, a) π`.

use std::{array::from_fn, fmt, mem};

use kane::integrate::rk4_step;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::{
    CallTimes, Desired, Noise, PERIOD,
    computed_torque::{self, CENTER, DURATION, desired},
    panda::{self, EFFORT_LIMITS, FRAMES, NB, NQ, NU, Parameters, Prepared},
    periods, raise,
};

/// What the controller computes in.
pub type Scalar = f64;

/// The number of inertial parameters of a body: `m`, kg, `m c`, kg m, and `I_xx`, `I_xy`, `I_yy`, `I_xz`, `I_yz`, `I_zz`, kg m².
const PARAMETERS: usize = 10;
/// The standard deviation of the measured torques, as a part of the joints' limits,
const TORQUE_NOISE: f64 = 0.01;
/// and of the measured speeds, rad/s.
const SPEED_NOISE: f64 = 1e-4;
/// How many periods the filter takes at once: over more of them the mean acceleration is less noisy.
const WINDOW: u32 = 10;
/// How long it takes until what is learnt is trusted, s.
const FADING: Scalar = 1.0;
/// How unsure the filter is at first, by standard deviations of masses, first moments and inertias.
const UNSURE: [Scalar; 3] = [2.0, 0.5, 0.2];
/// How far each is believed to wander in a second.
const WANDERING: [Scalar; 3] = [5e-4, 1e-4, 1e-4];

/// The filter's estimate of `π`, and how sure it is.
#[derive(Clone, Debug)]
struct Filter {
    estimate: SVector<Scalar, PARAMETERS>,
    covariance: SMatrix<Scalar, PARAMETERS, PARAMETERS>,
}

impl Default for Filter {
    fn default() -> Self {
        Self {
            estimate: SVector::zeros(),
            covariance: squares(UNSURE),
        }
    }
}

impl Filter {
    /// Takes the torques of all joints that `y` makes of the parameters, N m, as they have been measured with this deviation.
    fn update(
        &mut self,
        y: &[[Scalar; PARAMETERS]; NU],
        torque: &[Scalar; NU],
        deviation: &[Scalar; NU],
    ) {
        self.covariance += squares(WANDERING) * (PERIOD * Scalar::from(WINDOW));
        for i in 0..NU {
            // One joint after the other: what is divided by is a number.
            let y = SVector::from(y[i]);
            let spread = self.covariance * y;
            let variance = y.dot(&spread) + deviation[i] * deviation[i];
            self.estimate += spread * ((torque[i] - y.dot(&self.estimate)) / variance);
            self.covariance -= spread * spread.transpose() / variance;
        }
    }
}

/// The variances of masses, first moments and inertias that have these deviations.
fn squares([mass, moment, inertia]: [Scalar; 3]) -> SMatrix<Scalar, PARAMETERS, PARAMETERS> {
    SMatrix::from_diagonal(&SVector::from_fn(|i, _| match i {
        0 => mass * mass,
        1..4 => moment * moment,
        _ => inertia * inertia,
    }))
}

/// The law, and what it has learnt.
#[derive(Debug)]
pub struct Controller {
    /// Believes its hand empty.
    law: computed_torque::Controller,
    robot: Prepared<Scalar>,
    filter: Filter,
    /// None before the first measurement.
    window: Option<Window>,
    /// The part of what has been learnt that is added, from 0 to 1.
    trust: Scalar,
    /// How fast that grows, 1/s.
    trusting: Scalar,
}

/// What has been measured since the filter was last updated.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// `q` and `u` in the beginning.
    from: ([Scalar; NQ], [Scalar; NU]),
    /// The sum of the torques, N m.
    tau: [Scalar; NU],
    /// The number of these.
    periods: u32,
}

impl Window {
    fn new(q: &[Scalar; NQ], u: &[Scalar; NU]) -> Self {
        Self {
            from: (*q, *u),
            tau: [0.0; NU],
            periods: 0,
        }
    }
}

impl Default for Controller {
    /// Knows nothing of what it carries.
    fn default() -> Self {
        Self {
            law: computed_torque::Controller::new(0.0),
            robot: Prepared::nominal(),
            filter: Filter::default(),
            window: None,
            trust: 0.0,
            trusting: 0.0,
        }
    }
}

impl Controller {
    /// Takes something else into its hand, of which it knows nothing.
    pub fn grasp(&mut self) {
        self.filter = Filter::default();
        self.window = None;
        (self.trust, self.trusting) = (0.0, 0.0);
    }

    /// Trusts what it learns, more and more: what is added at once would throw the arm.
    pub fn trust(&mut self) {
        self.trusting = 1.0 / FADING;
    }

    /// `π`, about the origin of the last body.
    pub fn estimate(&self) -> [Scalar; PARAMETERS] {
        self.filter.estimate.into()
    }

    /// The standard deviations that the filter believes these to have.
    pub fn deviation(&self) -> [Scalar; PARAMETERS] {
        from_fn(|i| self.filter.covariance[(i, i)].sqrt())
    }

    /// Takes what has been measured: the torques since the last call, and the state that they have led to; at the first call the
    /// state alone.
    pub fn learn(&mut self, q: &[Scalar; NQ], u: &[Scalar; NU], tau: &[Scalar; NU]) {
        let Some(window) = &mut self.window else {
            self.window = Some(Window::new(q, u));
            return;
        };
        window.periods += 1;
        for (sum, tau) in window.tau.iter_mut().zip(tau) {
            *sum += tau;
        }
        if window.periods == WINDOW {
            let ended = mem::replace(window, Window::new(q, u));
            self.update(&ended, q, u);
        }
    }

    fn update(&mut self, window: &Window, q: &[Scalar; NQ], u: &[Scalar; NU]) {
        let ((q_0, u_0), periods) = (window.from, Scalar::from(window.periods));
        let q_mean: [Scalar; NQ] = from_fn(|i| 0.5 * (q_0[i] + q[i]));
        let u_mean: [Scalar; NU] = from_fn(|i| 0.5 * (u_0[i] + u[i]));
        let u_dot: [Scalar; NU] = from_fn(|i| (u[i] - u_0[i]) / (periods * PERIOD));
        let mut known = [0.0; NU];
        panda::inverse_dynamics(&self.robot, &q_mean, &u_mean, &u_dot, &mut known);
        let y = last_columns(&self.robot, &q_mean, &u_mean, &u_dot);
        let unknown = from_fn(|i| window.tau[i] / periods - known[i]);
        let deviation = EFFORT_LIMITS.map(|limit| TORQUE_NOISE * limit / periods.sqrt());
        self.filter.update(&y, &unknown, &deviation);
    }

    /// `τ`.
    pub fn torque(
        &mut self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, NU>,
    ) -> [Scalar; NU] {
        self.trust = (self.trust + PERIOD * self.trusting).min(1.0);
        let empty = self.law.torque(q, u, desired);
        let a = computed_torque::acceleration(q, u, desired);
        let y = last_columns(&self.robot, q, u, &a);
        from_fn(|i| empty[i] + self.trust * SVector::from(y[i]).dot(&self.filter.estimate))
    }
}

/// The columns of the regressor for the last body.
fn last_columns(
    robot: &Prepared<Scalar>,
    q: &[Scalar; NQ],
    u: &[Scalar; NU],
    u_dot: &[Scalar; NU],
) -> [[Scalar; PARAMETERS]; NU] {
    let mut y = [[[0.0; PARAMETERS]; NB]; NU];
    panda::regressor(robot, q, u, u_dot, &mut y);
    y.map(|of_speed| of_speed[NB - 1])
}

/// A drill: its mass centre is beside the hand's axis.
const DRILL: Parameters<f64> = Parameters {
    payload_mass: 1.6,
    payload_mass_center_x: 0.03,
    payload_mass_center_y: -0.02,
    payload_mass_center_z: 0.05,
    payload_inertia_xx: 0.004,
    payload_inertia_yy: 0.005,
    payload_inertia_zz: 0.002,
    payload_inertia_xy: 0.0003,
    payload_inertia_xz: -0.0004,
    payload_inertia_yz: 0.0002,
};
/// A cup.
const CUP: Parameters<f64> = Parameters {
    payload_mass: 0.4,
    payload_mass_center_x: -0.01,
    payload_mass_center_y: 0.04,
    payload_mass_center_z: 0.02,
    payload_inertia_xx: 0.0005,
    payload_inertia_yy: 0.0005,
    payload_inertia_zz: 0.0004,
    payload_inertia_xy: 0.0,
    payload_inertia_xz: 0.0,
    payload_inertia_yz: 0.0,
};

/// What happens before a lap, at rest.
#[derive(Clone, Copy, Debug)]
enum Before {
    /// Something else is put into the hand.
    Grasp,
    /// What has been learnt is trusted.
    Trust,
}

/// What is carried in each lap, what happens before, and whether the robot moves.
const LAPS: [(Parameters<f64>, Before, bool); 5] = [
    (DRILL, Before::Grasp, true),
    (DRILL, Before::Trust, true),
    (CUP, Before::Grasp, true),
    (CUP, Before::Trust, true),
    (CUP, Before::Trust, false),
];

/// What came of one lap; errors are the greatest in its second half.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lap {
    /// What is carried, kg.
    pub mass: f64,
    /// The error of a joint, rad.
    pub error: f64,
    /// By what part of the mass the estimate misses it.
    pub mass_error: f64,
    /// How far the estimated mass centre is from the true one, m.
    pub center_error: f64,
    /// By how much the estimate misses an entry of the inertia about the last body's origin, kg m².
    pub inertia_error: f64,
    /// The same for any parameter, as a multiple of the standard deviation that the filter believes in.
    pub deviations: f64,
    /// The greatest torque at any time, as a part of the joint's limit.
    pub effort: f64,
}

/// What came of all laps.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// One lap after the other.
    pub laps: [Lap; LAPS.len()],
}

/// Goes through all laps, with noise that follows from the seed.
pub fn run(seed: u64, calls: &mut CallTimes) -> Report {
    let (mut q, mut u) = (CENTER, [0.0; NU]);
    let mut controller = Controller::default();
    let mut noise = Noise::new(seed);
    let mut tau = [0.0; NU];
    let laps = LAPS.map(|(payload, before, moves)| {
        match before {
            Before::Grasp => controller.grasp(),
            Before::Trust => controller.trust(),
        }
        let (plant, truth) = (Prepared::new(&payload), about_last_body(&payload));
        let mut lap = Lap {
            mass: payload.payload_mass,
            ..Lap::default()
        };
        for period in 0..periods(DURATION) {
            let desired = desired(if moves { period as f64 * PERIOD } else { 0.0 });
            let mut noisy = |deviation: f64| deviation * noise.normal();
            let u_m = u.map(|u| u + noisy(SPEED_NOISE));
            let tau_m = from_fn(|i| tau[i] + noisy(TORQUE_NOISE * EFFORT_LIMITS[i]));
            tau = calls.time(|| {
                controller.learn(&q, &u_m, &tau_m);
                controller.torque(&q, &u_m, &desired)
            });
            raise(&mut lap.effort, (0..NU).map(|i| tau[i] / EFFORT_LIMITS[i]));
            if 2 * period >= periods(DURATION) {
                raise(&mut lap.error, (0..NQ).map(|i| desired.q[i] - q[i]));
                lap.see(&controller, &truth);
            }
            rk4_step(&plant, &tau, PERIOD, &mut q, &mut u);
        }
        lap
    });
    Report { laps }
}

/// `π` of a payload, which is given in the axes of the hand's tip.
fn about_last_body(payload: &Parameters<f64>) -> [f64; PARAMETERS] {
    let tip = FRAMES.iter().find(|frame| frame.name == "payload");
    let tip = tip.expect("the payload is fixed to the last body");
    let p = payload;
    let axes = Matrix3::from_fn(|i, j| tip.rotation[j][i]);
    let center = Vector3::new(
        p.payload_mass_center_x,
        p.payload_mass_center_y,
        p.payload_mass_center_z,
    );
    let center = Vector3::from(tip.position) + axes * center;
    let (xy, xz, yz) = (
        p.payload_inertia_xy,
        p.payload_inertia_xz,
        p.payload_inertia_yz,
    );
    let about_center = Matrix3::new(
        p.payload_inertia_xx,
        xy,
        xz, //
        xy,
        p.payload_inertia_yy,
        yz, //
        xz,
        yz,
        p.payload_inertia_zz,
    );
    let m = p.payload_mass;
    let lever = Matrix3::identity() * center.norm_squared() - center * center.transpose();
    let i = axes * about_center * axes.transpose() + m * lever;
    let [h_x, h_y, h_z] = (m * center).into();
    [m, h_x, h_y, h_z, i.m11, i.m12, i.m22, i.m13, i.m23, i.m33]
}

impl Lap {
    fn see(&mut self, controller: &Controller, truth: &[f64; PARAMETERS]) {
        let (estimate, deviation) = (controller.estimate(), controller.deviation());
        raise(&mut self.mass_error, [estimate[0] / truth[0] - 1.0]);
        let [x, y, z] = from_fn(|i| estimate[i + 1] / estimate[0] - truth[i + 1] / truth[0]);
        raise(&mut self.center_error, [x.hypot(y).hypot(z)]);
        let missed = (4..PARAMETERS).map(|i| estimate[i] - truth[i]);
        raise(&mut self.inertia_error, missed);
        let deviations = (0..PARAMETERS).map(|i| (estimate[i] - truth[i]) / deviation[i]);
        raise(&mut self.deviations, deviations);
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for lap in &self.laps {
            writeln!(
                f,
                "{} kg in the hand: error up to {:.3} mrad; mass within {:.2} %, mass centre within {:.2} mm, inertia within {:.1e} kg m², all within {:.1} standard deviations; torque up to {:.0} % of the limits",
                lap.mass,
                1e3 * lap.error,
                1e2 * lap.mass_error,
                1e3 * lap.center_error,
                lap.inertia_error,
                lap.deviations,
                1e2 * lap.effort,
            )?;
        }
        Ok(())
    }
}
