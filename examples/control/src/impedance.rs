//! Impedance: the Panda's hand presses against a wall with the force asked for, and slides along it.
//!
//! The hand behaves as its own inertia on a spring and a damper, `Λ (ẍ - ẍ_d) = D (ẋ_d - ẋ) + K (x_d - x) + F`, with the
//! wall's force `F`. At rest the force is that of two springs in a row, the hand's and the wall's, and known beforehand
//! where both are. `τ = M a + b + Jᵀ f`: the `inverse_dynamics` of `a`, and what spring and damper give, `f`. Of all `a` that
//! give the hand its acceleration, `J a = ẍ_d - J̇ u`, it is the nearest to `a₀ = κ (q₀ - q) - 2 √κ u`, by kinetic energy: the
//! elbow, which can move while the hand rests, returns to its place without disturbing the hand. That is
//! `a = a₀ + M⁻¹ Jᵀ Λ (ẍ_d - J̇ u - J a₀)` with `Λ = (J M⁻¹ Jᵀ)⁻¹`.

use std::{array::from_fn, fmt};

use kane::{integrate::rk4_step_with, rotation, view};
use nalgebra::{SMatrix, SVector};

use crate::{
    CallTimes, Desired, PERIOD,
    panda::{self, EFFORT_LIMITS, NQ, NU, Prepared},
    periods, raise,
};

/// What the controller computes in.
pub type Scalar = f64;

/// `K`, N/m and N m/rad.
const STIFFNESS: [Scalar; 2] = [500.0, 30.0];
/// `D`, N s/m and N m s/rad.
const DAMPING: [Scalar; 2] = [100.0, 3.0];
/// `κ`, 1/s².
const POSTURE_STIFFNESS: Scalar = 64.0;
/// `2 √κ`, 1/s.
const POSTURE_DAMPING: Scalar = 16.0;

type Wrench = SVector<Scalar, 6>;
type Speeds = SVector<Scalar, NU>;

/// The law, and what it knows of the robot.
#[derive(Debug)]
pub struct Controller {
    robot: Prepared<Scalar>,
    /// `q₀`, rad.
    posture: [Scalar; NQ],
    /// How the hand is to be turned, as `pose` writes it: as it is at `q₀`.
    rotation: [[Scalar; 3]; 3],
}

impl Controller {
    /// Holds the hand turned as it is in this posture, rad.
    pub fn new(posture: [Scalar; NQ]) -> Self {
        let robot = Prepared::nominal();
        let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
        panda::payload_pose(&robot, &posture, &mut rotation, &mut position);
        Self {
            robot,
            posture,
            rotation,
        }
    }

    /// `τ`, for a hand that is to be at `desired`, m.
    pub fn torque(
        &self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, 3>,
    ) -> [Scalar; NU] {
        let hand = Hand::new(&self.robot, q);
        let (mut drift, mut drift_angular) = ([0.0; 3], [0.0; 3]);
        panda::payload_jacobian_dot_u(&self.robot, q, u, &mut drift, &mut drift_angular);
        let wanted = wrench(
            from_fn(|i| desired.u_dot[i] - drift[i]),
            drift_angular.map(|drift| -drift),
        );
        let a_0: Speeds = Speeds::from_fn(|i, _| {
            POSTURE_STIFFNESS * (self.posture[i] - q[i]) - POSTURE_DAMPING * u[i]
        });
        let a = a_0 + hand.accelerate(&(wanted - hand.jacobian * a_0));

        let (mut tau, mut of_hand) = ([0.0; NU], [0.0; NU]);
        panda::inverse_dynamics(&self.robot, q, u, &a.into(), &mut tau);
        let (force, moment) = self.spring_and_damper(q, u, desired);
        panda::payload_generalized_force(&self.robot, q, &force, &moment, &mut of_hand);
        from_fn(|i| tau[i] + of_hand[i])
    }

    /// `f`: a force, N, and a moment, N m.
    fn spring_and_damper(
        &self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, 3>,
    ) -> ([Scalar; 3], [Scalar; 3]) {
        let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
        panda::payload_pose(&self.robot, q, &mut rotation, &mut position);
        let (mut linear, mut angular) = ([0.0; 3], [0.0; 3]);
        panda::payload_velocity(&self.robot, q, u, &mut linear, &mut angular);
        let turn = rotation::error(&rotation, &self.rotation);
        let ([k, k_angular], [d, d_angular]) = (STIFFNESS, DAMPING);
        (
            from_fn(|i| k * (desired.q[i] - position[i]) + d * (desired.u[i] - linear[i])),
            from_fn(|i| k_angular * turn[i] - d_angular * angular[i]),
        )
    }
}

/// How the hand moves, and is moved.
struct Hand {
    /// `J`.
    jacobian: SMatrix<Scalar, 6, NU>,
    /// `M⁻¹ Jᵀ`.
    response: SMatrix<Scalar, NU, 6>,
}

impl Hand {
    fn new(robot: &Prepared<Scalar>, q: &[Scalar; NQ]) -> Self {
        let (mut linear, mut angular) = ([[0.0; NU]; 3], [[0.0; NU]; 3]);
        panda::payload_jacobian(robot, q, &mut linear, &mut angular);
        let jacobian = view::stacked(&linear, &angular);
        let mut inverse = [[0.0; NU]; NU];
        panda::mass_matrix_inverse(robot, q, &mut inverse);
        let response = SMatrix::<Scalar, NU, NU>::from(inverse) * jacobian.transpose();
        Self { jacobian, response }
    }

    /// `M⁻¹ Jᵀ Λ x`: what gives the hand the acceleration `x` and takes the least force; none where no force does, in
    /// singular postures.
    fn accelerate(&self, x: &Wrench) -> Speeds {
        let cholesky = (self.jacobian * self.response).cholesky();
        cholesky.map_or(Speeds::zeros(), |cholesky| {
            self.response * cholesky.solve(x)
        })
    }

    /// The speeds that do not move the hand: `u - M⁻¹ Jᵀ Λ J u`.
    fn null_speeds(&self, u: &Speeds) -> Speeds {
        u - self.accelerate(&(self.jacobian * u))
    }
}

fn wrench(linear: [Scalar; 3], angular: [Scalar; 3]) -> Wrench {
    let ([a, b, c], [d, e, f]) = (linear, angular);
    Wrench::new(a, b, c, d, e, f)
}

/// The hand points down, in front of the robot.
const POSTURE: [f64; NQ] = [0.0, -0.2, 0.0, -2.2, 0.0, 2.0, 0.785];
/// How far in front of the hand, along x, the wall stands at first, m.
const DISTANCE: f64 = 0.05;
/// The force asked for, N.
const FORCE: f64 = 20.0;
/// Where the hand goes along the wall, y and z, m.
const LEGS: [[f64; 2]; 3] = [[0.0, 0.0], [0.15, 0.05], [-0.1, -0.05]];
/// How long a leg moves, and how long it then holds, s.
const MOVING: f64 = 1.5;
const HOLDING: f64 = 2.0;

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// The wall's force at the end of each leg, N.
    pub forces: [f64; LEGS.len()],
    /// By what part of the force asked for they miss it, at most.
    pub force_error: f64,
    /// The greatest force, N: that of the impact.
    pub impact: f64,
    /// How far the hand is from its place along the wall at the end of a leg, at most, m.
    pub position_error: f64,
    /// The greatest speed of a joint of those that do not move the hand, rad/s.
    pub null_speed: f64,
    /// The same at the end of a leg, rad/s.
    pub null_speed_at_rest: f64,
    /// The greatest torque, as a part of the joint's limit.
    pub effort: f64,
}

/// Presses against a wall of one stiffness, by a controller that believes in another, N/m.
pub fn run(stiffness: f64, believed: f64, calls: &mut CallTimes) -> Report {
    let controller = Controller::new(POSTURE);
    let plant = Prepared::nominal();
    let start = position(&plant, &POSTURE);
    let wall = Wall {
        x: start[0] + DISTANCE,
        stiffness,
    };
    // Two springs in a row, the wall's and the hand's.
    let pressing = wall.x + FORCE * (1.0 / believed + 1.0 / STIFFNESS[0]);

    let (mut q, mut u) = (POSTURE, [0.0; NU]);
    let mut report = Report::default();
    let mut from = start;
    for (leg, [y, z]) in LEGS.into_iter().enumerate() {
        let to = [pressing, start[1] + y, start[2] + z];
        for period in 0..periods(MOVING + HOLDING) {
            let desired = Desired::between(&from, &to, period as f64 * PERIOD, MOVING);
            let tau = calls.time(|| controller.torque(&q, &u, &desired));
            raise(
                &mut report.effort,
                (0..NU).map(|i| tau[i] / EFFORT_LIMITS[i]),
            );
            rk4_step_with(&plant, PERIOD, &mut q, &mut u, |q, _, with_wall| {
                let force = [-wall.force(&position(&plant, q)), 0.0, 0.0];
                panda::payload_generalized_force(&plant, q, &force, &[0.0; 3], with_wall);
                *with_wall = from_fn(|i| tau[i] + with_wall[i]);
            });
            raise(&mut report.null_speed, null_speeds(&plant, &q, &u));
            raise(&mut report.impact, [wall.force(&position(&plant, &q))]);
        }
        let there = position(&plant, &q);
        report.forces[leg] = wall.force(&there);
        raise(&mut report.force_error, [report.forces[leg] / FORCE - 1.0]);
        raise(&mut report.position_error, (1..3).map(|i| to[i] - there[i]));
        raise(&mut report.null_speed_at_rest, null_speeds(&plant, &q, &u));
        from = to;
    }
    report
}

/// A plane across the x axis, smooth, and soft as a spring.
struct Wall {
    x: f64,
    /// N/m.
    stiffness: f64,
}

impl Wall {
    /// On the wall, along x, N.
    fn force(&self, hand: &[f64; 3]) -> f64 {
        (self.stiffness * (hand[0] - self.x)).max(0.0)
    }
}

fn position(robot: &Prepared<f64>, q: &[f64; NQ]) -> [f64; 3] {
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    panda::payload_pose(robot, q, &mut rotation, &mut position);
    position
}

fn null_speeds(robot: &Prepared<f64>, q: &[f64; NQ], u: &[f64; NU]) -> [f64; NU] {
    Hand::new(robot, q).null_speeds(&Speeds::from(*u)).into()
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.forces;
        writeln!(
            f,
            "{a:.3}, {b:.3}, {c:.3} N at rest ({:.2} % off at most), up to {:.1} N on impact, {:.1e} m from its place along the wall",
            1e2 * self.force_error,
            self.impact,
            self.position_error,
        )?;
        write!(
            f,
            "joint speeds that do not move the hand: up to {:.4} rad/s, at rest {:.1e}; torque up to {:.0} % of the limits",
            self.null_speed,
            self.null_speed_at_rest,
            1e2 * self.effort,
        )
    }
}
