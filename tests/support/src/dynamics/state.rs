//! Everything that a function can be given, and the states near it.

use kane_codegen::{
    id::CoordinateId,
    tree::{ChartCoordinates, CoordinateKind, Orientation, Tree},
};

use super::{numbering::Maps, rates::q_dot};
use crate::random::Random;

/// Everything that a function can be given.
#[derive(Clone, Debug)]
pub struct State {
    pub q: Vec<f64>,
    pub u: Vec<f64>,
    pub u_dot: Vec<f64>,
    pub tau: Vec<f64>,
    /// Force and moment, body after body.
    pub loads: Vec<[f64; 6]>,
    pub w_rel: Vec<[f64; 3]>,
}

/// What every function of a frame is given: a point of it, m, and the force, N, and moment, N m, on it.
pub const FRAME_POINT: [f64; 3] = [0.3, -0.5, 0.7];
pub const FRAME_FORCE: [f64; 3] = [1.5, -0.8, 0.6];
pub const FRAME_MOMENT: [f64; 3] = [-0.4, 0.9, 1.1];

impl State {
    /// Angles all around, but a quarter at least away from the singularity; quaternions of length one; translations, rates
    /// and loads of order one.
    pub fn random(tree: &Tree, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut q = vec![0.0; tree.n_coordinates];
        for body in &tree.bodies {
            let singular = body.joint.has_singular_chart();
            let mut parameters = Vec::new();
            for (kind, coordinate) in body.joint.coordinates() {
                let most = match kind.name() {
                    "theta2" if singular => 1.3,
                    "theta1" | "theta2" | "theta3" => 3.0,
                    _ => 1.0,
                };
                q[coordinate.index()] = most * random.symmetric();
                if matches!(kind, CoordinateKind::EulerParameter(_)) {
                    parameters.push(coordinate.index());
                }
            }
            let length = parameters.iter().map(|&e| q[e] * q[e]).sum::<f64>().sqrt();
            for e in parameters {
                q[e] /= length;
            }
        }
        let mut speeds = || (0..tree.n_speeds).map(|_| random.symmetric()).collect();
        let (u, u_dot, tau) = (speeds(), speeds(), speeds());
        let n_bodies = tree.bodies.len();
        let loads = (0..n_bodies)
            .map(|_| [0; 6].map(|_| random.symmetric()))
            .collect();
        let w_rel = (0..n_bodies)
            .map(|_| [0; 3].map(|_| random.symmetric()))
            .collect();
        Self {
            q,
            u,
            u_dot,
            tau,
            loads,
            w_rel,
        }
    }

    /// The state a time `t` later, to first order and on the unit sphere: all that a derivative along the motion depends on.
    #[must_use]
    pub fn moved(&self, tree: &Tree, t: f64) -> Self {
        let mut moved = self.along(tree, &self.u, t);
        moved.u = stepped(&self.u, &self.u_dot, t);
        moved
    }

    /// The state at which one speed, of one unit, arrives after a time `t`: a coordinate with `t` added where it is a rate.
    #[must_use]
    pub fn displaced(&self, tree: &Tree, speed: usize, t: f64) -> Self {
        let mut unit = vec![0.0; self.u.len()];
        unit[speed] = 1.0;
        self.along(tree, &unit, t)
    }

    /// The state after unit time at the constant speeds `d`, in place of its own.
    ///
    /// By 128 steps of the classical Runge-Kutta method, whose error is `|d|^5 / (120 128^4)` or so: 1e-15 for `|d|` of a tenth.
    #[must_use]
    pub fn after(&self, tree: &Tree, d: &[f64]) -> Self {
        const STEPS: u32 = 128;
        let h = 1.0 / f64::from(STEPS);
        let mut q = self.q.clone();
        for _ in 0..STEPS {
            let first = q_dot(tree, &q, d);
            let second = q_dot(tree, &stepped(&q, &first, h / 2.0), d);
            let third = q_dot(tree, &stepped(&q, &second, h / 2.0), d);
            let fourth = q_dot(tree, &stepped(&q, &third, h), d);
            for (rates, part) in [(first, 6.0), (second, 3.0), (third, 3.0), (fourth, 6.0)] {
                q = stepped(&q, &rates, h / part);
            }
        }
        Self { q, ..self.clone() }
    }

    fn along(&self, tree: &Tree, u: &[f64], t: f64) -> Self {
        let mut q = stepped(&self.q, &q_dot(tree, &self.q, u), t);
        for places in quaternions(tree) {
            let length = places.iter().map(|&e| q[e] * q[e]).sum::<f64>().sqrt();
            for e in places {
                q[e] /= length;
            }
        }
        Self { q, ..self.clone() }
    }

    /// The state of one model in the numbering of another model of the same system.
    #[must_use]
    pub fn renumbered(&self, from: &Tree, to: &Tree) -> Self {
        let maps = Maps::new(from, to);
        let numbers =
            |map: &[usize], values: &[f64]| map.iter().map(|&place| values[place]).collect();
        Self {
            q: numbers(&maps.coordinates, &self.q),
            u: numbers(&maps.speeds, &self.u),
            u_dot: numbers(&maps.speeds, &self.u_dot),
            tau: numbers(&maps.speeds, &self.tau),
            loads: maps.bodies.iter().map(|&at| self.loads[at]).collect(),
            w_rel: maps.bodies.iter().map(|&at| self.w_rel[at]).collect(),
        }
    }
}

fn stepped(x: &[f64], rates: &[f64], t: f64) -> Vec<f64> {
    let step = |(x, rate)| x + t * rate;
    x.iter().zip(rates).map(step).collect()
}

/// The places of every quaternion in `q`.
pub fn quaternions(tree: &Tree) -> impl Iterator<Item = [usize; 4]> + '_ {
    tree.bodies
        .iter()
        .filter_map(|body| match body.joint.orientation {
            Orientation::AngularVelocity {
                chart: ChartCoordinates::EulerParameters(places),
                ..
            } => Some(places.map(CoordinateId::index)),
            _ => None,
        })
}
