//! What the functions of any system must have to do with one another, and random systems to try it on.
//!
//! Included by the tests of two packages: here the functions are evaluated as programs, in `tests/systems` as
//! the compiled text.
#![allow(dead_code, reason = "each package uses its part of these")]

pub(crate) mod identities;
pub(crate) mod kinematics;
pub(crate) mod numeric;
pub(crate) mod random;

use kane_codegen::{
    functions::{Argument, Function, Shape},
    id::BodyId,
    tree::{Part, Tree},
};

use random::Random;

/// A system whose functions can be evaluated.
pub(crate) trait Model {
    /// What to call it in a message.
    fn name(&self) -> String;

    /// Its tree, with the numbering of all arrays, and the nominal values of its parameters.
    fn tree(&self) -> &Tree;

    /// The output of a function, row-major; partial velocities as dense `3 x NU` matrices, body after body.
    fn evaluate(&self, function: &str, state: &State) -> Vec<f64>;
}

/// Everything that a function can be given.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) q: Vec<f64>,
    pub(crate) u: Vec<f64>,
    pub(crate) u_dot: Vec<f64>,
    pub(crate) tau: Vec<f64>,
    /// Force and moment, body after body.
    pub(crate) loads: Vec<[f64; 6]>,
    pub(crate) w_rel: Vec<[f64; 3]>,
}

impl State {
    /// Angles all around, but a quarter at least away from the singularity; translations, rates and loads of order one.
    pub(crate) fn random(tree: &Tree, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut q = vec![0.0; tree.n_coordinates];
        for body in &tree.bodies {
            let singular = body.joint.has_singular_chart();
            let mut parameters = Vec::new();
            for (kind, coordinate) in body.joint.coordinates() {
                let most = match kind {
                    "theta2" if singular => 1.3,
                    "theta1" | "theta2" | "theta3" => 3.0,
                    _ => 1.0,
                };
                q[coordinate.index()] = most * random.symmetric();
                if kind.starts_with('e') {
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

    /// The state a time `t` later, to first order: all that a derivative along the motion depends on.
    pub(crate) fn moved(&self, t: f64) -> Self {
        let step =
            |x: &[f64], rate: &[f64]| x.iter().zip(rate).map(|(x, rate)| x + t * rate).collect();
        Self {
            q: step(&self.q, &self.u),
            u: step(&self.u, &self.u_dot),
            ..self.clone()
        }
    }

    /// The state with `t` added to one coordinate.
    pub(crate) fn displaced(&self, coordinate: usize, t: f64) -> Self {
        let mut displaced = self.clone();
        displaced.q[coordinate] += t;
        displaced
    }

    /// The state of one model in the numbering of another model of the same system.
    pub(crate) fn renumbered(&self, from: &Tree, to: &Tree) -> Self {
        let (speeds, bodies) = (speed_map(from, to), body_map(from, to));
        let numbers = |values: &[f64]| speeds.iter().map(|&place| values[place]).collect();
        Self {
            q: numbers(&self.q),
            u: numbers(&self.u),
            u_dot: numbers(&self.u_dot),
            tau: numbers(&self.tau),
            loads: bodies.iter().map(|&place| self.loads[place]).collect(),
            w_rel: bodies.iter().map(|&place| self.w_rel[place]).collect(),
        }
    }
}

/// For each speed of `to`, its place in `from`; coordinates, their names apart, are numbered alike.
fn speed_map(from: &Tree, to: &Tree) -> Vec<usize> {
    places(&from.coordinate_names(), &to.coordinate_names())
}

/// For each body of `to`, its place in `from`.
fn body_map(from: &Tree, to: &Tree) -> Vec<usize> {
    let names = |tree: &Tree| {
        tree.bodies
            .iter()
            .map(|body| body.name.clone())
            .collect::<Vec<_>>()
    };
    places(&names(from), &names(to))
}

fn places(from: &[String], to: &[String]) -> Vec<usize> {
    let place = |name: &String| {
        from.iter()
            .position(|other| other == name)
            .expect("the same names")
    };
    to.iter().map(place).collect()
}

/// The output of a function of one model in the numbering of another model of the same system.
pub(crate) fn renumbered_output(
    function: &Function,
    output: &[f64],
    from: &Tree,
    to: &Tree,
) -> Vec<f64> {
    let (speeds, bodies) = (speed_map(from, to), body_map(from, to));
    let axes: Vec<usize> = (0..3).collect();
    let maps: Vec<&Vec<usize>> = match function.shape {
        Shape::Scalar => vec![],
        Shape::Vector => vec![&axes],
        Shape::Coordinates | Shape::Speeds => vec![&speeds],
        Shape::SpeedMatrix => vec![&speeds, &speeds],
        Shape::BodyScalars => vec![&bodies],
        Shape::BodyVectors => vec![&bodies, &axes],
        Shape::BodyMatrices => vec![&bodies, &axes, &axes],
        Shape::Columns => vec![&bodies, &axes, &speeds],
    };
    let mut gathered = vec![0];
    for map in maps {
        gathered = gathered
            .iter()
            .flat_map(|place| map.iter().map(move |index| place * map.len() + index))
            .collect();
    }
    gathered.into_iter().map(|place| output[place]).collect()
}

/// True for a tree that nothing holds: every body on the inertial frame has six free coordinates.
pub(crate) fn floats(tree: &Tree) -> bool {
    tree.bodies
        .iter()
        .filter(|body| body.lower.is_none())
        .all(|body| body.joint.speeds().len() == 6)
}

/// True where the function is given something of this kind.
pub(crate) fn takes(function: &Function, argument: Argument) -> bool {
    function.arguments.contains(&argument)
}

/// The mass of a body with all that is fixed to it, kg.
pub(crate) fn mass(tree: &Tree, body: BodyId) -> f64 {
    let own = |part: &Part| tree.nominal(part.mass);
    tree.body(body).parts.iter().map(own).sum()
}
