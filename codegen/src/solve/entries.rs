//! The entries of an inverse while it is written: what each is made of, and those that are found.

use std::collections::BTreeSet;

use super::{
    BodySpeed, Carriers, Factors, RootMotion, SpeedMatrix,
    felt::{Feeling, Felt},
    reduced::Reduced,
    zero_matrix,
};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyId,
    tree::Tree,
};

/// An inverse while it is written.
pub(super) struct Entries<'a> {
    pub(super) tree: &'a Tree,
    pub(super) order: &'a [BodySpeed],
    reduced: Reduced<'a>,
    felt: Felt<'a>,
    carriers: &'a Carriers,
    pub(super) h: SpeedMatrix,
    /// Places, `[row, column]`, that are found.
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

impl<'a> Entries<'a> {
    pub(super) fn new(
        graph: &mut ExprGraph,
        factors: &'a Factors,
        tree: &'a Tree,
        carriers: &'a Carriers,
    ) -> Self {
        Self {
            tree,
            order: &factors.order,
            reduced: Reduced::new(factors, carriers),
            felt: Felt::new(tree, carriers),
            carriers,
            h: zero_matrix(graph, tree.n_speeds),
            done: BTreeSet::new(),
        }
    }

    /// True once an entry, `[row, column]`, is found.
    pub(super) fn has(&self, place: [usize; 2]) -> bool {
        self.done.contains(&place)
    }

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
    pub(super) fn entry(
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
            let acceleration = self.acceleration(graph, *carrier, j);
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

    /// The acceleration of a carrier in a column.
    pub(super) fn acceleration(
        &mut self,
        graph: &mut ExprGraph,
        carrier: BodyId,
        j: usize,
    ) -> RootMotion {
        let column = self.order[j].index();
        self.felt.acceleration(graph, &self.h, carrier, column)
    }
}
