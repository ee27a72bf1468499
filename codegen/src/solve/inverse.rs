//! The inverse of a mass matrix, from its factors.
//!
//! With `A = L^T D L` is `L A^-1 = D^-1 L^-T`, whose right-hand side is zero unless the row's speed is the column's or farther
//! in on its branch. So `H_ij = [1 / D_i where i = j] - sum_a L_ia H_aj` follows from rows farther in, and one triangle is the
//! mirror image of the other. What lies between a speed and a body farther in is
//! eliminated from its row of L once, and serves the columns of that body and of all other branches on it.

use std::collections::BTreeSet;

use super::{
    BodySpeed, Carriers, Factors, SpeedMatrix, blocks,
    felt::{Feeling, Felt},
    inverse,
    reduced::Reduced,
};
use crate::{
    expr::{Expr, ExprGraph, Purpose},
    id::{BodyId, SpeedId},
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

/// An inverse while it is written.
pub(super) struct Writer<'a> {
    pub(super) tree: &'a Tree,
    pub(super) order: &'a [BodySpeed],
    reduced: Reduced<'a>,
    pub(super) felt: Felt<'a>,
    carriers: &'a Carriers,
    pub(super) h: SpeedMatrix,
    /// Places, `[row, column]`, that are found or left out.
    done: BTreeSet<[usize; 2]>,
}

/// What an entry is made of, beside the diagonal: a row of `-L`.
#[derive(Clone, Debug)]
pub(super) struct Rule {
    /// The body up to which all was eliminated.
    pub(super) foot: Option<BodyId>,
    /// Speeds whose entries of the column it takes, with factors.
    pub(super) direct: Vec<(BodySpeed, Expr)>,
    /// The carrier whose acceleration it feels.
    pub(super) felt: Option<(BodyId, Feeling)>,
}

impl Factors {
    /// `A^-1`; what is structurally zero is the number zero.
    pub fn inverse(&self, graph: &mut ExprGraph, tree: &Tree, how: Inversion<'_>) -> SpeedMatrix {
        graph.begin(Purpose::Inverse);
        let n = self.order.len();
        let mut writer = Writer {
            tree,
            order: &self.order,
            reduced: Reduced::new(self, how.carriers),
            felt: Felt::new(tree, how.carriers),
            carriers: how.carriers,
            h: vec![vec![graph.zero(); n]; n],
            done: BTreeSet::new(),
        };
        let stays = |place: &usize| !how.left_out.contains(&self.order[*place].speed);
        let places: Vec<usize> = (0..n).rev().filter(stays).collect();
        for (known, &i) in places.iter().enumerate() {
            if let Some(fewest) = how.in_lockstep {
                let columns = places[..known].iter().copied();
                let columns = columns.filter(|j| !writer.done.contains(&[i, *j]));
                let columns: Vec<usize> = columns.collect();
                let entries = (&places[known..], &columns[..]);
                blocks::find(graph, &mut writer, entries, fewest);
            }
            for &j in &places[..=known] {
                if writer.done.contains(&[i, j]) {
                    continue;
                }
                let rule = writer.rule(graph, i, j);
                graph.enter(self.order[i].body);
                let mut sum = graph.zero();
                if i == j {
                    let own = self.order[i];
                    sum = inverse(graph, own, self.pivots[own.index()]);
                }
                let sum = writer.entry(graph, sum, i, &rule, j);
                writer.set(graph, [i, j], sum);
            }
        }
        writer.h
    }
}

impl Writer<'_> {
    /// What the entry of a row is made of in a column farther in, or in its own.
    pub(super) fn rule(&mut self, graph: &mut ExprGraph, i: usize, j: usize) -> Rule {
        let own = self.order[i];
        graph.enter(own.body);
        let path = self.reduced.path(j);
        let (row, foot) = self.reduced.row(graph, self.tree, i, &path);
        let row = row.into_iter().map(|(a, factor)| (self.order[a], factor));
        let row: Vec<(BodySpeed, Expr)> = row.collect();
        let carrier = self.felt.carrier(own.body, foot);
        let felt = carrier.filter(|_| !row.is_empty()).map(|carrier| {
            let feeling = self.felt.feeling(graph, (own, &row), carrier);
            (carrier.0, feeling)
        });
        let is_felt = |body| felt.is_some() && self.carriers.contains(body);
        let direct = row.into_iter().filter(|(a, _)| !is_felt(a.body)).collect();
        Rule { foot, direct, felt }
    }

    /// What a rule makes of a column, added to a sum.
    fn entry(
        &mut self,
        graph: &mut ExprGraph,
        mut sum: Expr,
        i: usize,
        rule: &Rule,
        j: usize,
    ) -> Expr {
        let column = self.order[j].index();
        for &(a, factor) in &rule.direct {
            let term = graph.mul(factor, self.h[a.index()][column]);
            sum = graph.add(sum, term);
        }
        if let Some((carrier, feeling)) = &rule.felt {
            let acceleration = self.felt.acceleration(graph, &self.h, *carrier, column);
            graph.enter(self.order[i].body);
            let share = feeling.of(graph, &acceleration);
            sum = graph.add(sum, share);
        }
        sum
    }

    /// Sets an entry and its mirror image.
    pub(super) fn set(&mut self, graph: &mut ExprGraph, [i, j]: [usize; 2], entry: Expr) {
        let (own, other) = (self.order[i], self.order[j]);
        graph.enter(own.body);
        let at = &self.tree.body(other.body).identifier;
        graph.name(
            entry,
            format!("h_{}_{at}_{}", own.coordinate, other.coordinate),
        );
        self.h[own.index()][other.index()] = entry;
        self.h[other.index()][own.index()] = entry;
        self.done.insert([i, j]);
    }
}
