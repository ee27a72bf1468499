//! The generalized forces of weight from composite bodies: whatever a body carries weighs at one point, and gravity is the
//! same everywhere.
//!
//! Gravity passes outward as the upward acceleration of a system at rest, mass and first moment inward; each motion of a
//! joint reads off where both stand in the same axes, so no force is carried.

use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Vector, negated},
    given::{self, Lifted},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            link::{self, Link},
            passage::{Drive, Passenger},
            rotation::Turn,
            totalled::Addend,
            wrench::{self, Wrench},
        },
        plan::Plan,
    },
    tree::{Motion, Tree},
};

/// Mass and first moment about a point.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Weight {
    pub(in crate::recursive) mass: Expr,
    pub(in crate::recursive) moment: Vector,
}

/// The upward acceleration that stands for gravity, on its way outward through a joint.
#[derive(Clone, Debug)]
struct Upward {
    /// In the axes that have been reached; in the end those of the link.
    a: Vector,
    /// The same wherever motions enter, in the order of the way.
    at_motions: Vec<Vector>,
}

/// The `tau` that holds the system at rest against weight: `-sum_K V_G_K^T m_K g`, less what lifts.
pub fn gravity_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let weights = BodyMap::outward(tree.bodies.len(), |body, _| {
        Weight::left(graph, tree, &links[body], body)
    });
    holding(graph, tree, &links, weights)
}

/// The generalized forces of what lifts bodies: what would hold as much weight.
pub fn lifting_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let weights = BodyMap::outward(tree.bodies.len(), |body, _| {
        let lifted = Weight::lifted(graph, tree, &links[body], body);
        lifted.unwrap_or_else(|| Weight::zero(graph))
    });
    holding(graph, tree, &links, weights)
}

/// What lifts each body, about its link's origin; `None` where nothing does.
pub(super) fn lifts(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
) -> BodyMap<Option<Wrench>> {
    graph.begin(Purpose::Weight);
    let upward = upward(graph, tree, links);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let weight = Weight::lifted(graph, tree, &links[body], body)?;
        let a = upward[body].a;
        Some(Wrench {
            force: graph.scale(weight.mass, a),
            moment: graph.cross(weight.moment, a),
        })
    })
}

fn upward(graph: &mut ExprGraph, tree: &Tree, links: &BodyMap<Link>) -> BodyMap<Upward> {
    let gravity = given::acting_gravity(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, upward: &BodyMap<Upward>| {
        let below = tree.lower(body).map(|lower| upward[lower].a);
        graph.enter(body);
        let mut passing = Upward {
            a: below.unwrap_or(negated(gravity)),
            at_motions: Vec::new(),
        };
        links[body].passage.outward(graph, &mut passing);
        graph.name_vector(passing.a, "a");
        passing
    })
}

/// The `tau` that holds weights about the origins of their links.
fn holding(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    mut weights: BodyMap<Weight>,
) -> Vec<Expr> {
    let upward = upward(graph, tree, links);
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

/// Nothing is read off it on the way.
impl Passenger for Weight {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        *self = self.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.moment = rotation.backward(graph, self.moment);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
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
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        self.weight.shift(graph, lower, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let a = self.next();
        for (axis, motion) in Axis::ALL.into_iter().zip(drive.motions()) {
            if motion.is_some() {
                let along = self.weight.moment_about(graph, axis, a);
                wrench::add(graph, self.tau, motion, along);
            }
        }
        self.weight.turn(graph, rotation, drive);
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
    fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            mass: graph.zero(),
            moment: graph.zero_vector(),
        }
    }

    /// What is left of a link's weight beside what is lifted, about the link's origin.
    pub(in crate::recursive) fn left(
        graph: &mut ExprGraph,
        tree: &Tree,
        link: &Link,
        body: BodyId,
    ) -> Self {
        let (mass, moment) = (link.inertia.mass, link.inertia.moment);
        match Self::lifted(graph, tree, link, body) {
            None => Self { mass, moment },
            Some(lifted) => Self {
                mass: graph.sub(mass, lifted.mass),
                moment: graph.sub_vectors(moment, lifted.moment),
            },
        }
    }

    /// What is lifted of a body, about its link's origin; `None` where nothing is.
    fn lifted(graph: &mut ExprGraph, tree: &Tree, link: &Link, body: BodyId) -> Option<Self> {
        graph.enter(body);
        let Lifted { mass, moment } = given::lifted(graph, tree.body(body))?;
        let zero = graph.zero_vector();
        let from_link = link.point_of_body(graph, zero);
        let about_body = link.of_body(graph, moment);
        let own = Self {
            mass,
            moment: about_body,
        };
        Some(own.moved(graph, from_link))
    }

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
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, offset: Vector) -> Self {
        let shift = graph.scale(self.mass, offset);
        Self {
            mass: self.mass,
            moment: graph.add_vectors(self.moment, shift),
        }
    }
}

impl Addend for Weight {
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            moment: graph.add_vectors(self.moment, other.moment),
        }
    }
}
