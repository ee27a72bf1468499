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
    expr::{Call, Expr, ExprGraph, Helper, Input, LANES, Purpose, Shared},
    id::{BodyId, SpeedId},
    tree::Tree,
};

/// So many columns are left that a call of their own would mostly be empty.
const FEW: usize = LANES / 2;

/// The columns of a call, and the places in the order of elimination at which one of their halves is not zero.
struct Group {
    columns: Vec<usize>,
    halves: BTreeSet<usize>,
}

/// A helper, the speeds of which it is given entries, the places of their halves, and the speeds of which it computes entries.
#[derive(Debug)]
struct Solver {
    helper: Arc<Helper<ExprGraph>>,
    given: Vec<usize>,
    halves: BTreeSet<usize>,
    found: Vec<usize>,
}

/// Solves for columns as they become known.
#[derive(Debug)]
pub struct LockstepSolver<'a> {
    writer: Writer<'a>,
    solvers: Vec<Solver>,
    /// The last lockstep that was added to the graph.
    lockstep: Option<u16>,
}

impl<'a> LockstepSolver<'a> {
    /// One for `L^T D L`.
    pub fn new(factors: &'a Factors, tree: &'a Tree, carriers: &'a Carriers) -> Self {
        let writer = Writer {
            factors,
            tree,
            reduced: Reduced::new(factors, carriers),
            shared: Shared::default(),
        };
        Self {
            writer,
            solvers: Vec::new(),
            lockstep: None,
        }
    }

    /// Which columns go beside one that is zero on no branch, such as that of the accelerations: they fill one call, or several where
    /// as many are like the widest.
    pub fn beside(&self, graph: &ExprGraph, columns: &[Vec<Expr>]) -> Vec<usize> {
        let found = self.by_halves(graph, columns);
        let widest = found.first().map(|(halves, _)| halves);
        let n_alike = found.iter().filter(|(halves, _)| Some(halves) == widest);
        let n_calls = (n_alike.count() + 1) / LANES;
        let n_beside = n_calls.max(1) * LANES - 1;
        let beside = found.iter().take(n_beside);
        beside.map(|(_, place)| *place).collect()
    }

    /// Gets ready for columns that are not known yet, but zero in the same places as these. The speeds, from the leaves inward, whose
    /// columns of the inverse take lanes that would stay empty.
    pub fn foresee(&mut self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<SpeedId> {
        graph.begin(Purpose::Solution);
        let filling = self.filling(graph, columns);
        let mut columns = columns.to_vec();
        columns.extend(filling.iter().map(|own| self.unit(graph, *own)));
        let (groups, _) = self.groups(graph, &columns);
        for group in groups {
            self.solver(graph, &group, &columns);
        }
        filling
    }

    /// A unit force along a speed: what a column of the inverse solves.
    pub fn unit(&self, graph: &mut ExprGraph, speed: SpeedId) -> Vec<Expr> {
        let mut column = vec![graph.zero(); self.writer.factors.n_speeds()];
        column[speed.index()] = graph.one();
        column
    }

    /// The accelerations `x` with `A x = b` for each of several `b`, as [`Factors::solutions`] has them.
    pub fn solve(&mut self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
        graph.begin(Purpose::Solution);
        let (groups, few) = self.groups(graph, columns);
        let Writer { factors, tree, .. } = self.writer;
        let zero = graph.zero();
        let mut solved = vec![vec![zero; factors.n_speeds()]; columns.len()];
        let rest: Vec<Vec<Expr>> = few.iter().map(|&own| columns[own].clone()).collect();
        for (place, column) in few.into_iter().zip(factors.solutions(graph, tree, &rest)) {
            solved[place] = column;
        }
        let mut calls = Vec::with_capacity(groups.len());
        for group in groups {
            let solver = self.solver(graph, &group, columns);
            calls.push((group.columns, solver));
        }
        if calls.is_empty() {
            return solved;
        }
        let lockstep = self.lockstep(graph);
        let order = factors.order.iter();
        let bodies: BTreeMap<usize, BodyId> = order.map(|own| (own.index(), own.body)).collect();
        for (own, helper) in calls {
            let Solver { given, found, .. } = &self.solvers[helper];
            let side = |speed: &usize| {
                let entry = |lane| {
                    own.get(lane)
                        .map_or(zero, |&own: &usize| columns[own][*speed])
                };
                (0..LANES).map(entry).collect()
            };
            let sides = given.iter().map(side).collect();
            let call = graph.add_call(lockstep, Call { helper, sides });
            for (lane, &column) in own.iter().enumerate() {
                for (place, &speed) in found.iter().enumerate() {
                    graph.enter(bodies[&speed]);
                    solved[column][speed] = graph.call_result(call, lane, place);
                }
            }
        }
        solved
    }

    /// The lockstep that has all helpers: a new one where some were written, or share more, since the last.
    fn lockstep(&mut self, graph: &mut ExprGraph) -> u16 {
        let Self {
            writer, solvers, ..
        } = self;
        let has_all = |own: &u16| {
            let of = graph.lockstep(*own);
            of.helpers.len() == solvers.len() && of.shared.len() == writer.shared.n_numbers()
        };
        if let Some(known) = self.lockstep.filter(has_all) {
            return known;
        }
        let lockstep = graph.next_lockstep();
        let helpers = solvers.iter().map(|own| own.helper.clone()).collect();
        graph.add_lockstep(lockstep, writer.shared.numbers(), helpers);
        self.lockstep = Some(lockstep);
        lockstep
    }

    /// The solver of a group, which is written where none is like it.
    fn solver(&mut self, graph: &mut ExprGraph, group: &Group, columns: &[Vec<Expr>]) -> usize {
        let is_given = |speed: &usize| {
            let mut own = group.columns.iter();
            own.any(|&own| !graph.is_zero(columns[own][*speed]))
        };
        let given: Vec<usize> = (0..self.writer.factors.n_speeds())
            .filter(is_given)
            .collect();
        let mut known = self.solvers.iter();
        let known = known.position(|own| own.given == given && own.halves == group.halves);
        known.unwrap_or_else(|| {
            let solver = self.writer.solver(graph, given, group.halves.clone());
            self.solvers.push(solver);
            self.solvers.len() - 1
        })
    }

    /// The columns that are not zero in groups, and the few that are left.
    fn groups(&self, graph: &ExprGraph, columns: &[Vec<Expr>]) -> (Vec<Group>, Vec<usize>) {
        let mut found = self.by_halves(graph, columns);
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

    /// The columns that are not zero, with their halves. Those with many come first: what is left of them joins others for the least.
    fn by_halves(&self, graph: &ExprGraph, columns: &[Vec<Expr>]) -> Vec<(BTreeSet<usize>, usize)> {
        let mut found: Vec<(BTreeSet<usize>, usize)> = columns
            .iter()
            .enumerate()
            .map(|(place, column)| (self.halves(graph, column), place))
            .filter(|(halves, _)| !halves.is_empty())
            .collect();
        found.sort_by(|(one, own), (other, place)| {
            (other.len(), one, own).cmp(&(one.len(), other, place))
        });
        found
    }

    /// The speeds whose columns of the inverse fill the last call of these columns: as many as it has empty lanes, or none. They are
    /// zero on the branches on which its columns are, and whatever is eliminated into one of them is among them too.
    fn filling(&self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<SpeedId> {
        let found = self.by_halves(graph, columns);
        let n_empty = (LANES - found.len() % LANES) % LANES;
        let last = found.chunks(LANES).last().into_iter().flatten();
        let last: BTreeSet<usize> = last.flat_map(|(halves, _)| halves).copied().collect();
        let factors = self.writer.factors;
        let mut filling: Vec<SpeedId> = Vec::new();
        let mut inner: BTreeSet<SpeedId> = BTreeSet::new();
        for (own, row) in factors.order.iter().zip(&factors.couplings) {
            let unit = self.unit(graph, own.speed);
            let may = filling.len() < n_empty && !inner.contains(&own.speed);
            if may && self.halves(graph, &unit).is_subset(&last) {
                filling.push(own.speed);
            } else {
                inner.extend(row.iter().map(|(other, _)| other.speed));
            }
        }
        if filling.len() < n_empty {
            filling.clear();
        }
        filling
    }

    /// Where the half of a solution may be other than zero, in the order of elimination: at what is given, at all farther in, and at
    /// what follows on the same branch, so that columns of one branch are alike.
    fn halves(&self, graph: &ExprGraph, column: &[Expr]) -> BTreeSet<usize> {
        let Writer { factors, tree, .. } = self.writer;
        let mut is_half: Vec<bool> = column.iter().map(|own| !graph.is_zero(*own)).collect();
        for (k, row) in factors.order.iter().zip(&factors.couplings) {
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
        let order = factors.order.iter().enumerate();
        let halves = order.filter(|(_, k)| is_half[k.index()]);
        halves.map(|(place, _)| place).collect()
    }
}

/// Writes helpers, and gathers what they share.
#[derive(Debug)]
struct Writer<'a> {
    factors: &'a Factors,
    tree: &'a Tree,
    reduced: Reduced<'a>,
    shared: Shared,
}

impl Writer<'_> {
    /// What columns go through that are given at these speeds, and whose halves are at these places.
    fn solver(
        &mut self,
        graph: &mut ExprGraph,
        given: Vec<usize>,
        halves: BTreeSet<usize>,
    ) -> Solver {
        let mut helper = ExprGraph::default();
        helper.begin(Purpose::Solution);
        let mut b = vec![helper.zero(); self.factors.n_speeds()];
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
                let factor = self.shared.share(graph, helper, factor);
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
                let inverse = self.shared.share(graph, helper, inverse);
                sum = helper.mul(b[k.index()], inverse);
            }
            for &(other, factor) in &row {
                let x = b[factors.order[other].index()];
                if !helper.is_zero(x) {
                    let factor = self.shared.share(graph, helper, factor);
                    let term = helper.mul(factor, x);
                    sum = helper.add(sum, term);
                }
            }
            helper.name(sum, format!("{}_ddot", k.coordinate));
            b[k.index()] = sum;
        }
    }
}
