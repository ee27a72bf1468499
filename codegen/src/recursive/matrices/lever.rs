//! A force and its moment, or momenta, on their way inward, where joints read off nothing but what acts along and about their
//! axes.
//!
//! The moment is moved from point to point as late as possible: along the axis of a hinge when the hinge reads it, across that
//! only when nothing on the way is left with which it could be moved. An offset along the axis of the next hinge waits for the
//! one after that, one before a shortcut for the shortcut's.

use super::shortcut::{Next, Shortcut};
use crate::{
    expr::{Axis, Expr, ExprGraph, Vector},
    recursive::links::{rotation::Turn, wrench::Wrench},
};

/// A force, or linear momentum, and its moment about a point that need not be the origin.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Levered {
    /// Along the axes that it has reached; the moment is about the point at `lever`.
    pub(in crate::recursive) wrench: Wrench,
    /// From the origin that it has reached; what the next joint reads of the moment is about the origin already.
    lever: Vector,
    /// The force where the root's translations are read, once it has left for them; the wrench's is zero as soon as no offset
    /// makes a moment of it any more.
    arrived: Option<Vector>,
}

impl Levered {
    /// With a moment about the origin.
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, wrench: Wrench) -> Self {
        Self {
            wrench,
            lever: graph.zero_vector(),
            arrived: None,
        }
    }

    /// All of its numbers.
    pub(in crate::recursive) fn parts_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let Wrench { force, moment } = &mut self.wrench;
        let own = [force, moment, &mut self.lever].into_iter();
        own.chain(&mut self.arrived).flatten()
    }

    /// What the joint reads about (0 to 2) or along (3 to 5) an axis.
    pub(in crate::recursive) fn read(&self, place: usize) -> Expr {
        match place {
            0..3 => self.wrench.moment[place],
            _ => self.arrived.unwrap_or(self.wrench.force)[place - 3],
        }
    }

    /// True as long as it has a force that a lever makes a moment of.
    pub(in crate::recursive) fn has_force(&self, graph: &ExprGraph) -> bool {
        !graph.is_zero_vector(self.wrench.force)
    }

    /// True once the force has left.
    pub(in crate::recursive) fn has_left(&self) -> bool {
        self.arrived.is_some()
    }

    /// True from then on until the offset is passed.
    pub(in crate::recursive) fn is_departing(&self, graph: &ExprGraph) -> bool {
        self.has_left() && self.has_force(graph)
    }

    /// True where the moment is about the origin.
    pub(in crate::recursive) fn is_settled(&self, graph: &ExprGraph) -> bool {
        graph.is_zero_vector(self.lever)
    }

    /// Makes the moment one about the origin.
    fn settle(&mut self, graph: &mut ExprGraph) {
        self.add_lever(graph, self.lever, &[0, 1, 2]);
        self.lever = graph.zero_vector();
    }

    /// About a point from which the last origin lies at `offset`.
    pub(in crate::recursive) fn reach(
        &mut self,
        graph: &mut ExprGraph,
        offset: Vector,
        next: Next,
    ) {
        if self.has_force(graph) {
            self.lever = graph.add_vectors(self.lever, offset);
        }
        if self.has_left() {
            self.settle(graph);
            self.wrench.force = graph.zero_vector();
            return;
        }
        match next.hinge {
            Some(axis) if next.leaves || self.waits(graph, axis) => {
                self.add_lever(graph, self.lever, &[axis.index()]);
            }
            _ => self.settle(graph),
        }
    }

    /// Sends the force on a shortcut past the next offset: about the axis the moment is moved past it now.
    pub(in crate::recursive) fn depart(
        &mut self,
        graph: &mut ExprGraph,
        shortcut: &Shortcut,
        axis: Axis,
    ) {
        self.add_lever(graph, shortcut.offset, &[axis.index()]);
        self.arrived = Some(shortcut.arrived(graph, self.wrench.force));
    }

    /// Makes the moment one about all that is left of the way, along the axes before a turn.
    pub(in crate::recursive) fn settle_past(
        &mut self,
        graph: &mut ExprGraph,
        shortcut: Option<Shortcut>,
        axis: Axis,
    ) {
        match shortcut.filter(|_| self.is_departing(graph)) {
            Some(shortcut) => self.leave(graph, shortcut.offset, axis),
            None => self.settle(graph),
        }
    }

    /// Moves the moment past the turned offset across the axis too.
    fn leave(&mut self, graph: &mut ExprGraph, offset: Vector, axis: Axis) {
        let (b, c) = axis.others();
        let whole = graph.add_vectors(offset, self.lever);
        self.add_lever(graph, whole, &[b, c]);
        self.lever = graph.zero_vector();
        self.wrench.force = graph.zero_vector();
    }

    /// Settles before a turn about an axis what cannot wait until after it.
    pub(in crate::recursive) fn before_turn(
        &mut self,
        graph: &mut ExprGraph,
        axis: Axis,
        shortcut: Option<Shortcut>,
    ) {
        let (b, c) = axis.others();
        match shortcut.filter(|_| self.is_departing(graph)) {
            Some(shortcut) if self.passes_later(graph, &shortcut, axis) => {
                self.settle_across(graph, axis);
                // Of this an offset across the axis makes a moment across it, and the turn leaves it as it is.
                (self.wrench.force[b], self.wrench.force[c]) = (graph.zero(), graph.zero());
            }
            Some(shortcut) => self.leave(graph, shortcut.offset, axis),
            None if self.is_on(graph, axis) => {}
            None => self.settle_across(graph, axis),
        }
    }

    /// True where it takes no more products to pass an offset after the turn than to pass it turned, with the lever.
    fn passes_later(&self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) -> bool {
        let whole = graph.add_vectors(shortcut.offset, self.lever);
        let (b, c) = axis.others();
        let n_products = |lever: Vector| {
            let is_there = |i: usize| usize::from(!graph.is_zero(lever[i]));
            2 * is_there(axis.index()) + is_there(b) + is_there(c)
        };
        graph.is_zero(shortcut.offset[axis.index()])
            && n_products(self.lever) + shortcut.n_across <= n_products(whole)
    }

    /// To the axes before a rotation.
    pub(in crate::recursive) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
        self.lever = rotation.backward(graph, self.lever);
    }

    /// True where no more than one component of the moment is across the axis.
    pub(in crate::recursive) fn is_sparse_across(&self, graph: &ExprGraph, axis: Axis) -> bool {
        let (b, c) = axis.others();
        [b, c].iter().any(|i| graph.is_zero(self.wrench.moment[*i]))
    }

    /// True where the lever is along the axis, and a turn about that makes its moment no denser.
    fn waits(&self, graph: &ExprGraph, axis: Axis) -> bool {
        let (b, c) = axis.others();
        let is_dense = |i: usize| graph.as_number(self.wrench.force[i]).is_none();
        self.is_on(graph, axis) && is_dense(b) && is_dense(c)
    }

    /// True where the lever makes nothing of what acts about the axis, and a turn about that leaves it as it is.
    fn is_on(&self, graph: &ExprGraph, axis: Axis) -> bool {
        let (b, c) = axis.others();
        graph.is_zero(self.lever[b]) && graph.is_zero(self.lever[c])
    }

    fn settle_across(&mut self, graph: &mut ExprGraph, axis: Axis) {
        let (b, c) = axis.others();
        self.add_lever(graph, self.lever, &[b, c]);
        self.lever = graph.zero_vector();
    }

    fn add_lever(&mut self, graph: &mut ExprGraph, lever: Vector, components: &[usize]) {
        let moment = graph.cross(lever, self.wrench.force);
        for &i in components {
            self.wrench.moment[i] = graph.add(self.wrench.moment[i], moment[i]);
        }
    }
}
