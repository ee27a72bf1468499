//! The generalized forces of weight from composite bodies: whatever a body carries weighs at one point, and gravity is the
//! same everywhere.
//!
//! Gravity passes outward as the upward acceleration of a system at rest, mass and first moment inward; each motion of a
//! joint reads off where both stand in the same axes, so no force is carried.

use crate::{
    expr::{Expr, ExprGraph, Vector, negated},
    id::{BodyId, BodyMap},
    kane::given,
    recursive::{
        link::{self, Link, Turning},
        motion,
        plan::Plan,
        rotation::Turn,
    },
    tree::{Motion, Tree},
};

/// Mass and first moment about a point.
#[derive(Clone, Copy, Debug)]
struct Weight {
    mass: Expr,
    moment: Vector,
}

/// The upward acceleration that stands for gravity, on its way through a joint.
#[derive(Clone, Debug)]
struct Upward {
    /// Along the joint's axes in the lower body.
    before: Vector,
    /// After each of the joint's rotations; the last is along the body's axes.
    after: Vec<Vector>,
}

/// The `tau` that holds the system at rest against weight: `-sum_K V_G_K^T m_K g`.
pub fn gravity_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    let gravity = given::gravity(graph, tree);
    let upward = BodyMap::outward(tree.bodies.len(), |body, upward: &BodyMap<Upward>| {
        let below = tree
            .lower(body)
            .and_then(|lower| upward[lower].after.last());
        let below = below.copied().unwrap_or(negated(gravity));
        graph.enter(body);
        outward(graph, &links[body], below)
    });
    let mut weights = BodyMap::outward(tree.bodies.len(), |body, _| Weight {
        mass: links[body].inertia.mass,
        moment: links[body].inertia.moment,
    });
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let weight = weights[body];
        graph.name_vector(weight.moment, "composite");
        let weight = inward(
            graph,
            tree,
            body,
            &links[body],
            (&upward[body], weight),
            &mut tau,
        );
        if let Some(lower) = tree.lower(body) {
            graph.enter(lower);
            let below = weights[lower];
            weights[lower] = Weight {
                mass: graph.add(below.mass, weight.mass),
                moment: graph.add_vectors(below.moment, weight.moment),
            };
        }
    }
    tau
}

fn outward(graph: &mut ExprGraph, link: &Link, below: Vector) -> Upward {
    let before = link.constant.forward(graph, below);
    let after = match &link.turning {
        Turning::Matrix(matrix) => vec![graph.mul_vector(matrix, before)],
        Turning::Angles(rotations) => {
            let mut a = before;
            let turn = rotations.iter().map(|rotation| {
                a = rotation.forward(graph, a);
                a
            });
            turn.collect()
        }
    };
    if let Some(last) = after.last() {
        graph.name_vector(*last, "a");
    }
    Upward { before, after }
}

/// Reads off what a joint's motions need, and brings the weight to the lower body's origin and axes.
fn inward(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    link: &Link,
    (upward, weight): (&Upward, Weight),
    tau: &mut [Expr],
) -> Weight {
    let joint = &tree.body(body).joint;
    let Weight { mass, mut moment } = weight;
    let turns = link::angular_velocity(joint);
    if let (Some(motions), Some(a)) = (turns, upward.after.last()) {
        for (axis, motion) in motions.into_iter().enumerate() {
            add_turn(graph, tau, Some(motion), axis, (moment, *a));
        }
    }
    match &link.turning {
        Turning::Angles(rotations) => {
            for (rotation, a) in rotations.iter().zip(&upward.after).rev() {
                add_turn(
                    graph,
                    tau,
                    rotation.motion,
                    rotation.axis.index(),
                    (moment, *a),
                );
                moment = rotation.backward(graph, moment);
            }
        }
        Turning::Matrix(matrix) => {
            moment = matrix.backward(graph, moment);
        }
    }
    for (axis, shift) in joint.shifts().into_iter().enumerate() {
        if shift.is_some() {
            let along = graph.mul(mass, upward.before[axis]);
            motion::add(graph, tau, shift, along);
        }
    }
    moment = link.constant.backward(graph, moment);
    if tree.lower(body).is_some() {
        let shift = graph.scale(mass, link.offset);
        moment = graph.add_vectors(moment, shift);
    }
    Weight { mass, moment }
}

/// Adds the component of `moment × a` along an axis to the force of the speed that turns about it.
fn add_turn(
    graph: &mut ExprGraph,
    tau: &mut [Expr],
    motion: Option<Motion>,
    axis: usize,
    (moment, a): (Vector, Vector),
) {
    if motion.is_none() {
        return;
    }
    let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
    let (plus, minus) = (graph.mul(moment[b], a[c]), graph.mul(moment[c], a[b]));
    let along = graph.sub(plus, minus);
    motion::add(graph, tau, motion, along);
}
