//! Forces as they are linear in inertial parameters: those of each body's ten parameters, one at a time.
//!
//! The parameters are those of a body about the user's origin and along the user's axes: mass, first moment and inertia, that is
//! `m`, `m c`, and the components of [`PARAMETERS`] that follow.

use std::collections::BTreeMap;

use super::{
    dynamics::{self, Wrench},
    velocity::{self, BodyAccelerations, Partials},
};
use crate::{
    expr::{Expr, ExprGraph, Symmetric, Vector, negated},
    given::{self, Accelerations},
    id::{BodyId, BodyMap, SpeedId},
    tree::{N_INERTIAL, Tree},
};

/// The names of a body's inertial parameters, in their order.
pub const PARAMETERS: [&str; N_INERTIAL] = [
    "m", "mcx", "mcy", "mcz", "ixx", "ixy", "iyy", "ixz", "iyz", "izz",
];

/// The row and the column of each component of the inertia.
pub const COMPONENTS: [[usize; 2]; 6] = [[0, 0], [0, 1], [1, 1], [0, 2], [1, 2], [2, 2]];

/// For each speed, body and parameter what `tau` has of it: Eq. (36) of the inertia forces of a body that has this parameter
/// of one, and no other.
pub fn regressor(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tree = &*tree.with_whole_weights();
    let motion = velocity::accelerations(graph, tree, Accelerations::Given);
    let relative = &motion.rotational.relative;
    let gravity = dynamics::gravity_in_bodies(graph, tree, relative);
    let partials = velocity::partials(graph, tree, relative);
    let mut y = vec![graph.zero(); tree.n_speeds * tree.bodies.len() * PARAMETERS.len()];
    for body in tree.body_ids() {
        let felt = Felt::new(graph, tree, body, &motion, &gravity);
        let [v, w] = rows(graph, tree, body, &motion, &partials);
        for parameter in 0..PARAMETERS.len() {
            let Wrench { force, moment } = felt.wrench(graph, parameter);
            for (columns, part) in [(&v, force), (&w, moment)] {
                for &(speed, column) in columns {
                    let term = graph.dot(column, part);
                    let entry = &mut y[place(tree, speed.index(), body, parameter)];
                    *entry = graph.add(*entry, term);
                }
            }
        }
    }
    y
}

/// Where the entry of a speed, a body and a parameter stands.
pub fn place(tree: &Tree, speed: usize, body: BodyId, parameter: usize) -> usize {
    (speed * tree.bodies.len() + body.index()) * PARAMETERS.len() + parameter
}

/// The row and the column, `10 body + parameter`, of each entry that the tree does not make zero, column after column: those of
/// the speeds that move a body, and of those that turn none of its joints in the columns of mass and first moment alone.
pub fn places(tree: &Tree) -> Vec<[usize; 2]> {
    let mut places = Vec::new();
    // Of each body the speeds that move it, and whether they turn it.
    let mut moving: Vec<BTreeMap<SpeedId, bool>> = Vec::with_capacity(tree.bodies.len());
    for (place, body) in tree.bodies.iter().enumerate() {
        let below = body.lower.map(|lower| moving[lower.index()].clone());
        let mut speeds = below.unwrap_or_default();
        for (motion, own) in body.joint.motions().into_iter().enumerate() {
            if let Some(own) = own {
                *speeds.entry(own.speed).or_default() |= motion < 3;
            }
        }
        for parameter in 0..PARAMETERS.len() {
            let column = place * PARAMETERS.len() + parameter;
            let felt = speeds.iter().filter(|&(_, turns)| *turns || parameter < 4);
            places.extend(felt.map(|(speed, _)| [speed.index(), column]));
        }
        moving.push(speeds);
    }
    places
}

type Columns = Vec<(SpeedId, Vector)>;

/// Partial velocities of the user's origin, and partial angular velocities: the user's axes, one column a speed.
fn rows(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    motion: &BodyAccelerations,
    partials: &Partials,
) -> [Columns; 2] {
    graph.enter(body);
    let pose = &tree.body(body).pose;
    let origin = given::fixed(graph, &pose.origin);
    let axes = given::constant(graph, &pose.rotation);
    let carried = partials.origin[body].premultiplied(graph, &motion.rotational.relative[body]);
    let swept = partials.angular[body].crossed(graph, origin);
    let linear = carried.plus(graph, swept);
    [&linear, &partials.angular[body]].map(|row| {
        let row = row.premultiplied(graph, &axes);
        row.merged_columns(graph, tree)
    })
}

/// A body's motion as its parts feel it: the user's axes.
struct Felt {
    /// Acceleration of the user's origin, less gravity.
    a: Vector,
    w: Vector,
    alpha: Vector,
}

impl Felt {
    fn new(
        graph: &mut ExprGraph,
        tree: &Tree,
        body: BodyId,
        motion: &BodyAccelerations,
        gravity: &BodyMap<Vector>,
    ) -> Self {
        graph.enter(body);
        let pose = &tree.body(body).pose;
        let (w, alpha) = (motion.rotational.w[body], motion.alpha[body]);
        let origin = given::fixed(graph, &pose.origin);
        let center = given::mass_center(graph, tree.body(body));
        let lever = graph.sub_vectors(origin, center);
        let around = acceleration(graph, w, alpha, lever);
        let a = graph.add_vectors(motion.mass_center[body], around);
        let a = graph.sub_vectors(a, gravity[body]);
        let axes = given::constant(graph, &pose.rotation);
        let [a, w, alpha] = [a, w, alpha].map(|v| graph.mul_vector(&axes, v));
        Self { a, w, alpha }
    }

    /// What a body needs that has this parameter of one, and no other.
    fn wrench(&self, graph: &mut ExprGraph, parameter: usize) -> Wrench {
        let zero = graph.zero_vector();
        let Self { a, w, alpha } = *self;
        match parameter {
            0 => Wrench {
                force: a,
                moment: zero,
            },
            1..4 => {
                let first = graph.unit_vector(parameter - 1);
                Wrench {
                    force: acceleration(graph, w, alpha, first),
                    moment: graph.cross(first, a),
                }
            }
            _ => {
                let inertia = unit_inertia(graph, COMPONENTS[parameter - 4]);
                Wrench {
                    force: zero,
                    moment: dynamics::euler(graph, &inertia, w, alpha),
                }
            }
        }
    }
}

/// `alpha × r + w × (w × r)`.
fn acceleration(graph: &mut ExprGraph, w: Vector, alpha: Vector, r: Vector) -> Vector {
    let turned = graph.cross(r, w);
    let inward = graph.cross(w, negated(turned));
    let accelerated = graph.cross(alpha, r);
    graph.add_vectors(accelerated, inward)
}

/// An inertia of which one component is one.
fn unit_inertia(graph: &mut ExprGraph, [row, column]: [usize; 2]) -> Symmetric {
    let mut inertia = graph.zero_symmetric();
    let one = graph.one();
    if row == column {
        inertia.diagonal[row] = one;
    } else {
        inertia.mixed[3 - row - column] = one;
    }
    inertia
}
