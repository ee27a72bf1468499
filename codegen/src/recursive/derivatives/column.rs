//! Columns: what a motion makes of the masses that it moves.

use super::super::{
    coriolis::Column as Carrying,
    rotation::Turn,
    shortcut::{Sent, Shortcut},
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::BodyId,
    tree::Tree,
};

/// What the masses that a motion moves need and have, about the origin and along the axes that have been reached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// For its speed: what is needed of a change of it, momentum and couple.
    pub(super) carrying: Carrying,
    /// Moment and force that are needed of a change of its coordinate.
    pub(super) displaced: [Vector; 2],
    /// The forces that are needed, by the speed and by the coordinate, where the root's translations are read, once they are
    /// there; linear parts are then zero.
    pub(super) arrived: Option<[Vector; 2]>,
}

impl Column {
    /// What is needed by the speed and by the coordinate, about (0 to 2) or along (3 to 5) an axis.
    pub(super) fn needed(&self, place: usize) -> [Expr; 2] {
        let moments = [self.carrying.needed[0], self.displaced[0]];
        let forces = [self.carrying.needed[1], self.displaced[1]];
        match place {
            0..3 => moments.map(|moment| moment[place]),
            _ => self.arrived.unwrap_or(forces).map(|force| force[place - 3]),
        }
    }

    pub(super) fn shift(&mut self, graph: &mut ExprGraph, offset: Vector) {
        self.carrying.shift(graph, offset);
        let lever = graph.cross(offset, self.displaced[1]);
        self.displaced[0] = graph.add_vectors(self.displaced[0], lever);
    }

    /// Names by hints what has come to a link, of a change of the coordinate `n_by_q`, `f_by_q`.
    pub(super) fn hint(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        self.carrying.hint(graph, tree, at);
        let (name, at) = (self.carrying.name(tree), &tree.body(at).identifier);
        graph.hint(|graph| {
            let [moment, force] = self.displaced;
            graph.name_vector(moment, &format!("{name}_n_by_q_{at}"));
            graph.name_vector(force, &format!("{name}_f_by_q_{at}"));
        });
    }

    pub(super) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.carrying.turn(graph, rotation);
        self.displaced = self.displaced.map(|v| rotation.backward(graph, v));
    }
}

impl Sent for Column {
    fn has_arrived(&self) -> bool {
        self.arrived.is_some()
    }

    /// Sends the forces that are needed on a shortcut. Momentum stays: it is read off for rows on the way.
    fn arrive(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut) {
        graph.enter(self.carrying.body);
        let arrived = [&mut self.carrying.needed, &mut self.displaced].map(|[moment, force]| {
            let lever = graph.cross(shortcut.offset, *force);
            *moment = graph.add_vectors(*moment, lever);
            let arrived = shortcut.arrived(graph, *force);
            *force = graph.zero_vector();
            arrived
        });
        self.arrived = Some(arrived);
    }
}
