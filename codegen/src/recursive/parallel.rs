//! Parallel axes merged: a link on which all joints turn about its own axis need not turn itself.
//!
//! Resolved along its joint's axes before the rotation, nothing of the motion and of the wrenches that pass through it is
//! rotated there; its own numbers and the offsets on it are, and the links on it turn by the sum of both angles.

use super::{
    link::{Link, Turning},
    plan::Plan,
    rotation::{Rotation, Turn},
    rounding,
};
use crate::{
    expr::{Axis, Expr, ExprGraph},
    id::{BodyId, BodyMap},
    kane::given,
    tree::{Orientation, Tree},
};

/// Merges what the plan wants merged and what can be.
pub(super) fn run(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, links: &mut BodyMap<Link>) {
    let mut angles = BodyMap::outward(tree.bodies.len(), |_, _| None::<Angle>);
    for body in tree.body_ids() {
        let Some(axis) = tree.body(body).joint.turning_axis() else {
            continue;
        };
        graph.enter(body);
        let mut angle = own_angle(graph, tree, body, axis, &links[body]);
        if let Some((rotation, below)) = tree
            .lower(body)
            .and_then(|lower| Some((links[lower].unturned?, angles[lower]?)))
        {
            let link = &mut links[body];
            link.offset = rotation.backward(graph, link.offset);
            let along = link.constant.matrix[axis.index()][rotation.axis.index()];
            angle = angle.plus(graph, below, along.is_negative());
            let (sine, cosine) = rounding::phased(graph, angle.coordinates, angle.phase);
            graph.name(sine, format!("sin{}_sum", axis.index() + 1));
            graph.name(cosine, format!("cos{}_sum", axis.index() + 1));
            if let Turning::Angles(rotations) = &mut link.turning {
                let own = &mut rotations[axis.index()];
                (own.sine, own.cosine) = (sine, cosine);
            }
        }
        angles[body] = Some(angle);
        if plan.parallel(body) && carries_parallel_axes(graph, tree, body, axis, links) {
            unturn(graph, axis, &mut links[body]);
        }
    }
}

/// A sum of coordinates, and a constant, rad.
#[derive(Clone, Copy)]
struct Angle {
    coordinates: Expr,
    phase: f64,
}

impl Angle {
    fn plus(self, graph: &mut ExprGraph, other: Self, is_opposite: bool) -> Self {
        let sign = if is_opposite { -1.0 } else { 1.0 };
        Self {
            coordinates: graph.add(self.coordinates, other.coordinates.signed(is_opposite)),
            phase: self.phase + sign * other.phase,
        }
    }
}

fn own_angle(graph: &mut ExprGraph, tree: &Tree, body: BodyId, axis: Axis, link: &Link) -> Angle {
    let Orientation::Rates(angles) = tree.body(body).joint.orientation else {
        unreachable!("joint: an axis alone is that of an angle");
    };
    Angle {
        coordinates: given::coordinate(graph, angles[axis.index()]),
        phase: link.layout.phase,
    }
}

/// True for a link on which there are joints, all about axes parallel to its own.
pub(super) fn carries_parallel_axes(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    axis: Axis,
    links: &BodyMap<Link>,
) -> bool {
    let one = graph.one();
    let is_parallel = |&upper: &BodyId| {
        let Some(own) = tree.body(upper).joint.turning_axis() else {
            return false;
        };
        let direction = links[upper].constant.matrix[own.index()];
        // A cosine rounds to one where the sine is still 1e-8.
        let (b, c) = axis.others();
        let leans = !graph.is_zero(direction[b]) || !graph.is_zero(direction[c]);
        direction[axis.index()].abs_sign() == one && !leans
    };
    let only_turns = tree.body(body).joint.hinge_axis().is_some();
    let uppers = tree.uppers(body);
    !uppers.is_empty() && only_turns && uppers.iter().all(is_parallel)
}

/// Leaves a link's axes where its joint's are.
fn unturn(graph: &mut ExprGraph, axis: Axis, link: &mut Link) {
    let (a, (b, c)) = (axis.index(), axis.others());
    let Turning::Angles(rotations) = &mut link.turning else {
        return;
    };
    let rotation = rotations[a];
    link.inertia = rotation.backward_composite(graph, &link.inertia);
    // S_aa does not change, and I_bb = S_aa + S_cc.
    for (own, other) in [(b, c), (c, b)] {
        link.second[own] = graph.sub(link.inertia.inertia.diagonal[other], link.second[a]);
    }
    link.unturned = Some(rotation);
    rotations[a] = Rotation {
        sine: graph.zero(),
        cosine: graph.one(),
        ..rotation
    };
}
