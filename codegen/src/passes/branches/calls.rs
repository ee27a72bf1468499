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
    /// Those of layers that are worth a call; the groups of others are taken apart.
    pub(super) fn of(graph: &ExprGraph, roots: &[Expr], groups: &mut Groups) -> Self {
        let layers = loop {
            let layers = Layers::of(graph, roots, groups);
            let calls = Self::by(graph, roots, groups, layers.groups(groups));
            let unworthy = (0..calls.groups.len()).filter(|&call| !calls.is_worth_it(groups, call));
            let unworthy: Vec<usize> = unworthy
                .flat_map(|call| calls.groups[call].clone())
                .collect();
            if unworthy.is_empty() {
                break calls.groups;
            }
            for group in unworthy {
                groups.part(group);
            }
        };
        let mut n_parts = vec![1; layers.len()];
        loop {
            let layers = layers.iter().zip(&n_parts).enumerate();
            let parts = layers.flat_map(|(layer, (own, n_parts))| {
                let parts = own.chunks(own.len().div_ceil(*n_parts));
                parts.map(move |part| (layer, part.to_vec()))
            });
            let (of, parts): (Vec<usize>, Vec<_>) = parts.unzip();
            let calls = Self::by(graph, roots, groups, parts);
            let long = (0..of.len()).filter(|&call| {
                let Rows {
                    gathered,
                    whole,
                    n_found,
                } = calls.rows(groups, call);
                gathered.len() + whole.len() + n_found > MOST_ROWS
            });
            let long: BTreeSet<usize> = long.map(|call| of[call]).collect();
            if long.is_empty() {
                return calls;
            }
            for layer in long {
                n_parts[layer] += 1;
            }
        }
    }

    fn by(graph: &ExprGraph, roots: &[Expr], groups: &Groups, calls: Vec<Vec<usize>>) -> Self {
        let mut of = vec![None; groups.all.len()];
        for (call, own) in calls.iter().enumerate() {
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
            groups: calls,
            of,
            is_found,
        }
    }

    /// What a call moves.
    fn rows(&self, groups: &Groups, call: usize) -> Rows {
        let own = &self.groups[call];
        let mut rows = Rows::default();
        for operand in own.iter().flat_map(|&group| &groups.all[group].operands) {
            let of_call = operand.group().and_then(|group| self.of[group]);
            let row = groups.given(operand);
            if of_call == Some(call) || row.iter().all(|own| *own == row[0]) {
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
    /// read, one that stands in a row already moves as a vector, and what it computes is read number by number.
    fn is_worth_it(&self, groups: &Groups, call: usize) -> bool {
        let lanes = groups.lanes;
        let Rows {
            gathered,
            whole,
            n_found,
        } = self.rows(groups, call);
        let n_moves = 2 * (lanes * gathered.len() + whole.len()) + lanes * n_found;
        (lanes - 1) * self.groups[call].len() > n_moves
    }

    /// Whether a call computes a group.
    pub(super) fn has(&self, call: usize, group: usize) -> bool {
        self.of[group] == Some(call)
    }
}
