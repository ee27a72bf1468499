//! Motions whose accelerations are given: what forces them.
//!
//! Such a motion is not eliminated: the link with what it carries goes on inward undiminished, and the wrench that it needs is
//! that with the given acceleration. Once it is known outward what the accelerations that were sought add to the link's own,
//! the force follows.

use super::articulated_inertia::Inertia;
use crate::{
    expr::{Expr, ExprGraph, Vector},
    recursive::links::wrench::Wrench,
};

/// A motion that was passed by: about (0 to 2) or along (3 to 5) an axis.
#[derive(Clone, Debug)]
pub(in crate::recursive) struct Prescribed {
    /// What each part of an acceleration that is added needs along the motion.
    row: [Expr; 6],
    /// What the motion needs beside, for each right-hand side.
    needed: Vec<Expr>,
}

impl Prescribed {
    /// The motion at this place, of a link that resists so and needs these wrenches.
    pub(in crate::recursive) fn new(
        graph: &mut ExprGraph,
        place: usize,
        inertia: &Inertia,
        wrenches: &[Wrench],
    ) -> Self {
        let wrenches = wrenches.iter();
        Self {
            row: inertia.rows(graph)[place],
            needed: wrenches.map(|wrench| wrench.parts()[place]).collect(),
        }
    }

    /// The force, where this is added to the link's acceleration, angular and linear.
    pub(in crate::recursive) fn force(
        &self,
        graph: &mut ExprGraph,
        side: usize,
        added: &[Vector; 2],
    ) -> Expr {
        let mut sum = self.needed[side];
        for (entry, added) in self.row.iter().zip(added.as_flattened()) {
            let term = graph.mul(*entry, *added);
            sum = graph.add(sum, term);
        }
        sum
    }
}
