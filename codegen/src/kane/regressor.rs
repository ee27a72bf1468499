//! Forces as they are linear in inertial parameters: those of each body's ten parameters, one at a time.
//!
//! The parameters are those of a body about the user's origin and along the user's axes: mass, first moment and inertia, that is
//! `m`, `m c`, and the components of [`InertialParameter`] that follow.

use super::{
    dynamics::{self, Wrench},
    velocity::{self, BodyAccelerations, Partials},
};
use crate::{
    expr::{Expr, ExprGraph, Symmetric, Vector, negated},
    given::{self, Accelerations},
    id::{BodyId, BodyMap, SpeedId},
    tree::{InertialParameter, N_INERTIAL, Tree, regressor_place},
};

/// For each speed, body and parameter what `tau` has of it: Eq. (36) of the inertia forces of a body that has this parameter
/// of one, and no other.
pub fn regressor(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tree = &*tree.with_whole_weights();
    let motion = velocity::accelerations(graph, tree, Accelerations::Given);
    let relative = &motion.rotational.relative;
    let gravity = dynamics::gravity_in_bodies(graph, tree, relative);
    let partials = velocity::partials(graph, tree, relative);
    let mut y = vec![graph.zero(); tree.n_speeds * tree.bodies.len() * N_INERTIAL];
    for body in tree.body_ids() {
        let felt = Felt::new(graph, tree, body, &motion, &gravity);
        let [v, w] = rows(graph, tree, body, &motion, &partials);
        for parameter in 0..N_INERTIAL {
            let Wrench { force, moment } = felt.wrench(graph, parameter);
            for (columns, part) in [(&v, force), (&w, moment)] {
                for &(speed, column) in columns {
                    let term = graph.dot(column, part);
                    let entry = &mut y[regressor_place(tree, speed.index(), body, parameter)];
                    *entry = graph.add(*entry, term);
                }
            }
        }
    }
    y
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
                let inertia = unit_inertia(
                    graph,
                    InertialParameter::COMPONENTS[parameter - InertialParameter::INERTIAS.start],
                );
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
