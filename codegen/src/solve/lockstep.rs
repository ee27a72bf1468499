//! Solutions for many right-hand sides, four at a time: what a column goes through is written once for all that are zero on the same
//! branches, and run on four of them side by side.
//!
//! As many operations as if each were written out, but for columns that join others and lanes that stay empty. The text is a fraction
//! of that, so that it stays in a processor's first cache, and a compiler makes vectors of it.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::{Carriers, Factors, inverse, reduced::Reduced};
use crate::{
    expr::{Call, Expr, ExprGraph, Helper, Input, LANES, NodeId, Purpose},
    tree::Tree,
};

/// So many columns are left that a call of their own would mostly be empty.
const FEW: usize = LANES / 2;

/// The columns of a call, and the places in the order of elimination at which one of their halves is not zero.
struct Group {
    columns: Vec<usize>,
    halves: BTreeSet<usize>,
}

impl Factors {
    /// The accelerations `x` with `A x = b` for each of several `b`, as [`Self::solutions`] has them.
    pub fn solutions_in_lockstep(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        columns: &[Vec<Expr>],
    ) -> Vec<Vec<Expr>> {
        graph.begin(Purpose::Solution);
        let (groups, few) = self.groups(graph, tree, columns);
        let zero = graph.zero();
        let mut solved = vec![vec![zero; self.order.len()]; columns.len()];
        let rest: Vec<Vec<Expr>> = few.iter().map(|&own| columns[own].clone()).collect();
        for (place, column) in few.into_iter().zip(self.solutions(graph, tree, &rest)) {
            solved[place] = column;
        }
        let carriers = Carriers::default();
        let mut writer = Writer {
            factors: self,
            tree,
            reduced: Reduced::new(self, &carriers),
            shared: Vec::new(),
            places: BTreeMap::new(),
        };
        let mut solvers: Vec<Solver> = Vec::new();
        let mut calls = Vec::with_capacity(groups.len());
        for group in groups {
            let is_given = |speed: &usize| {
                let mut own = group.columns.iter();
                own.any(|&own| !graph.is_zero(columns[own][*speed]))
            };
            let given: Vec<usize> = (0..self.order.len()).filter(is_given).collect();
            let mut known = solvers.iter();
            let known = known.position(|own| own.given == given && own.halves == group.halves);
            let solver = known.unwrap_or_else(|| {
                solvers.push(writer.solver(graph, given, group.halves));
                solvers.len() - 1
            });
            calls.push((group.columns, solver));
        }
        if calls.is_empty() {
            return solved;
        }
        let helpers = solvers.iter().map(|own| own.helper.clone()).collect();
        let lockstep = graph.next_lockstep();
        graph.add_lockstep(lockstep, writer.shared, helpers);
        for (own, helper) in calls {
            let Solver { given, found, .. } = &solvers[helper];
            let side = |speed: &usize| {
                let entry = |lane| {
                    own.get(lane)
                        .map_or(zero, |&own: &usize| columns[own][*speed])
                };
                (0..LANES).map(entry).collect()
            };
            let sides = given.iter().map(side).collect();
            let lanes = graph.call(lockstep, Call { helper, sides });
            for (&column, lane) in own.iter().zip(lanes) {
                for (&speed, entry) in found.iter().zip(lane) {
                    solved[column][speed] = entry;
                }
            }
        }
        solved
    }

    /// The columns that are not zero in groups, and the few that are left.
    fn groups(
        &self,
        graph: &ExprGraph,
        tree: &Tree,
        columns: &[Vec<Expr>],
    ) -> (Vec<Group>, Vec<usize>) {
        let mut found: Vec<(BTreeSet<usize>, usize)> = columns
            .iter()
            .enumerate()
            .map(|(place, column)| (self.halves(graph, tree, column), place))
            .filter(|(halves, _)| !halves.is_empty())
            .collect();
        // Those with many halves first: what is left of them joins others for the least.
        found.sort_by(|(one, own), (other, place)| {
            (other.len(), one, own).cmp(&(one.len(), other, place))
        });
        let n_whole = found.len() - found.len() % LANES;
        let n_grouped = if found.len() - n_whole > FEW {
            found.len()
        } else {
            n_whole
        };
        let few = found.split_off(n_grouped);
        let groups = found.chunks(LANES).map(|own| Group {
            columns: own.iter().map(|(_, place)| *place).collect(),
            halves: own.iter().flat_map(|(halves, _)| halves).copied().collect(),
        });
        let few = few.into_iter().map(|(_, place)| place).collect();
        (groups.collect(), few)
    }

    /// Where the half of a solution may be other than zero, in the order of elimination: at what is given, at all farther in, and at
    /// what follows on the same branch, so that columns of one branch are alike.
    fn halves(&self, graph: &ExprGraph, tree: &Tree, column: &[Expr]) -> BTreeSet<usize> {
        let mut is_half: Vec<bool> = column.iter().map(|own| !graph.is_zero(*own)).collect();
        for (k, row) in self.order.iter().zip(&self.couplings) {
            if is_half[k.index()] {
                for (other, _) in row {
                    is_half[other.index()] = true;
                }
            }
        }
        for body in tree.body_ids() {
            let lower = tree.lower(body);
            let is_alone = lower.is_some_and(|lower| tree.uppers(lower).len() == 1);
            let speeds = |body| tree.body(body).joint.speeds().into_iter();
            let mut below = lower.into_iter().flat_map(speeds);
            if is_alone && below.any(|(_, speed)| is_half[speed.index()]) {
                for (_, speed) in speeds(body) {
                    is_half[speed.index()] = true;
                }
            }
        }
        let order = self.order.iter().enumerate();
        let halves = order.filter(|(_, k)| is_half[k.index()]);
        halves.map(|(place, _)| place).collect()
    }
}

/// A helper, the speeds of which it is given entries, the places of their halves, and the speeds of which it computes entries.
struct Solver {
    helper: Arc<Helper<ExprGraph>>,
    given: Vec<usize>,
    halves: BTreeSet<usize>,
    found: Vec<usize>,
}

/// Writes helpers, and gathers what they share.
struct Writer<'a> {
    factors: &'a Factors,
    tree: &'a Tree,
    reduced: Reduced<'a>,
    shared: Vec<Expr>,
    places: BTreeMap<NodeId, usize>,
}

impl Writer<'_> {
    /// A number that all columns share, in a helper; what is known is written into it.
    fn share(&mut self, graph: &ExprGraph, helper: &mut ExprGraph, own: Expr) -> Expr {
        if let Some(number) = graph.as_number(own) {
            return helper.number(number);
        }
        let place = *self.places.entry(own.node()).or_insert_with(|| {
            self.shared.push(own.abs_sign());
            self.shared.len() - 1
        });
        helper.input(Input::Shared(place)).signed(own.is_negative())
    }

    /// What columns go through that are given at these speeds, and whose halves are at these places.
    fn solver(
        &mut self,
        graph: &mut ExprGraph,
        given: Vec<usize>,
        halves: BTreeSet<usize>,
    ) -> Solver {
        let mut helper = ExprGraph::default();
        helper.begin(Purpose::Solution);
        let mut b = vec![helper.zero(); self.factors.order.len()];
        for own in self.factors.order.iter().rev() {
            if let Ok(place) = given.binary_search(&own.index()) {
                helper.enter(own.body);
                b[own.index()] = helper.input(Input::Side(place));
            }
        }
        self.eliminate(graph, &mut helper, &mut b);
        self.substitute(graph, &mut helper, &mut b, &halves);
        let found = (0..b.len()).filter(|&speed| !helper.is_zero(b[speed]));
        let found: Vec<usize> = found.collect();
        let helper = Helper {
            lanes: LANES,
            roots: found.iter().map(|&speed| b[speed]).collect(),
            graph: helper,
        };
        Solver {
            helper: Arc::new(helper),
            given,
            halves,
            found,
        }
    }

    /// `L^-T b`.
    fn eliminate(&mut self, graph: &ExprGraph, helper: &mut ExprGraph, b: &mut [Expr]) {
        let factors = self.factors;
        for (&k, row) in factors.order.iter().zip(&factors.couplings) {
            if helper.is_zero(b[k.index()]) {
                continue;
            }
            for &(speed, factor) in row {
                helper.enter(speed.body);
                let factor = self.share(graph, helper, factor);
                let term = helper.mul(factor, b[k.index()]);
                b[speed.index()] = helper.sub(b[speed.index()], term);
            }
        }
    }

    /// `L^-1 D^-1` of that.
    fn substitute(
        &mut self,
        graph: &mut ExprGraph,
        helper: &mut ExprGraph,
        b: &mut [Expr],
        halves: &BTreeSet<usize>,
    ) {
        let factors = self.factors;
        for (place, &k) in factors.order.iter().enumerate().rev() {
            let (row, _) = self.reduced.row(graph, self.tree, place, halves);
            graph.enter(k.body);
            helper.enter(k.body);
            let mut sum = helper.zero();
            if !helper.is_zero(b[k.index()]) {
                let inverse = inverse(graph, k, factors.pivots[k.index()]);
                let inverse = self.share(graph, helper, inverse);
                sum = helper.mul(b[k.index()], inverse);
            }
            for &(other, factor) in &row {
                let x = b[factors.order[other].index()];
                if !helper.is_zero(x) {
                    let factor = self.share(graph, helper, factor);
                    let term = helper.mul(factor, x);
                    sum = helper.add(sum, term);
                }
            }
            helper.name(sum, format!("{}_ddot", k.coordinate));
            b[k.index()] = sum;
        }
    }
}
