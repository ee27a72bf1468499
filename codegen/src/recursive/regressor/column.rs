//! The wrench that a unit of one inertial parameter needs, on its way inward.
//!
//! Its moment is moved from point to point as late as possible: along the axis of a hinge when the hinge reads it, across that
//! only where nothing on the way is left to be moved past with it. An offset along the axis of the next hinge waits for the one
//! after that, one before a shortcut for the shortcut's.

use super::super::{rotation::Turn, shortcut::Shortcut, wrench::Wrench};
use crate::{
    expr::{Axis, ExprGraph, Vector},
    id::BodyId,
};

pub(super) struct UnitColumn {
    pub(super) body: BodyId,
    pub(super) parameter: usize,
    /// Along the axes that it has reached; the moment is about the point at `lever`.
    pub(super) wrench: Wrench,
    /// From the origin that it has reached; of a moment along an axis nothing that the axis does not feel.
    lever: Vector,
    /// The force where the root's translations are read, once it has left for them; the wrench's is zero as soon as no offset
    /// makes a moment of it any more.
    arrived: Option<Vector>,
}

impl UnitColumn {
    /// About the origin.
    pub(super) fn new(
        graph: &mut ExprGraph,
        body: BodyId,
        parameter: usize,
        wrench: Wrench,
    ) -> Self {
        Self {
            body,
            parameter,
            wrench,
            lever: graph.zero_vector(),
            arrived: None,
        }
    }

    pub(super) fn force(&self) -> Vector {
        self.arrived.unwrap_or(self.wrench.force)
    }

    /// True as long as it has a force that a lever makes a moment of.
    pub(super) fn has_force(&self, graph: &ExprGraph) -> bool {
        !graph.is_zero_vector(self.wrench.force)
    }

    /// Goes on to an origin from which the last one lies at `offset`.
    pub(super) fn reach(&mut self, graph: &mut ExprGraph, offset: Vector) {
        if self.has_force(graph) {
            self.lever = graph.add_vectors(self.lever, offset);
        }
    }

    /// True where the lever makes nothing of what acts about the axis.
    pub(super) fn is_on(&self, graph: &ExprGraph, axis: Axis) -> bool {
        let (b, c) = axis.others();
        graph.is_zero(self.lever[b]) && graph.is_zero(self.lever[c])
    }

    /// Makes the moment one about the origin: its component along an axis.
    pub(super) fn settle_along(&mut self, graph: &mut ExprGraph, axis: Axis) {
        self.add_lever(graph, self.lever, &[axis.index()]);
    }

    /// The components across the axis, where the one along it is.
    pub(super) fn settle_across(&mut self, graph: &mut ExprGraph, axis: Axis) {
        let (b, c) = axis.others();
        self.add_lever(graph, self.lever, &[b, c]);
        self.lever = graph.zero_vector();
    }

    /// All components.
    pub(super) fn settle(&mut self, graph: &mut ExprGraph) {
        self.add_lever(graph, self.lever, &[0, 1, 2]);
        self.lever = graph.zero_vector();
    }

    fn add_lever(&mut self, graph: &mut ExprGraph, lever: Vector, components: &[usize]) {
        let moment = graph.cross(lever, self.wrench.force);
        for &i in components {
            self.wrench.moment[i] = graph.add(self.wrench.moment[i], moment[i]);
        }
    }

    /// Sends the force on a shortcut past the next offset, turned: about the axis the moment is moved past it now.
    pub(super) fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) {
        self.add_lever(graph, shortcut.offset, &[axis.index()]);
        self.arrived = Some(shortcut.arrived(graph, self.wrench.force));
    }

    /// True from then on until the offset is passed.
    pub(super) fn is_departing(&self, graph: &ExprGraph) -> bool {
        self.arrived.is_some() && self.has_force(graph)
    }

    /// Moves a departing column past the turned offset across the axis too.
    pub(super) fn leave(&mut self, graph: &mut ExprGraph, offset: Vector, axis: Axis) {
        let (b, c) = axis.others();
        let whole = graph.add_vectors(offset, self.lever);
        self.add_lever(graph, whole, &[b, c]);
        self.drop_force(graph);
    }

    /// Keeps of a departing force what an offset across the axis makes a moment across it of: the part along the axis, which the
    /// turn leaves as it is.
    pub(super) fn keep_along(&mut self, graph: &mut ExprGraph, axis: Axis) {
        self.settle_across(graph, axis);
        let (b, c) = axis.others();
        (self.wrench.force[b], self.wrench.force[c]) = (graph.zero(), graph.zero());
    }

    /// Passes the offset of a departing column.
    pub(super) fn pass(&mut self, graph: &mut ExprGraph, offset: Vector) {
        self.reach(graph, offset);
        self.settle(graph);
        self.drop_force(graph);
    }

    fn drop_force(&mut self, graph: &mut ExprGraph) {
        self.lever = graph.zero_vector();
        self.wrench.force = graph.zero_vector();
    }

    /// True where no more than one component of the moment is across the axis.
    pub(super) fn is_sparse_across(&self, graph: &ExprGraph, axis: Axis) -> bool {
        let (b, c) = axis.others();
        [b, c].iter().any(|i| graph.is_zero(self.wrench.moment[*i]))
    }

    pub(super) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
        self.lever = rotation.backward(graph, self.lever);
    }
}
