//! The generalized forces of weight from composite bodies: whatever a body carries weighs at one point, and gravity is the
//! same everywhere.
//!
//! Gravity passes outward as the upward acceleration of a system at rest, mass and first moment inward; each motion of a
//! joint reads off where both stand in the same axes, so no force is carried.

use crate::{
    expr::{Expr, ExprGraph, Vector, negated},
    id::BodyMap,
    kane::given,
    recursive::{
        link::{self, Link, Turning},
        motion,
        plan::Plan,
        rotation::Turn,
    },
    tree::{Joint, Motion, Tree},
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
        let (joint, link) = (&tree.body(body).joint, &links[body]);
        let weight = weight.through_joint(graph, joint, link, &upward[body], &mut tau);
        if let Some(lower) = tree.lower(body) {
            let moved = weight.moved(graph, link.offset);
            graph.enter(lower);
            weights[lower] = weights[lower].plus(graph, &moved);
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

impl Weight {
    /// Reads off what a joint's motions need, and turns the weight to the lower link's axes.
    fn through_joint(
        &self,
        graph: &mut ExprGraph,
        joint: &Joint,
        link: &Link,
        upward: &Upward,
        tau: &mut [Expr],
    ) -> Self {
        let mut weight = *self;
        let turns = link::angular_velocity(joint);
        if let (Some(motions), Some(a)) = (turns, upward.after.last()) {
            for (axis, motion) in motions.into_iter().enumerate() {
                weight.add_turn(graph, Some(motion), axis, *a, tau);
            }
        }
        match &link.turning {
            Turning::Angles(rotations) => {
                for (rotation, a) in rotations.iter().zip(&upward.after).rev() {
                    weight.add_turn(graph, rotation.motion, rotation.axis.index(), *a, tau);
                    weight.moment = rotation.backward(graph, weight.moment);
                }
            }
            Turning::Matrix(matrix) => {
                weight.moment = matrix.backward(graph, weight.moment);
            }
        }
        for (axis, shift) in joint.shifts().into_iter().enumerate() {
            if shift.is_some() {
                let along = graph.mul(weight.mass, upward.before[axis]);
                motion::add(graph, tau, shift, along);
            }
        }
        weight.moment = link.constant.backward(graph, weight.moment);
        weight
    }

    /// Adds the component of `moment × a` along an axis to the force of the speed that turns about it.
    fn add_turn(
        &self,
        graph: &mut ExprGraph,
        motion: Option<Motion>,
        axis: usize,
        a: Vector,
        tau: &mut [Expr],
    ) {
        if motion.is_none() {
            return;
        }
        let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
        let (plus, minus) = (
            graph.mul(self.moment[b], a[c]),
            graph.mul(self.moment[c], a[b]),
        );
        let along = graph.sub(plus, minus);
        motion::add(graph, tau, motion, along);
    }

    /// About a point from which this one's point lies at `offset`.
    fn moved(&self, graph: &mut ExprGraph, offset: Vector) -> Self {
        let shift = graph.scale(self.mass, offset);
        Self {
            mass: self.mass,
            moment: graph.add_vectors(self.moment, shift),
        }
    }

    /// Both together, about the same point.
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            moment: graph.add_vectors(self.moment, other.moment),
        }
    }
}
