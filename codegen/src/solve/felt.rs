//! What a branch feels of a column of the inverse: how its carrier accelerates, along the motions of the root.

use std::collections::BTreeMap;

use super::{
    BodySpeed, SpeedMatrix,
    carriers::{Carriers, Released, RootMotion},
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
    pub(super) fn acceleration(
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

    /// What a row of `-L` makes of a carrier's acceleration, of which this says whether it is all that the row feels.
    pub(super) fn feeling(
        &self,
        graph: &mut ExprGraph,
        (own, row): (BodySpeed, &[(BodySpeed, Expr)]),
        (carrier, is_all): (BodyId, bool),
    ) -> Feeling {
        let entry = |speed| row.iter().find(|(other, _)| other.speed == speed);
        let root = self.carriers.root(carrier);
        let mut entries =
            root.map(|speed| entry(speed).map_or(graph.zero(), |(_, factor)| *factor));
        // Where the root moves as a joint on it gives way, all on it stays, and the joint itself moves back.
        let on_root = is_all && self.carriers.own(carrier).is_none();
        let released = on_root.then(|| self.carriers.released(self.tree, own.body));
        let released = released
            .flatten()
            .map(|(own, is_own)| (own.clone(), is_own));
        if let Some((released, _)) = &released {
            entries[released.pivot] = graph.zero();
        }
        Feeling { entries, released }
    }
}

/// How a speed feels a carrier.
#[derive(Clone, Debug)]
pub(super) struct Feeling {
    /// What it makes of each of the motions of the root.
    entries: RootMotion,
    /// The joint that gives way, and whether it is the speed's own.
    released: Option<(Released, bool)>,
}

impl Feeling {
    /// The same of other numbers, such as those of a helper.
    pub(super) fn map(&self, mut of: impl FnMut(Expr) -> Expr) -> Self {
        let released = self.released.as_ref().map(|(own, is_own)| {
            let motion = own.motion.map(&mut of);
            let pivot = own.pivot;
            (Released { motion, pivot }, *is_own)
        });
        Self {
            entries: self.entries.map(&mut of),
            released,
        }
    }

    /// What is felt of a carrier's acceleration.
    pub(super) fn of(&self, graph: &mut ExprGraph, acceleration: &RootMotion) -> Expr {
        let mut felt = *acceleration;
        let mut sum = graph.zero();
        if let Some((Released { motion, pivot }, is_own)) = &self.released {
            let part = graph.div(felt[*pivot], motion[*pivot]);
            for (place, felt) in felt.iter_mut().enumerate() {
                if place != *pivot {
                    let taken = graph.mul(motion[place], part);
                    *felt = graph.sub(*felt, taken);
                }
            }
            if *is_own {
                sum = -part;
            }
        }
        for (&factor, felt) in self.entries.iter().zip(felt) {
            let term = graph.mul(factor, felt);
            sum = graph.add(sum, term);
        }
        sum
    }
}
