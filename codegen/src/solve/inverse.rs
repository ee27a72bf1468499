//! The inverse of a mass matrix, from its factors.
//!
//! With `A = L^T D L` is `L A^-1 = D^-1 L^-T`, whose right-hand side is zero unless the row's speed is the column's or farther
//! in on its branch. So `H_ij = [1 / D_i where i = j] - sum_a L_ia H_aj` follows from rows farther in, and one triangle is the
//! mirror image of the other. What lies between a speed and a body farther in is
//! eliminated from its row of L once, and serves the columns of that body and of all other branches on it.

use super::{Carriers, Factors, SpeedMatrix, blocks, entries::Entries, groups, inverse};
use crate::{
    expr::{ExprGraph, Purpose},
    id::SpeedId,
    tree::Tree,
};

/// How an inverse is found.
#[derive(Clone, Copy, Debug)]
pub struct Inversion<'a> {
    /// What branches feel passes through those that [`factorise_on_carriers`](super::factorise_on_carriers) was given.
    pub carriers: &'a Carriers,
    /// Whose rows and columns stay zero. Nothing else may be eliminated before these.
    pub left_out: &'a [SpeedId],
    /// Entries that follow from others alike are found four columns at a time, by helpers, where so many columns or more are left.
    pub in_lockstep: Option<usize>,
}

impl<'a> Inversion<'a> {
    /// The whole inverse, entry by entry.
    pub fn by(carriers: &'a Carriers) -> Self {
        Self {
            carriers,
            left_out: &[],
            in_lockstep: None,
        }
    }
}

impl Factors {
    /// `A^-1`; what is structurally zero is the number zero.
    pub fn inverse(&self, graph: &mut ExprGraph, tree: &Tree, how: Inversion<'_>) -> SpeedMatrix {
        graph.begin(Purpose::Inverse);
        let n = self.order.len();
        let mut entries = Entries::new(graph, self, tree, how.carriers);
        let stays = |place: &usize| !how.left_out.contains(&self.order[*place].speed);
        let places: Vec<usize> = (0..n).rev().filter(stays).collect();
        let group = groups(tree);
        let group = |place: usize| group[self.order[place].index()];
        for (known, &i) in places.iter().enumerate() {
            if let Some(fewest) = how.in_lockstep {
                let columns = places[..known].iter().copied();
                let columns = columns.filter(|&j| group(j) == group(i) && !entries.has([i, j]));
                let columns: Vec<usize> = columns.collect();
                let of = (&places[known..], &columns[..]);
                blocks::find(graph, &mut entries, of, fewest);
            }
            for &j in &places[..=known] {
                if group(j) != group(i) || entries.has([i, j]) {
                    continue;
                }
                let rule = entries.rule(graph, i, j);
                graph.enter(self.order[i].body);
                let mut sum = graph.zero();
                if i == j {
                    let own = self.order[i];
                    sum = inverse(graph, own, self.pivots[own.index()]);
                }
                let sum = entries.entry(graph, sum, i, &rule, j);
                entries.set(graph, [i, j], sum);
            }
        }
        entries.h
    }
}
