//! Parallel axes merged: a link on which all joints turn about its own axis need not turn itself.
//!
//! Resolved along its joint's axes before the rotation, nothing of the motion and of the wrenches that pass through it is
//! rotated there; its own numbers and the offsets on it are, and the links on it turn by the sum of both angles.

use super::{
    inertia::LinkInertia,
    layout::{self, Layout},
    passage::Passage,
    rotation::{AxisRotation, Turn},
    rounding,
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Symmetric, Vector},
    given,
    id::{BodyId, BodyMap},
    recursive::plan::Plan,
    tree::{Joint, Tree},
};

/// A rotation about a joint's axis, and the angle that it is by.
#[derive(Clone, Copy, Debug)]
pub(super) struct AngleRotation {
    rotation: AxisRotation,
    angle: Angle,
}

/// A sum of coordinates, and a constant, rad.
#[derive(Clone, Copy, Debug)]
struct Angle {
    coordinates: Expr,
    phase: f64,
}

/// The bodies that need not turn: all axes on them are parallel to their own.
pub fn parallel_axes(tree: &Tree, plan: &Plan) -> Vec<BodyId> {
    let layouts = layout::layouts(&mut ExprGraph::default(), tree, plan);
    let is_parallel = |body: &BodyId| carries_parallel_axes(tree, *body, &layouts);
    tree.body_ids().filter(is_parallel).collect()
}

/// For every body whether its link does not turn: where the plan says so, and it can be.
pub(super) fn unturned(tree: &Tree, plan: &Plan, layouts: &BodyMap<Layout>) -> BodyMap<bool> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        plan.parallel(body) && carries_parallel_axes(tree, body, layouts)
    })
}

/// True for a link on which there are joints, all about axes parallel to its own.
fn carries_parallel_axes(tree: &Tree, body: BodyId, layouts: &BodyMap<Layout>) -> bool {
    let Some(axis) = tree.body(body).joint.hinge_axis() else {
        return false;
    };
    let is_parallel = |&upper: &BodyId| {
        let Some(own) = tree.body(upper).joint.turning_axis() else {
            return false;
        };
        let direction = layouts[upper].constant[own.index()];
        // A cosine rounds to one where the sine is still 1e-8.
        let (b, c) = axis.others();
        direction[axis.index()].abs() == 1.0 && [direction[b], direction[c]] == [0.0; 2]
    };
    let uppers = tree.uppers(body);
    !uppers.is_empty() && uppers.iter().all(is_parallel)
}

/// A link's passage, turned by the angles of the links below that do not turn as well, of which `below` is the last; and its
/// rotation, if it turns about one axis alone.
pub(super) fn merged(
    graph: &mut ExprGraph,
    joint: &Joint,
    layout: &Layout,
    passage: Passage,
    below: Option<AngleRotation>,
) -> (Passage, Option<AngleRotation>) {
    let own = AngleRotation::own(graph, joint, layout, &passage);
    let (Some(rotation), Some(below)) = (own, below) else {
        return (passage, own);
    };
    let passage = passage.on_unturned(graph, &below.rotation);
    let sum = rotation.after(graph, layout, &below);
    (passage.with_rotation(sum.rotation), Some(sum))
}

impl AngleRotation {
    /// That of a joint that turns about one axis alone.
    fn own(
        graph: &mut ExprGraph,
        joint: &Joint,
        layout: &Layout,
        passage: &Passage,
    ) -> Option<Self> {
        let axis = joint.turning_axis()?;
        let angle = joint.angles()?[axis.index()];
        Some(Self {
            rotation: passage.rotation(axis),
            angle: Angle {
                coordinates: given::coordinate(graph, angle),
                phase: layout.phase,
            },
        })
    }

    /// The rotation on a lower link that does not turn: that one's too.
    fn after(&self, graph: &mut ExprGraph, layout: &Layout, below: &Self) -> Self {
        let axis = self.rotation.axis;
        let is_opposite = layout.constant[axis.index()][below.rotation.axis.index()] < 0.0;
        let angle = self.angle.plus(graph, below.angle, is_opposite);
        let (sine, cosine) = rounding::phased(graph, angle.coordinates, angle.phase);
        graph.name(sine, format!("sin{}_sum", axis.index() + 1));
        graph.name(cosine, format!("cos{}_sum", axis.index() + 1));
        let rotation = AxisRotation { axis, sine, cosine };
        Self { rotation, angle }
    }

    /// The axis.
    pub(in crate::recursive) fn axis(&self) -> Axis {
        self.rotation.axis
    }

    /// The same, further by a constant angle.
    pub(super) fn with_phase(&self, graph: &mut ExprGraph, phase: f64) -> AxisRotation {
        let Angle {
            coordinates,
            phase: own,
        } = self.angle;
        let (sine, cosine) = rounding::phased(graph, coordinates, own + phase);
        AxisRotation {
            axis: self.rotation.axis,
            sine,
            cosine,
        }
    }

    /// Passage and inertia of a link that does not turn by it: its axes are the joint's.
    pub(in crate::recursive) fn left_out(
        &self,
        graph: &mut ExprGraph,
        passage: Passage,
        inertia: &LinkInertia,
    ) -> (Passage, LinkInertia) {
        let inertia = self.before(graph, inertia);
        let none = AxisRotation::none(graph, self.rotation.axis);
        (passage.with_rotation(none), inertia)
    }

    /// Components along the joint's axes of a vector given along the axes that it turns to.
    pub(in crate::recursive) fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.rotation.backward(graph, v)
    }

    /// Components along the axes that it turns to of a vector given along the joint's.
    pub(in crate::recursive) fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.rotation.forward(graph, v)
    }

    /// As [`Self::backward`], of a symmetric tensor.
    pub(in crate::recursive) fn backward_symmetric(
        &self,
        graph: &mut ExprGraph,
        tensor: &Symmetric,
    ) -> Symmetric {
        self.rotation.backward_symmetric(graph, tensor)
    }

    fn before(&self, graph: &mut ExprGraph, inertia: &LinkInertia) -> LinkInertia {
        let (a, (b, c)) = (self.rotation.axis.index(), self.rotation.axis.others());
        let composite = self.rotation.backward_composite(graph, &inertia.composite);
        let mut second = inertia.second;
        // S_aa does not change, and I_bb = S_aa + S_cc.
        for (own, other) in [(b, c), (c, b)] {
            second[own] = graph.sub(composite.inertia.diagonal[other], second[a]);
        }
        LinkInertia { composite, second }
    }
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
