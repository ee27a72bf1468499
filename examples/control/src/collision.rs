//! Collisions: the UR5 feels that something pushes it, by its motors' torques and without a force sensor.
//!
//! The generalized momentum `p = M u` changes by `ṗ = τ + Cᵀ u - g + τ_ext`, as `Ṁ = C + Cᵀ`. The observer adds up what it knows of
//! this, and its residual `r = k (p - ∫ (τ + Cᵀ u - g + r) dt)` obeys `ṙ = k (τ_ext - r)`: no acceleration is needed, and
//! noise of the torques is smoothed over `1 / k`. Beyond a multiple of what that noise leaves, something has collided.

use std::{array::from_fn, fmt};

use kane::{Real, integrate::rk4_step_with};

use crate::{
    CallTimes, Desired, Noise, PERIOD,
    gravity_compensation::Controller,
    in_double, in_scalar, periods, raise,
    ur5::{self, EFFORT_LIMITS, NQ, NU, Prepared},
};

/// What the observer computes in.
pub type Scalar = f32;

/// `k`, 1/s.
const GAIN: Scalar = 50.0;
/// The standard deviation of the measured torques, as a part of the joints' limits.
const NOISE: f64 = 0.01;
/// A collision is what leads beyond so many standard deviations of the residual.
const DEVIATIONS: f64 = 7.0;

/// The residual, and what it is made of.
#[derive(Clone, Debug)]
pub struct Observer {
    robot: Prepared<Scalar>,
    /// `∫ (τ + Cᵀ u - g + r) dt`, from the momentum in the beginning.
    expected: [Scalar; NU],
    /// `Cᵀ u - g` at the last call.
    rate: [Scalar; NU],
    /// `r`: the generalized forces of what pushes, N m.
    pub residual: [Scalar; NU],
    /// What is a collision, N m.
    pub threshold: [Scalar; NU],
}

impl Observer {
    /// Begins in this state, without a collision.
    pub fn new(q: &[Scalar; NQ], u: &[Scalar; NU]) -> Self {
        let robot = Prepared::nominal();
        // What first-order smoothing leaves of noise that is another one in each period.
        let left = (f64::from(GAIN) * PERIOD / 2.0).sqrt();
        let of_limit = Scalar::from_f64(DEVIATIONS * NOISE * left);
        Self {
            expected: momentum(&robot, q, u),
            rate: rate(&robot, q, u),
            residual: [0.0; NU],
            threshold: from_fn(|i| of_limit * Scalar::from_f64(EFFORT_LIMITS[i])),
            robot,
        }
    }

    /// Takes what has been measured: the torques since the last call, and the state that they have led to. True where
    /// something has collided.
    pub fn update(&mut self, q: &[Scalar; NQ], u: &[Scalar; NU], tau: &[Scalar; NU]) -> bool {
        let period = Scalar::from_f64(PERIOD);
        let (before, now) = (self.rate, rate(&self.robot, q, u));
        let momentum = momentum(&self.robot, q, u);
        for i in 0..NU {
            let known = tau[i] + 0.5 * (before[i] + now[i]);
            self.expected[i] += period * (known + self.residual[i]);
            self.residual[i] = GAIN * (momentum[i] - self.expected[i]);
        }
        self.rate = now;
        let part = self.part_of_threshold();
        part > 1.0 || part.is_nan()
    }

    /// The greatest residual, as a part of what is a collision.
    pub fn part_of_threshold(&self) -> f64 {
        let mut part = 0.0;
        let parts: [Scalar; NU] = from_fn(|i| self.residual[i] / self.threshold[i]);
        raise(&mut part, in_double(parts));
        part
    }
}

/// `M u`.
fn momentum(robot: &Prepared<Scalar>, q: &[Scalar; NQ], u: &[Scalar; NU]) -> [Scalar; NU] {
    let mut p = [0.0; NU];
    ur5::mass_matrix_product(robot, q, u, &mut p);
    p
}

/// `Cᵀ u - g`.
fn rate(robot: &Prepared<Scalar>, q: &[Scalar; NQ], u: &[Scalar; NU]) -> [Scalar; NU] {
    let (mut c, mut g) = ([[0.0; NU]; NU], [0.0; NU]);
    ur5::coriolis_matrix(robot, q, u, &mut c);
    ur5::gravity_forces(robot, q, &mut g);
    from_fn(|i| (0..NU).map(|j| c[j][i] * u[j]).sum::<Scalar>() - g[i])
}

/// Where the robot goes, round and round.
const STOPS: [[f64; NQ]; 4] = [
    [0.0, -1.6, 1.2, -1.2, -1.57, 0.0],
    [1.2, -0.5, 0.6, -0.4, -1.2, 0.8],
    [-0.6, -1.0, 2.0, -2.2, -1.57, -1.0],
    [-1.5, -1.4, 0.9, 0.4, 1.0, 1.5],
];
/// How long it takes from one to the next, s.
const MOVING: f64 = 2.0;
/// How often it goes from one to the next.
const WAYS: usize = 30;
/// How often something collides with it, were it to, s: in all six directions along the axes.
const BETWEEN_COLLISIONS: f64 = 0.35;
/// How strongly, at the hand, N.
const FORCE: f64 = 20.0;
/// How long a collision may go unnoticed, s.
const PATIENCE: f64 = 0.1;

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// How long nothing collided, s.
    pub duration: f64,
    /// In how many periods the observer saw a collision all the same.
    pub false_alarms: u32,
    /// The greatest residual in that time, as a part of what is a collision.
    pub quiet: f64,
    /// How many collisions there were.
    pub collisions: u32,
    /// How long it took until one was seen, at most, s.
    pub delay: f64,
}

/// The robot with its controller and observer, and the noise in between.
#[derive(Clone, Debug)]
struct Cell {
    q: [f64; NQ],
    u: [f64; NU],
    observer: Observer,
    noise: Noise,
}

impl Cell {
    /// One period, with a force on the hand, N; true where the observer sees a collision.
    fn advance(
        &mut self,
        (plant, controller): (&Prepared<f64>, &Controller),
        desired: &Desired<f64, NU>,
        force: &[f64; 3],
        calls: &mut CallTimes,
    ) -> bool {
        let tau = controller.torque(
            &in_scalar(&self.q),
            &in_scalar(&self.u),
            &desired.in_scalar(),
        );
        let tau = in_double(tau);
        rk4_step_with(plant, PERIOD, &mut self.q, &mut self.u, |q, _, pushed| {
            ur5::payload_generalized_force(plant, q, force, &[0.0; 3], pushed);
            *pushed = from_fn(|i| tau[i] + pushed[i]);
        });
        let measured: [f64; NU] =
            from_fn(|i| tau[i] + NOISE * EFFORT_LIMITS[i] * self.noise.normal());
        let (q, u) = (in_scalar(&self.q), in_scalar(&self.u));
        calls.time(|| self.observer.update(&q, &u, &in_scalar(&measured)))
    }
}

/// Lets the robot go round for a minute; every now and then, a copy of it is hit.
pub fn run(calls: &mut CallTimes) -> Report {
    let (plant, controller) = (Prepared::nominal(), Controller::new(0.0));
    let robot = (&plant, &controller);
    let (q, u) = (STOPS[0], [0.0; NU]);
    let mut cell = Cell {
        q,
        u,
        observer: Observer::new(&in_scalar(&q), &in_scalar(&u)),
        noise: Noise::new(1),
    };
    let mut report = Report::default();
    for period in 0..periods(MOVING * WAYS as f64) {
        let desired = desired(period);
        report.false_alarms += u32::from(cell.advance(robot, &desired, &[0.0; 3], calls));
        raise(&mut report.quiet, [cell.observer.part_of_threshold()]);
        report.duration += PERIOD;
        if (period + 1) % periods(BETWEEN_COLLISIONS) == 0 {
            for direction in 0..6 {
                let mut force = [0.0; 3];
                force[direction % 3] = if direction < 3 { FORCE } else { -FORCE };
                let mut hit = cell.clone();
                let seen = (1..=periods(PATIENCE))
                    .find(|i| hit.advance(robot, &self::desired(period + i), &force, calls));
                let delay = seen.map_or(f64::INFINITY, |i| i as f64 * PERIOD);
                raise(&mut report.delay, [delay]);
                report.collisions += 1;
            }
        }
    }
    report
}

/// Where to be in this period.
fn desired(period: usize) -> Desired<f64, NU> {
    let (way, period) = (period / periods(MOVING), period % periods(MOVING));
    let stop = |i: usize| &STOPS[i % STOPS.len()];
    Desired::between(stop(way), stop(way + 1), period as f64 * PERIOD, MOVING)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:.0} s without a collision: {} false alarms, residual up to {:.0} % of the threshold; {} collisions of {FORCE} N: each is seen within {:.0} ms",
            self.duration,
            self.false_alarms,
            1e2 * self.quiet,
            self.collisions,
            1e3 * self.delay,
        )
    }
}
