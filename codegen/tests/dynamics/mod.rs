//! What the functions of any system must have to do with one another, and random systems to try it on.
//!
//! Included by the tests of two packages: here the functions are evaluated as programs, in `tests/systems` as
//! the compiled text.
#![allow(dead_code, reason = "each package uses its part of these")]

pub(crate) mod composition;
pub(crate) mod identities;
pub(crate) mod kinematics;
pub(crate) mod list;
pub(crate) mod numeric;
pub(crate) mod random;

use kane_codegen::{
    functions::{Axis, Function, Shape},
    id::CoordinateId,
    tree::{Body, ChartCoordinates as Chart, Coordinate, Orientation, Tree},
};

use composition::{Composition, q_dot};
use random::Random;

/// A system whose functions can be evaluated.
pub(crate) trait Model {
    /// What to call it in a message.
    fn name(&self) -> String;

    /// What its description comes to.
    fn composition(&self) -> &Composition;

    /// Its tree, with the numbering of all arrays, and the nominal values of its parameters.
    fn tree(&self) -> &Tree {
        self.composition().tree()
    }

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
    /// Angles all around, but a quarter at least away from the singularity; quaternions of length one; translations, rates
    /// and loads of order one.
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

    /// The state a time `t` later, to first order and on the unit sphere: all that a derivative along the motion depends on.
    pub(crate) fn moved(&self, tree: &Tree, t: f64) -> Self {
        let mut moved = self.along(tree, &self.u, t);
        moved.u = stepped(&self.u, &self.u_dot, t);
        moved
    }

    /// The state at which one speed, of one unit, arrives after a time `t`: a coordinate with `t` added where it is a rate.
    pub(crate) fn displaced(&self, tree: &Tree, speed: usize, t: f64) -> Self {
        let mut unit = vec![0.0; self.u.len()];
        unit[speed] = 1.0;
        self.along(tree, &unit, t)
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
    pub(crate) fn renumbered(&self, from: &Tree, to: &Tree) -> Self {
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
pub(crate) fn quaternions(tree: &Tree) -> impl Iterator<Item = [usize; 4]> + '_ {
    tree.bodies
        .iter()
        .filter_map(|body| match body.joint.orientation {
            Orientation::AngularVelocity {
                chart: Chart::EulerParameters(places),
                ..
            } => Some(places.map(CoordinateId::index)),
            _ => None,
        })
}

/// For each body, coordinate and speed of one model its place in another model of the same system, by their names.
#[derive(Clone, Debug)]
pub(crate) struct Maps {
    pub(crate) bodies: Vec<usize>,
    pub(crate) coordinates: Vec<usize>,
    pub(crate) speeds: Vec<usize>,
}

impl Maps {
    pub(crate) fn new(from: &Tree, to: &Tree) -> Self {
        Self {
            bodies: Self::of_bodies(from, to),
            coordinates: places(&from.coordinate_names(), &to.coordinate_names()),
            speeds: places(&from.speed_names(), &to.speed_names()),
        }
    }

    /// Of models that may differ in what their coordinates are.
    pub(crate) fn of_bodies(from: &Tree, to: &Tree) -> Vec<usize> {
        let names = |tree: &Tree| {
            tree.bodies
                .iter()
                .map(|body| body.name.clone())
                .collect::<Vec<_>>()
        };
        places(&names(from), &names(to))
    }
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
    let Maps {
        bodies,
        coordinates,
        speeds,
    } = Maps::new(from, to);
    let axes: Vec<usize> = (0..3).collect();
    let pairs = speed_pairs(&speeds, from, to);
    let shape = function.outputs[0].shape;
    // The columns of a compact output are spread over all speeds.
    let dense = [Axis::Bodies, Axis::Three, Axis::Speeds];
    let counted: &[Axis] = if shape == Shape::COLUMNS {
        &dense
    } else {
        shape.axes
    };
    let map = |axis: &Axis| match axis {
        Axis::Three => &axes,
        Axis::Coordinates => &coordinates,
        Axis::Speeds => &speeds,
        Axis::SpeedPairs => &pairs,
        Axis::Bodies => &bodies,
        Axis::Columns => unreachable!("spread over bodies and speeds"),
    };
    let maps: Vec<&Vec<usize>> = counted.iter().map(map).collect();
    let mut gathered = vec![0];
    for map in maps {
        gathered = gathered
            .iter()
            .flat_map(|place| map.iter().map(move |index| place * map.len() + index))
            .collect();
    }
    gathered.into_iter().map(|place| output[place]).collect()
}

/// For each pair of coupled speeds of one model its place among those of another model of the same system.
fn speed_pairs(speeds: &[usize], from: &Tree, to: &Tree) -> Vec<usize> {
    let places: Vec<[usize; 2]> = from.coupled_speeds().into_iter().collect();
    let place = |pair: [usize; 2]| {
        let [row, column] = pair.map(|speed| speeds[speed]);
        let pair = [row.max(column), row.min(column)];
        let found = places.iter().position(|place| *place == pair);
        found.expect("the trees are the same but for their order")
    };
    to.coupled_speeds().into_iter().map(place).collect()
}

/// True for a tree that nothing holds: every body on the inertial frame has six free coordinates, and no rotor.
pub(crate) fn floats(composition: &Composition) -> bool {
    let tree = composition.tree();
    let is_free = roots(tree).all(|body| body.joint.speeds().len() == 6);
    let on_root = |speed| root_speeds(tree).any(|own| own == speed);
    is_free
        && !composition
            .acting()
            .iter()
            .any(|acting| acting.has_rotor() && on_root(acting.speed()))
}

fn roots(tree: &Tree) -> impl Iterator<Item = &Body> {
    tree.bodies.iter().filter(|body| body.lower.is_none())
}

/// The speeds of the bodies on the inertial frame.
pub(crate) fn root_speeds(tree: &Tree) -> impl Iterator<Item = usize> + '_ {
    roots(tree).flat_map(|body| {
        let speeds = body.joint.speeds().into_iter();
        speeds.map(|(_, speed)| speed.index())
    })
}

/// True where the coordinate of some joint follows another.
pub(crate) fn has_mimics(tree: &Tree) -> bool {
    tree.bodies.iter().any(|body| {
        (0..6).any(|motion| {
            let coordinate = body.joint.coordinate_of(motion);
            matches!(coordinate, Some(Coordinate::Mimic { .. }))
        })
    })
}
