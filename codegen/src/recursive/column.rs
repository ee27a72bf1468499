//! Columns of the mass matrix on their way inward.

use super::{rotation::Turn, shortcut::Shortcut};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::BodyId,
    tree::{Motion, Tree},
};

/// Momentum of a composite body for a unit value of one speed, about the origin and along the axes that it has reached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    body: BodyId,
    pub(super) motion: Motion,
    /// The speed's coordinate among its body's: "theta1" or "w1" to "s3".
    coordinate: &'static str,
    linear: Vector,
    angular: Vector,
    /// The linear part where its root's translations are read, once it is there; `linear` is then zero.
    arrived: Option<Vector>,
}

impl Column {
    pub(super) fn new(
        body: BodyId,
        motion: Motion,
        coordinate: &'static str,
        linear: Vector,
        angular: Vector,
    ) -> Self {
        Self {
            body,
            motion,
            coordinate,
            linear,
            angular,
            arrived: None,
        }
    }

    /// The momentum about (0 to 2) or along (3 to 5) an axis.
    pub(super) fn momentum(&self, place: usize) -> Expr {
        if place < 3 {
            self.angular[place]
        } else {
            self.arrived.unwrap_or(self.linear)[place - 3]
        }
    }

    /// The body that moves with the speed.
    pub(super) fn body(&self) -> BodyId {
        self.body
    }

    /// Linear and angular momentum.
    pub(super) fn parts(&self) -> [Vector; 2] {
        [self.linear, self.angular]
    }

    /// To the axes before a rotation.
    pub(super) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        graph.enter(self.body);
        self.linear = rotation.backward(graph, self.linear);
        self.angular = rotation.backward(graph, self.angular);
    }

    /// To a point from which the origin lies at `offset`.
    pub(super) fn shift(&mut self, graph: &mut ExprGraph, offset: Vector) {
        graph.enter(self.body);
        let lever = graph.cross(offset, self.linear);
        self.angular = graph.add_vectors(self.angular, lever);
    }

    /// True once its linear part is where its root's translations are read.
    pub(super) fn has_arrived(&self) -> bool {
        self.arrived.is_some()
    }

    /// Sends the linear part on a shortcut, past the last offset on the way.
    pub(super) fn arrive(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut) {
        self.shift(graph, shortcut.offset);
        self.arrived = Some(shortcut.arrived(graph, self.linear));
        self.linear = graph.zero_vector();
    }

    /// Labels it by its coordinate and the body at whose origin it has arrived.
    pub(super) fn name(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        let at = &tree.body(at).identifier;
        graph.name_vector(self.linear, &format!("{}_f_{at}", self.coordinate));
        graph.name_vector(self.angular, &format!("{}_n_{at}", self.coordinate));
    }
}
