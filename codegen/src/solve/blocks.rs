//! Entries of an inverse that follow from others alike: those of a branch in columns beyond its foot, four columns at a time.
//!
//! Where all up to a body was eliminated from the rows of a branch on it, one rule makes of each column what that branch has in it:
//! a product of matrices, written once as a helper.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::entries::{Entries, Rule};
use crate::{
    expr::{Call, Expr, ExprGraph, Helper, Input, LANES, Purpose, Shared},
    id::BodyId,
};

/// What a helper is given of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum GivenNumber {
    /// The entry of a speed, by its place among the speeds.
    Entry(usize),
    /// A part of the acceleration of a carrier.
    Acceleration(BodyId, usize),
}

/// A helper while it is written.
struct Block {
    helper: ExprGraph,
    shared: Shared,
    given: Vec<GivenNumber>,
    roots: Vec<Expr>,
}

/// Finds what the first of these rows, and those that follow it on its branch, have in these columns, where it takes calls. Fewer
/// than so many columns that are left are written out.
pub(super) fn find(
    graph: &mut ExprGraph,
    entries: &mut Entries<'_>,
    (rows, columns): (&[usize], &[usize]),
    fewest: usize,
) {
    let mut by_foot: BTreeMap<BodyId, Vec<usize>> = BTreeMap::new();
    for &j in columns {
        if let Some(foot) = entries.rule(graph, rows[0], j).foot {
            by_foot.entry(foot).or_default().push(j);
        }
    }
    for (foot, mut columns) in by_foot {
        let n_left = columns.len() % LANES;
        if n_left < fewest {
            columns.truncate(columns.len() - n_left);
        }
        if columns.is_empty() {
            continue;
        }
        let branch = branch(entries, foot, rows[0]);
        let mut rows = rows.to_vec();
        rows.retain(|i| branch.contains(&entries.order[*i].body));
        rows.retain(|&i| {
            let mut columns = columns.iter();
            columns.all(|&j| entries.rule(graph, i, j).foot == Some(foot))
        });
        let rule = |&i: &usize| (i, entries.rule(graph, i, columns[0]));
        let rules: Vec<(usize, Rule)> = rows.iter().map(rule).collect();
        let block = Block::of(graph, entries, &rules);
        if block.is_worth_it() {
            block.call(graph, entries, &rows, &columns);
        }
    }
}

/// The bodies of the branch on a body that a speed moves on.
fn branch(entries: &Entries<'_>, foot: BodyId, i: usize) -> BTreeSet<BodyId> {
    let tree = entries.tree;
    let mut first = entries.order[i].body;
    while let Some(lower) = tree.lower(first).filter(|lower| *lower != foot) {
        first = lower;
    }
    let mut branch = BTreeSet::from([first]);
    for body in tree.body_ids() {
        let lower = tree.lower(body);
        if lower.is_some_and(|lower| branch.contains(&lower)) {
            branch.insert(body);
        }
    }
    branch
}

impl Block {
    fn of(graph: &ExprGraph, entries: &Entries<'_>, rules: &[(usize, Rule)]) -> Self {
        let mut block = Self {
            helper: ExprGraph::default(),
            shared: Shared::default(),
            given: Vec::new(),
            roots: Vec::new(),
        };
        block.helper.begin(Purpose::Inverse);
        for (i, rule) in rules {
            let own = entries.order[*i];
            block.helper.enter(own.body);
            let root = block.entry(graph, rule);
            block.helper.name(root, format!("h_{}", own.coordinate));
            block.roots.push(root);
        }
        block
    }

    fn entry(&mut self, graph: &ExprGraph, rule: &Rule) -> Expr {
        let mut sum = self.helper.zero();
        for &(a, factor) in &rule.direct {
            let factor = self.shared.share(graph, &mut self.helper, factor);
            let entry = self.given(GivenNumber::Entry(a.index()));
            let term = self.helper.mul(factor, entry);
            sum = self.helper.add(sum, term);
        }
        if let Some((carrier, feeling)) = &rule.felt {
            let acceleration = [0, 1, 2, 3, 4, 5];
            let acceleration =
                acceleration.map(|part| self.given(GivenNumber::Acceleration(*carrier, part)));
            let (shared, helper) = (&mut self.shared, &mut self.helper);
            let feeling = feeling.map(|own| shared.share(graph, helper, own));
            let share = feeling.of(&mut self.helper, &acceleration);
            sum = self.helper.add(sum, share);
        }
        sum
    }

    fn given(&mut self, own: GivenNumber) -> Expr {
        let known = self.given.iter().position(|known| *known == own);
        let place = known.unwrap_or_else(|| {
            self.given.push(own);
            self.given.len() - 1
        });
        self.helper.input(Input::Side(place))
    }

    /// False where calls would move more numbers than they save operations: what they are given is written and read.
    fn is_worth_it(&self) -> bool {
        let n_moved = 2 * self.given.len() + self.roots.len();
        (LANES - 1) * self.helper.n_operations(&self.roots) > LANES * n_moved
    }

    fn call(
        self,
        graph: &mut ExprGraph,
        entries: &mut Entries<'_>,
        rows: &[usize],
        columns: &[usize],
    ) {
        let calls = columns.chunks(LANES).map(|columns| {
            let row = |own: &GivenNumber| {
                let column = |&j: &usize| entries.given(graph, *own, j);
                let mut row: Vec<Expr> = columns.iter().map(column).collect();
                row.resize(LANES, graph.zero());
                row
            };
            (columns, self.given.iter().map(row).collect())
        });
        let calls: Vec<(&[usize], Vec<Vec<Expr>>)> = calls.collect();
        let helper = Helper {
            lanes: LANES,
            graph: self.helper,
            roots: self.roots,
        };
        let lockstep = graph.next_lockstep();
        let shared = self.shared.numbers();
        graph.add_lockstep(lockstep, shared, vec![Arc::new(helper)]);
        for (columns, sides) in calls {
            let call = graph.add_call(lockstep, Call { helper: 0, sides });
            for (lane, &j) in columns.iter().enumerate() {
                for (place, &i) in rows.iter().enumerate() {
                    graph.enter(entries.order[i].body);
                    let entry = graph.call_result(call, lane, place);
                    entries.set(graph, [i, j], entry);
                }
            }
        }
    }
}

impl Entries<'_> {
    fn given(&mut self, graph: &mut ExprGraph, own: GivenNumber, j: usize) -> Expr {
        let column = self.order[j].index();
        match own {
            GivenNumber::Entry(speed) => self.h[speed][column],
            GivenNumber::Acceleration(carrier, part) => self.acceleration(graph, carrier, j)[part],
        }
    }
}
