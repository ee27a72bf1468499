//! A column of one body and one parameter, on its way inward.

use crate::{
    expr::{Axis, ExprGraph},
    id::BodyId,
    recursive::matrices::{
        lever::Levered,
        shortcut::{Sent, Shortcut},
    },
};

/// The wrench that a unit of one parameter needs.
pub(super) struct UnitColumn {
    pub(super) body: BodyId,
    pub(super) parameter: usize,
    pub(super) needed: Levered,
}

impl Sent for UnitColumn {
    const N_FORCES: usize = 1;

    /// Moments of inertia need no force.
    fn stays(&self, graph: &ExprGraph) -> bool {
        self.needed.has_force(graph)
    }

    fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) {
        graph.enter(self.body);
        self.needed.depart(graph, shortcut, axis);
    }
}
