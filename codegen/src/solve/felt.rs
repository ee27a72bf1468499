//! What a branch feels of a column of the inverse: how its carrier accelerates, along the motions of the root.

use std::collections::BTreeMap;

use super::{
    BodySpeed, SpeedMatrix,
    carriers::{Carriers, RootMotion},
};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyId,
    tree::Tree,
};

/// Accelerations of carriers, by column.
pub(super) struct Felt<'a> {
    tree: &'a Tree,
    carriers: &'a Carriers,
    known: BTreeMap<(BodyId, usize), RootMotion>,
}

impl<'a> Felt<'a> {
    pub(super) fn new(tree: &'a Tree, carriers: &'a Carriers) -> Self {
        Self {
            tree,
            carriers,
            known: BTreeMap::new(),
        }
    }

    /// The carrier by which a row feels what is farther in, and whether that is all it feels: a row from which all beyond `foot`
    /// was eliminated, or nothing.
    pub(super) fn carrier(&self, own: BodyId, foot: Option<BodyId>) -> Option<(BodyId, bool)> {
        let below = foot.or_else(|| self.tree.lower(own));
        let carrier = self.carriers.toward(self.tree, below)?;
        Some((carrier, below == Some(carrier)))
    }

    /// The acceleration of a carrier in a column whose entries farther in are known.
    fn acceleration(
        &mut self,
        graph: &mut ExprGraph,
        h: &SpeedMatrix,
        carrier: BodyId,
        column: usize,
    ) -> RootMotion {
        if let Some(known) = self.known.get(&(carrier, column)) {
            return *known;
        }
        let below = self.tree.lower(carrier);
        let found = match (self.carriers.own(carrier), below) {
            (Some((speed, motion)), Some(lower)) => {
                let below = self.acceleration(graph, h, lower, column);
                graph.enter(carrier);
                let rate = h[speed.index()][column];
                let mut sum = below;
                for (sum, part) in sum.iter_mut().zip(motion) {
                    let term = graph.mul(part, rate);
                    *sum = graph.add(*sum, term);
                }
                sum
            }
            _ => self
                .carriers
                .root(carrier)
                .map(|own| h[own.index()][column]),
        };
        self.known.insert((carrier, column), found);
        found
    }

    /// What a row of `-L` makes of a carrier's acceleration in a column; of the row its entries of the root are read.
    pub(super) fn share(
        &mut self,
        graph: &mut ExprGraph,
        h: &SpeedMatrix,
        (own, row): (BodySpeed, &[(BodySpeed, Expr)]),
        (carrier, is_all): (BodyId, bool),
        column: usize,
    ) -> Expr {
        let mut felt = self.acceleration(graph, h, carrier, column);
        graph.enter(own.body);
        let mut sum = graph.zero();
        let mut known = None;
        if is_all && self.carriers.own(carrier).is_none() {
            // Where the root moves as a joint on it gives way, all on it stays, and the joint itself moves back.
            if let Some((released, is_own)) = self.carriers.released(self.tree, own.body) {
                let pivot = released.pivot;
                let part = graph.div(felt[pivot], released.motion[pivot]);
                for (place, felt) in felt.iter_mut().enumerate() {
                    if place != pivot {
                        let taken = graph.mul(released.motion[place], part);
                        *felt = graph.sub(*felt, taken);
                    }
                }
                if is_own {
                    sum = -part;
                }
                known = Some(pivot);
            }
        }
        for (place, speed) in self.carriers.root(carrier).into_iter().enumerate() {
            let entry = row.iter().find(|(other, _)| other.speed == speed);
            if let (Some(&(_, factor)), false) = (entry, known == Some(place)) {
                let term = graph.mul(factor, felt[place]);
                sum = graph.add(sum, term);
            }
        }
        sum
    }
}
