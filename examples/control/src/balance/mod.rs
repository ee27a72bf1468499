//! Balance: the Solo 12 stands on four feet, is pushed, and comes back.
//!
//! Feet that stand do not accelerate, `J u̇ + J̇ u = 0`: the joints follow the base. No motor acts on the base, so that its rows
//! of `M u̇ + b = Sᵀ τ + Jᵀ f` say how the ground's forces `f` at the feet accelerate it. So `u̇`, `τ` and the rate of all momentum are
//! linear in `f`, but for a constant. A quadratic program finds the forces, within the pyramids of friction and the limits of
//! the motors, for which `m c̈ = m (ω² (c_d - c) - 2 ω ċ)` leads the mass centre `c` back, and likewise the base's angular acceleration
//! its orientation, as nearly as can be.

mod controller;
mod ground;
mod program;
mod sizes;

use std::{array::from_fn, fmt};

use kane::{integrate::rk4_step_with, rotation};

use crate::{
    CallTimes, PERIOD, periods, raise,
    solo12::{self, NQ, NU, Prepared},
};

pub use controller::Controller;
use ground::{Feet, Ground, part_of_friction};
use program::SLOPE;
pub use sizes::Scalar;
use sizes::{FEET, MOTORS, ROOT};

/// How the legs stand, rad: hips straight, knees bent backward.
const LEG: [f64; 3] = [0.0, 0.8, -1.6];
/// How many steps of the plant make a period: the ground's damper slows a foot down at some 4000 1/s.
const STEPS: usize = 10;
/// The robot stands so long, is pushed so long, and is watched so long, s.
const STANDING: f64 = 0.3;
const PUSHING: f64 = 0.15;
const WATCHED: f64 = 3.0;

/// What came of it.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// How far the base was from its place, m.
    pub displacement: f64,
    /// The same in the end.
    pub displacement_at_rest: f64,
    /// The sine of the angle by which the base was turned.
    pub turn: f64,
    /// The same in the end.
    pub turn_at_rest: f64,
    /// How far a foot has slipped, all in all, m.
    pub slip: f64,
    /// What the foot that pressed least pressed, N.
    pub least_force: f64,
    /// The greatest force along the ground, as a part of what friction can bear.
    pub friction: f64,
    /// The same of the forces that the controller chose, as a part of its pyramid.
    pub pyramid: f64,
    /// The greatest torque, N m.
    pub torque: f64,
    /// The most iterations that the solver needed.
    pub iterations: u32,
    /// In how many periods the controller found no forces.
    pub failures: u32,
}

/// How long things took.
#[derive(Clone, Debug, Default)]
pub struct Times {
    /// The solver of the quadratic program.
    pub program: CallTimes,
    /// All else that the controller does.
    pub rest: CallTimes,
}

/// Pushes the base with a force, N, along x, y and z. `solving` makes the calls of the solver, which allocates.
pub fn run(
    force: [f64; 3],
    controller: &mut Controller,
    times: &mut Times,
    solving: impl Fn(&mut dyn FnMut()),
) -> Report {
    let plant = Prepared::nominal();
    let (mut q, mut u) = (posture(), [0.0; NU]);
    let mut ground = Ground::new(&Feet::new(&plant, &q, &u));
    let start = base(&plant, &q);
    let mut report = Report::default();
    for period in 0..periods(WATCHED) {
        let Times { program, rest } = times;
        let tau = rest.time_without(program, |program| {
            controller.torque(&q, &u, |solve| program.time(|| solving(solve)))
        });
        let pushed = (periods(STANDING)..periods(STANDING + PUSHING)).contains(&period);
        let force = if pushed { force } else { [0.0; 3] };
        for _ in 0..STEPS {
            let step = PERIOD / STEPS as f64;
            rk4_step_with(&plant, step, &mut q, &mut u, |q, u, all| {
                let mut push = [0.0; NU];
                solo12::base_link_generalized_force(&plant, q, &force, &[0.0; 3], &mut push);
                let feet = ground.forces(&Feet::new(&plant, q, u));
                let held = ground::generalized(&plant, q, &feet);
                let motor = |i: usize| if i < ROOT { 0.0 } else { tau[i - ROOT] };
                *all = from_fn(|i| motor(i) + push[i] + held[i]);
            });
            let feet = Feet::new(&plant, &q, &u);
            ground.slip(&feet);
            report.see_feet(&ground.forces(&feet));
        }
        report.see_base(&start, &base(&plant, &q));
        report.see_controller(controller, &tau);
    }
    raise(&mut report.slip, ground.slipped);
    report
}

/// `q` on four feet, which the ground bears.
pub fn posture() -> [f64; NQ] {
    let plant = Prepared::nominal();
    let mut q = [0.0; NQ];
    q[0] = 1.0;
    for (i, q) in q[NQ - MOTORS..].iter_mut().enumerate() {
        *q = LEG[i % LEG.len()];
    }
    let u = [0.0; NU];
    let (feet, mut m) = (Feet::new(&plant, &q, &u), [[0.0; NU]; NU]);
    let mut weight = [0.0; NU];
    solo12::mass_matrix_and_bias(&plant, &q, &u, &mut m, &mut weight);
    // The base's third translation, along which all weight is: a foot bears a quarter.
    q[6] = -feet.position[0][2] - Ground::sinking(weight[5] / FEET as f64);
    q
}

/// Where the base is, m, and how it is turned, as `pose` writes it.
fn base(robot: &Prepared<f64>, q: &[f64; NQ]) -> ([f64; 3], [[f64; 3]; 3]) {
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    solo12::base_link_pose(robot, q, &mut rotation, &mut position);
    (position, rotation)
}

impl Report {
    fn see_feet(&mut self, forces: &[[f64; 3]; FEET]) {
        for force in forces {
            // What is not a number stays.
            let above = self.least_force.is_nan() || force[2] >= self.least_force;
            self.least_force = if above { self.least_force } else { force[2] };
            raise(&mut self.friction, [part_of_friction(*force)]);
        }
    }

    fn see_base(
        &mut self,
        (start, upright): &([f64; 3], [[f64; 3]; 3]),
        (position, rotation): &([f64; 3], [[f64; 3]; 3]),
    ) {
        let [x, y, z] = from_fn(|i| position[i] - start[i]);
        let [a, b, c] = rotation::error(upright, rotation);
        self.displacement_at_rest = x.hypot(y).hypot(z);
        self.turn_at_rest = a.hypot(b).hypot(c);
        raise(&mut self.displacement, [self.displacement_at_rest]);
        raise(&mut self.turn, [self.turn_at_rest]);
    }

    fn see_controller(&mut self, controller: &Controller, tau: &[Scalar; MOTORS]) {
        raise(&mut self.torque, *tau);
        self.iterations = self.iterations.max(controller.iterations());
        self.failures = controller.failures;
        for [x, y, z] in controller.forces().into_iter().flatten() {
            let most = SLOPE * z;
            raise(&mut self.pyramid, [x / most, y / most]);
        }
    }
}

impl Default for Report {
    fn default() -> Self {
        Self {
            displacement: 0.0,
            displacement_at_rest: f64::NAN,
            turn: 0.0,
            turn_at_rest: f64::NAN,
            slip: 0.0,
            least_force: f64::INFINITY,
            friction: 0.0,
            pyramid: 0.0,
            torque: 0.0,
            iterations: 0,
            failures: 0,
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "the base moves by {:.1} mm and turns by {:.1} mrad; in the end {:.2e} mm and {:.2e} mrad",
            1e3 * self.displacement,
            1e3 * self.turn,
            1e3 * self.displacement_at_rest,
            1e3 * self.turn_at_rest,
        )?;
        write!(
            f,
            "feet slip by {:.3} mm at most, press with {:.2} N at least, pull with {:.0} % of friction (chosen: {:.0} % of the pyramid); torque up to {:.2} N m; the solver needs up to {} iterations and fails {} times",
            1e3 * self.slip,
            self.least_force,
            1e2 * self.friction,
            1e2 * self.pyramid,
            self.torque,
            self.iterations,
            self.failures,
        )
    }
}
