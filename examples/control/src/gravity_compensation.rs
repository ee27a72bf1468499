//! Gravity compensation and PD: the UR5 moves to a set point and holds it, whatever it carries.
//!
//! `τ = g(q) + Kp (q_d - q) + Kd (u_d - u)`, with the `gravity_forces` `g` of the robot and what it is believed to carry. At
//! rest `Kp (q_d - q)` bears the weight of the rest, so that the error there is known beforehand.

use std::{array::from_fn, fmt};

use kane::integrate::rk4_step;

use crate::{
    CallTimes, Desired, PERIOD, in_double, in_scalar, periods, raise,
    ur5::{self, EFFORT_LIMITS, NQ, NU, Parameters, Prepared},
};

/// What the controller computes in.
pub type Scalar = f32;

/// `Kp`, N m/rad.
const STIFFNESS: [Scalar; NU] = [2000.0, 2000.0, 1000.0, 200.0, 100.0, 50.0];
/// `Kd`, N m s/rad.
const DAMPING: [Scalar; NU] = [200.0, 200.0, 80.0, 10.0, 5.0, 2.0];

/// The law, and what it knows of the robot.
#[derive(Debug)]
pub struct Controller {
    robot: Prepared<Scalar>,
}

impl Controller {
    /// Believes that the robot carries so much, kg.
    pub fn new(payload_mass: Scalar) -> Self {
        let robot = Prepared::new(&Parameters { payload_mass });
        Self { robot }
    }

    /// `τ`.
    pub fn torque(
        &self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        desired: &Desired<Scalar, NU>,
    ) -> [Scalar; NU] {
        let mut g = [0.0; NU];
        ur5::gravity_forces(&self.robot, q, &mut g);
        from_fn(|i| {
            let (error, rate) = (desired.q[i] - q[i], desired.u[i] - u[i]);
            g[i] + STIFFNESS[i] * error + DAMPING[i] * rate
        })
    }
}

const HOME: [f64; NQ] = [0.0, -1.6, 1.2, -1.2, -1.57, 0.0];
/// Stretched out to a side: a payload has its longest levers.
const FAR: [f64; NQ] = [1.2, -0.5, 0.6, -0.4, -1.2, 0.8];
const LOW: [f64; NQ] = [-0.6, -1.0, 2.0, -2.2, -1.57, -1.0];

/// Set points, and what is in the hand on the way to each and there, kg. It is taken and let go at rest.
const LEGS: [([f64; NQ], f64); 6] = [
    (FAR, 0.0),
    (FAR, 3.0),
    (LOW, 3.0),
    (LOW, 0.0),
    (HOME, 5.0),
    (HOME, 0.0),
];
/// How long a leg moves, and how long it then holds, s.
const MOVING: f64 = 2.0;
const HOLDING: f64 = 2.0;

/// What came of all legs.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// One leg after the other.
    pub legs: [Leg; LEGS.len()],
}

/// What came of one leg; errors are the greatest of all joints, rad.
#[derive(Clone, Copy, Debug, Default)]
pub struct Leg {
    /// In the hand, kg.
    pub payload: f64,
    /// The greatest error on the way and at the set point.
    pub error: f64,
    /// The error in the end.
    pub error_at_rest: f64,
    /// The error by which `Kp` bears the payload's weight.
    pub error_of_weight: f64,
    /// The greatest torque, as a part of the joint's limit.
    pub effort: f64,
}

/// Goes through all legs, with a controller that believes the hand empty.
pub fn run(calls: &mut CallTimes) -> Report {
    let controller = Controller::new(0.0);
    let (mut q, mut u) = (HOME, [0.0; NU]);
    let mut from = HOME;
    let legs = LEGS.map(|(to, payload_mass)| {
        let plant = Prepared::new(&Parameters { payload_mass });
        let mut leg = Leg {
            payload: payload_mass,
            ..Leg::default()
        };
        for period in 0..periods(MOVING + HOLDING) {
            let desired = Desired::between(&from, &to, period as f64 * PERIOD, MOVING);
            let (q_m, u_m) = (in_scalar(&q), in_scalar(&u));
            let tau = calls.time(|| controller.torque(&q_m, &u_m, &desired.in_scalar()));
            let tau = in_double(tau);
            raise(&mut leg.error, (0..NQ).map(|i| desired.q[i] - q[i]));
            raise(&mut leg.effort, (0..NU).map(|i| tau[i] / EFFORT_LIMITS[i]));
            rk4_step(&plant, &tau, PERIOD, &mut q, &mut u);
        }
        raise(&mut leg.error_at_rest, (0..NQ).map(|i| to[i] - q[i]));
        raise(&mut leg.error_of_weight, error_of_weight(&plant, &q));
        from = to;
        leg
    });
    Report { legs }
}

/// `Kp⁻¹` times the weight that an empty hand does not have.
fn error_of_weight(plant: &Prepared<f64>, q: &[f64; NQ]) -> [f64; NQ] {
    let (mut real, mut known) = ([0.0; NU], [0.0; NU]);
    ur5::gravity_forces(plant, q, &mut real);
    ur5::gravity_forces(&Prepared::nominal(), q, &mut known);
    let stiffness = in_double(STIFFNESS);
    from_fn(|i| (real[i] - known[i]) / stiffness[i])
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for leg in &self.legs {
            writeln!(
                f,
                "{} kg in the hand: error up to {:.2} mrad, at rest {:.3} mrad (of the weight: {:.3}); torque up to {:.0} % of the limits",
                leg.payload,
                1e3 * leg.error,
                1e3 * leg.error_at_rest,
                1e3 * leg.error_of_weight,
                1e2 * leg.effort,
            )?;
        }
        Ok(())
    }
}
