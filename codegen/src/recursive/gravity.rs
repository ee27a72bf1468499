//! The generalized forces of weight from composite bodies: whatever a body carries weighs at one point, and gravity is the
//! same everywhere.
//!
//! Gravity passes outward as the upward acceleration of a system at rest, mass and first moment inward; each motion of a
//! joint reads off where both stand in the same axes, so no force is carried.

use super::{
    link,
    passage::{Drive, Passenger},
    plan::Plan,
    rotation::Turn,
    wrench,
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Vector, negated},
    given,
    id::{BodyId, BodyMap},
    tree::{Motion, Tree},
};

/// Mass and first moment about a point.
#[derive(Clone, Copy, Debug)]
struct Weight {
    mass: Expr,
    moment: Vector,
}

/// The upward acceleration that stands for gravity, on its way outward through a joint.
#[derive(Clone, Debug)]
struct Upward {
    /// In the axes that have been reached; in the end those of the link.
    a: Vector,
    /// The same wherever motions enter, in the order of the way.
    at_motions: Vec<Vector>,
}

/// The `tau` that holds the system at rest against weight: `-sum_K V_G_K^T m_K g`.
pub fn gravity_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let gravity = given::gravity(graph, tree);
    let upward = BodyMap::outward(tree.bodies.len(), |body, upward: &BodyMap<Upward>| {
        let below = tree.lower(body).map(|lower| upward[lower].a);
        graph.enter(body);
        let mut passing = Upward {
            a: below.unwrap_or(negated(gravity)),
            at_motions: Vec::new(),
        };
        links[body].passage.outward(graph, &mut passing);
        graph.name_vector(passing.a, "a");
        passing
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
        let mut hanging = Hanging {
            weight,
            upward: &upward[body].at_motions,
            tau: &mut tau,
        };
        links[body].passage.inward(graph, &mut hanging);
        let weight = hanging.weight;
        if let Some(lower) = tree.lower(body) {
            graph.enter(lower);
            weights[lower] = weights[lower].plus(graph, &weight);
        }
    }
    tau
}

impl Passenger for Upward {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.a = rotation.forward(graph, self.a);
        self.at_motions.push(self.a);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {
        self.at_motions.push(self.a);
    }
}

/// A weight on its way inward through a joint, whose motions read off what they need.
struct Hanging<'a> {
    weight: Weight,
    /// The upward acceleration wherever motions of the rest of the way enter.
    upward: &'a [Vector],
    tau: &'a mut [Expr],
}

impl Hanging<'_> {
    /// The upward acceleration where the next motions enter.
    fn next(&mut self) -> Vector {
        let (a, rest) = self
            .upward
            .split_last()
            .expect("gravity: the way inward is the way outward");
        self.upward = rest;
        *a
    }
}

impl Passenger for Hanging<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.weight = self.weight.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let a = self.next();
        for (axis, motion) in Axis::ALL.into_iter().zip(drive.motions()) {
            if motion.is_some() {
                let along = self.weight.moment_about(graph, axis, a);
                wrench::add(graph, self.tau, motion, along);
            }
        }
        self.weight.moment = rotation.backward(graph, self.weight.moment);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let a = self.next();
        for (motion, a) in motions.into_iter().zip(a) {
            if motion.is_some() {
                let along = graph.mul(self.weight.mass, a);
                wrench::add(graph, self.tau, motion, along);
            }
        }
    }
}

impl Weight {
    /// The component of `moment × a` along an axis.
    fn moment_about(&self, graph: &mut ExprGraph, axis: Axis, a: Vector) -> Expr {
        let (b, c) = axis.others();
        let (plus, minus) = (
            graph.mul(self.moment[b], a[c]),
            graph.mul(self.moment[c], a[b]),
        );
        graph.sub(plus, minus)
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
