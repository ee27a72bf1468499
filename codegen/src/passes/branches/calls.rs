//! Which groups a call computes: those of a layer.

use std::collections::BTreeSet;

use super::{groups::Groups, layers::Layers};
use crate::expr::{Expr, ExprGraph, NodeId};

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
    /// Those that are worth it; the groups of others are taken apart.
    pub(super) fn of(graph: &ExprGraph, roots: &[Expr], groups: &mut Groups) -> Self {
        loop {
            let layers = Layers::of(graph, roots, groups).groups();
            let calls = Self::of_layers(graph, roots, groups, layers);
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

    /// A call for each layer.
    fn of_layers(
        graph: &ExprGraph,
        roots: &[Expr],
        groups: &Groups,
        layers: Vec<Vec<usize>>,
    ) -> Self {
        let mut of = vec![None; groups.all.len()];
        for (call, own) in layers.iter().enumerate() {
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
            groups: layers,
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

    /// False where a call would compute more numbers than can be told apart, or move more numbers than it saves operations. A row that is gathered is written number by number and
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
        if n_found > usize::from(u16::MAX) {
            // Results have no places for so many.
            return false;
        }
        let n_moves = 2 * (lanes * gathered.len() + whole.len()) + lanes * n_found;
        (lanes - 1) * own.len() > n_moves
    }

    /// Whether a call computes a group.
    pub(super) fn has(&self, call: usize, group: usize) -> bool {
        self.of[group] == Some(call)
    }
}
