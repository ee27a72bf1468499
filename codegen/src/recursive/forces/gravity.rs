//! The generalized forces of weight from composite bodies: whatever a body carries weighs at one point, and gravity is the
//! same everywhere.
//!
//! Gravity passes outward as the upward acceleration of a system at rest, mass and first moment inward; each motion of a
//! joint reads off where both stand in the same axes, so no force is carried.

use super::weight::{Field, Weight};
use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Vector},
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

/// The upward acceleration that stands for gravity, on its way outward through a joint.
#[derive(Clone, Debug)]
struct Upward {
    /// In the axes that have been reached; in the end those of the link.
    a: Vector,
    /// True where no joint has turned it yet: no moment is needed before the first that does.
    is_inertial: bool,
    /// Where motions meet it, in the order of the way.
    meetings: Vec<Meeting>,
}

/// The upward acceleration where a weight meets it.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    a: Vector,
    /// The side of the rotation, outward.
    side: Side,
}

#[derive(Clone, Copy, Debug)]
enum Side {
    Before,
    After,
}

impl Side {
    fn of<T>(self, before: T, after: T) -> T {
        match self {
            Self::Before => before,
            Self::After => after,
        }
    }
}

/// The `tau` that holds the system at rest against weight: `-sum_K V_G_K^T m_K g`, less what lifts.
pub fn gravity_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let field = Field::new(graph, tree, plan);
    holding_left(graph, tree, plan, &field)
}

/// The same from first moments of composite bodies, where these are needed for something else.
pub fn gravity_forces_of_masses(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let field = Field::of_masses(graph, tree);
    holding_left(graph, tree, plan, &field)
}

fn holding_left(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, field: &Field) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let weights = BodyMap::outward(tree.bodies.len(), |body, _| {
        Weight::left(graph, tree, field, &links[body], body)
    });
    holding(graph, tree, field, &links, weights)
}

/// The generalized forces of what lifts bodies: what would hold as much weight.
pub fn lifting_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let weights = BodyMap::outward(tree.bodies.len(), |body, _| {
        let lifted = Weight::lifted(graph, tree, &links[body], body);
        lifted.unwrap_or_else(|| Weight::zero(graph))
    });
    let field = Field::of_masses(graph, tree);
    holding(graph, tree, &field, &links, weights)
}

/// What lifts each body, about its link's origin; `None` where nothing does.
pub(super) fn lifts(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
) -> BodyMap<Option<Wrench>> {
    graph.begin(Purpose::Weight);
    let field = Field::of_masses(graph, tree);
    let upward = upward(graph, tree, &field, links);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let weight = Weight::lifted(graph, tree, &links[body], body)?;
        let a = upward[body].a;
        Some(Wrench {
            force: graph.scale(weight.mass, a),
            moment: graph.cross(weight.moment, a),
        })
    })
}

fn upward(
    graph: &mut ExprGraph,
    tree: &Tree,
    field: &Field,
    links: &BodyMap<Link>,
) -> BodyMap<Upward> {
    BodyMap::outward(tree.bodies.len(), |body, upward: &BodyMap<Upward>| {
        let below = tree.lower(body).map(|lower| &upward[lower]);
        graph.enter(body);
        let mut passing = Upward {
            a: below.map_or(field.upward, |below| below.a),
            is_inertial: below.is_none_or(|below| below.is_inertial),
            meetings: Vec::new(),
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
    field: &Field,
    links: &BodyMap<Link>,
    mut weights: BodyMap<Weight>,
) -> Vec<Expr> {
    let upward = upward(graph, tree, field, links);
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let weight = weights[body];
        graph.name_vector(weight.moment, "composite");
        let mut hanging = Hanging {
            weight,
            upward: &upward[body].meetings,
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

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let before = self.a;
        self.a = rotation.forward(graph, before);
        let side = match drive {
            Drive::Angle(..) if self.is_inertial => Side::After,
            _ => drive.met(Side::Before, Side::After),
        };
        let a = side.of(before, self.a);
        self.is_inertial &= matches!(drive, Drive::Nothing);
        self.meetings.push(Meeting { a, side });
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {
        let (a, side) = (self.a, Side::After);
        self.meetings.push(Meeting { a, side });
    }
}

/// A weight on its way inward through a joint, whose motions read off what they need.
struct Hanging<'a> {
    weight: Weight,
    /// The upward acceleration wherever motions of the rest of the way meet it.
    upward: &'a [Meeting],
    tau: &'a mut [Expr],
}

impl Hanging<'_> {
    /// The upward acceleration where the next motions meet it.
    fn next(&mut self) -> Meeting {
        let (meeting, rest) = self
            .upward
            .split_last()
            .expect("gravity: the way inward is the way outward");
        self.upward = rest;
        *meeting
    }
}

impl Passenger for Hanging<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        self.weight.shift(graph, lower, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let Meeting { a, side } = self.next();
        let after = self.weight;
        self.weight.turn(graph, rotation, drive);
        let weight = side.of(self.weight, after);
        for (axis, motion) in Axis::ALL.into_iter().zip(drive.motions()) {
            if motion.is_some() {
                let along = weight.moment_about(graph, axis, a);
                wrench::add(graph, self.tau, motion, along);
            }
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let Meeting { a, .. } = self.next();
        for (motion, a) in motions.into_iter().zip(a) {
            if motion.is_some() {
                let along = graph.mul(self.weight.mass, a);
                wrench::add(graph, self.tau, motion, along);
            }
        }
    }
}
