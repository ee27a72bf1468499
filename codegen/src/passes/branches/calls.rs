//! Which groups a call computes: those of a layer, or a part of them where they move more numbers than a compiler takes.

use std::collections::BTreeSet;

use super::{groups::Groups, layers::Layers};
use crate::expr::{Expr, ExprGraph, NodeId};

/// The most rows of numbers that a helper reads and writes: of loops with more, LLVM gives up proving that they do not overlap, and
/// makes no vectors.
const MOST_ROWS: usize = 240;

/// Rows of numbers, one of each branch, that a call moves.
#[derive(Default)]
struct Rows {
    /// Rows that are stored number by number.
    gathered: BTreeSet<Vec<Expr>>,
    /// Rows that are there as such: results of calls, and numbers of the model.
    whole: BTreeSet<Vec<Expr>>,
    /// How many it computes for others.
    n_found: usize,
}

impl Rows {
    fn len(&self) -> usize {
        self.gathered.len() + self.whole.len() + self.n_found
    }
}

/// All calls.
pub(super) struct Calls {
    /// The groups of each, operands first.
    pub(super) groups: Vec<Vec<usize>>,
    /// For each group, its call.
    of: Vec<Option<usize>>,
    /// For each group, whether something beside its call needs it.
    pub(super) is_found: Vec<bool>,
}

impl Calls {
    /// Those that are worth it; the groups of others are taken apart.
    pub(super) fn of(graph: &ExprGraph, roots: &[Expr], groups: &mut Groups) -> Self {
        loop {
            let layers = Layers::of(graph, roots, groups).groups();
            let calls = Self::of_layers(graph, roots, groups, &layers);
            let unworthy = (0..calls.groups.len()).filter(|&call| !calls.is_worth_it(groups, call));
            let unworthy: Vec<usize> = unworthy
                .flat_map(|call| calls.groups[call].clone())
                .collect();
            if unworthy.is_empty() {
                return calls;
            }
            for group in unworthy {
                groups.dissolve(group);
            }
        }
    }

    /// A call for each layer, or as many as it takes for none to move too many rows.
    fn of_layers(
        graph: &ExprGraph,
        roots: &[Expr],
        groups: &Groups,
        layers: &[Vec<usize>],
    ) -> Self {
        let mut n_parts = vec![1; layers.len()];
        loop {
            let layers = layers.iter().zip(&n_parts).enumerate();
            let parts = layers.flat_map(|(layer, (own, n_parts))| {
                let parts = own.chunks(own.len().div_ceil(*n_parts));
                parts.map(move |part| (layer, part.to_vec()))
            });
            let (of, parts): (Vec<usize>, Vec<_>) = parts.unzip();
            let calls = Self::of_parts(graph, roots, groups, parts);
            let long = |call: &usize| calls.rows(groups, *call).len() > MOST_ROWS;
            let long: BTreeSet<usize> = (0..of.len()).filter(long).map(|call| of[call]).collect();
            if long.is_empty() {
                return calls;
            }
            for layer in long {
                n_parts[layer] += 1 + n_parts[layer] / 8;
            }
        }
    }

    /// A call for each part.
    fn of_parts(
        graph: &ExprGraph,
        roots: &[Expr],
        groups: &Groups,
        parts: Vec<Vec<usize>>,
    ) -> Self {
        let mut of = vec![None; groups.all.len()];
        for (call, own) in parts.iter().enumerate() {
            for &group in own {
                of[group] = Some(call);
            }
        }
        let mut is_found = vec![false; groups.all.len()];
        let call = |id: NodeId| groups.group(id).and_then(|group| of[group]);
        let mut find = |by: Option<usize>, id: NodeId| {
            if let Some(group) = groups
                .group(id)
                .filter(|&group| by.is_none() || of[group] != by)
            {
                is_found[group] = true;
            }
        };
        let needed = graph.reachable(roots);
        for id in graph.ids().filter(|id| needed[id.index()]) {
            graph
                .node(id)
                .operands()
                .for_each(|read| find(call(id), read));
        }
        let read = graph.called(|id| needed[id.index()]);
        roots
            .iter()
            .chain(&read)
            .for_each(|own| find(None, own.node()));
        Self {
            groups: parts,
            of,
            is_found,
        }
    }

    /// Whether calls are numbered far enough for all of them.
    pub(super) fn have_numbers(&self, graph: &ExprGraph) -> bool {
        usize::from(graph.next_lockstep()) + self.groups.len() < usize::from(u16::MAX)
    }

    /// What a call moves.
    fn rows(&self, groups: &Groups, call: usize) -> Rows {
        let own = &self.groups[call];
        let mut rows = Rows::default();
        for operand in own.iter().flat_map(|&group| &groups.all[group].operands) {
            let of_call = operand.group().and_then(|group| self.of[group]);
            if of_call == Some(call) {
                continue;
            }
            let row = groups.given(operand);
            if row.iter().all(|own| *own == row[0]) {
                continue;
            }
            if of_call.is_some() || groups.are_numbers(operand) {
                rows.whole.insert(row);
            } else {
                rows.gathered.insert(row);
            }
        }
        rows.n_found = own.iter().filter(|&&group| self.is_found[group]).count();
        rows
    }

    /// False where a call would move more numbers than it saves operations. A row that is gathered is written number by number and
    /// read, and one that is whole moves as a vector. What a call computes counts as read number by number, even if other
    /// calls alone read it: measured, such calls save no time.
    fn is_worth_it(&self, groups: &Groups, call: usize) -> bool {
        let own = &self.groups[call];
        let lanes = groups.lanes(own[0]);
        let Rows {
            gathered,
            whole,
            n_found,
        } = self.rows(groups, call);
        let n_moves = 2 * (lanes * gathered.len() + whole.len()) + lanes * n_found;
        (lanes - 1) * own.len() > n_moves
    }

    /// Whether a call computes a group.
    pub(super) fn has(&self, call: usize, group: usize) -> bool {
        self.of[group] == Some(call)
    }
}
