//! What reads mirrored entries, of motions farther out, off their columns.

use super::way::At;
use crate::{
    expr::{Expr, ExprGraph, Vector},
    recursive::matrices::coriolis::column::CoriolisColumn,
    tree::Motion,
};

/// What reads the mirrored entries of a motion off momentum and couple.
pub(super) struct Reader {
    pub(super) motion: Motion,
    /// About (0 to 2) or along (3 to 5) an axis.
    pub(super) place: usize,
    /// By the coordinate: for the momentum, angular and linear, and for the couple.
    pub(super) by_q: [Vector; 3],
    /// By the speed: for the momentum.
    by_u: [Vector; 2],
}

impl Reader {
    pub(super) fn of_turn(
        graph: &mut ExprGraph,
        motion: Motion,
        axis: usize,
        at: &At,
        own: Vector,
    ) -> Self {
        let e = graph.unit_vector(axis);
        let u = graph.cross(at.lower.w, e);
        let d = at.lower.u.map(|row| row[axis]);
        // Couples are of velocities as the inertial frame sees them, not the joint: `2 v × u` is what that adds.
        let (felt, moved) = (graph.cross(at.after.a, e), graph.cross(at.v, u));
        let twice = graph.doubled(at.after.w);
        let (turned, own) = (graph.cross(twice, e), graph.cross(own, e));
        Self {
            motion,
            place: axis,
            by_q: [d, graph.add_vectors(felt, moved), u],
            by_u: [graph.sub_vectors(turned, own), graph.cross(at.v, e)],
        }
    }

    pub(super) fn of_shift(graph: &mut ExprGraph, motion: Motion, axis: usize, at: &At) -> Self {
        let e = graph.unit_vector(axis);
        let twice = graph.doubled(at.lower.w);
        let still = graph.zero_vector();
        Self {
            motion,
            place: 3 + axis,
            by_q: [still, at.lower.u.map(|row| row[axis]), still],
            by_u: [still, graph.cross(twice, e)],
        }
    }

    /// How the force along a motion farther out changes with the coordinate.
    pub(super) fn displaced(&self, graph: &mut ExprGraph, of: &CoriolisColumn) -> Expr {
        let [d, a, u] = self.by_q;
        let (turned, carried) = (
            graph.dot(d, of.momentum.wrench.moment),
            graph.dot(a, of.momentum.wrench.force),
        );
        let couple = graph.dot(u, of.couple);
        let sum = graph.add(turned, carried);
        graph.add(sum, couple)
    }

    /// How it changes with the speed.
    pub(super) fn driven(&self, graph: &mut ExprGraph, of: &CoriolisColumn) -> Expr {
        let [turned, lever] = self.by_u;
        let (turned, lever) = (
            graph.dot(turned, of.momentum.wrench.moment),
            graph.dot(lever, of.momentum.wrench.force),
        );
        let sum = graph.add(turned, lever);
        if self.place < 3 {
            graph.add(sum, of.couple[self.place])
        } else {
            sum
        }
    }
}
