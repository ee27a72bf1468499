//! Columns of the mass matrix on their way inward.

use super::{
    lever::Levered,
    shortcut::{Next, Sent, Shortcut},
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Vector},
    id::BodyId,
    recursive::links::{rotation::Turn, wrench::Wrench},
    tree::{Motion, Tree},
};

/// Momentum of a composite body for a unit value of one speed, about the origin and along the axes that it has reached.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Column {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    body: BodyId,
    pub(in crate::recursive) motion: Motion,
    /// The speed's coordinate among its body's: "theta1" or "w1" to "s3".
    coordinate: &'static str,
    momentum: Levered,
}

impl Column {
    pub(in crate::recursive) fn new(
        graph: &mut ExprGraph,
        body: BodyId,
        motion: Motion,
        coordinate: &'static str,
        [linear, angular]: [Vector; 2],
    ) -> Self {
        let momentum = Wrench {
            force: linear,
            moment: angular,
        };
        Self {
            body,
            motion,
            coordinate,
            momentum: Levered::new(graph, momentum),
        }
    }

    /// The momentum about (0 to 2) or along (3 to 5) an axis.
    pub(in crate::recursive) fn momentum(&self, place: usize) -> Expr {
        self.momentum.read(place)
    }

    /// The body that moves with the speed.
    pub(in crate::recursive) fn body(&self) -> BodyId {
        self.body
    }

    /// Linear and angular momentum.
    pub(in crate::recursive) fn parts(&self) -> [Vector; 2] {
        let Wrench { force, moment } = self.momentum.wrench;
        [force, moment]
    }

    /// To the axes before a rotation.
    pub(in crate::recursive) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.turn_in(graph, Some(self.body), rotation);
    }

    /// The same in another scope.
    pub(in crate::recursive) fn turn_in(
        &mut self,
        graph: &mut ExprGraph,
        scope: Option<BodyId>,
        rotation: &dyn Turn,
    ) {
        graph.enter(scope);
        self.momentum.turn(graph, rotation);
    }

    /// To the link that comes next, from whose origin the last one lies at `offset`.
    pub(in crate::recursive) fn reach(
        &mut self,
        graph: &mut ExprGraph,
        offset: Vector,
        next: Next,
    ) {
        graph.enter(self.body);
        self.momentum.reach(graph, offset, next);
    }

    /// To a point from which the origin lies at `offset`.
    pub(in crate::recursive) fn shift(&mut self, graph: &mut ExprGraph, offset: Vector) {
        self.reach(graph, offset, Next::UNKNOWN);
    }

    /// Sets the angular momentum about the origin along an axis, where that is found in another way, unless it is about another
    /// point yet.
    pub(in crate::recursive) fn set_along(
        &mut self,
        graph: &ExprGraph,
        axis: usize,
        angular: Expr,
    ) {
        if self.momentum.is_settled(graph) {
            self.momentum.wrench.moment[axis] = angular;
        }
    }

    /// Gets ready for a turn about an axis.
    pub(in crate::recursive) fn before_turn(
        &mut self,
        graph: &mut ExprGraph,
        axis: Axis,
        shortcut: Option<Shortcut>,
    ) {
        graph.enter(self.body);
        self.momentum.before_turn(graph, axis, shortcut);
    }

    /// Labels it by its coordinate and the body at whose origin it has arrived.
    pub(in crate::recursive) fn name(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        let at = &tree.body(at).identifier;
        let Wrench { force, moment } = self.momentum.wrench;
        graph.name_vector(force, &format!("{}_f_{at}", self.coordinate));
        graph.name_vector(moment, &format!("{}_n_{at}", self.coordinate));
    }
}

impl Sent for Column {
    const N_FORCES: usize = 1;

    fn stays(&self, _: &ExprGraph) -> bool {
        !self.momentum.has_left()
    }

    fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) {
        graph.enter(self.body);
        self.momentum.depart(graph, shortcut, axis);
    }
}
