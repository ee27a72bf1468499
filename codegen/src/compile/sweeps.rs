//! The ways in which derivatives may be swept for: from inputs to outputs, or back.
//!
//! In: a tree, a function, a plan for its values. Out: the plan by each way that has a chance, one at least; the one of several
//! arrangements that costs least.

use std::{cell::LazyCell, collections::BTreeSet};

use crate::{
    functions::{Arrangement, Formulation, Request, Rows},
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::{
    pipeline::finished,
    planned::{MOST_NODES, Planned, cost_of, operations},
};

/// How many times as much as the other a sweep may build beyond [`MOST_NODES`]: what entries have in common never makes up for more.
const MOST_TIMES: usize = 8;

/// A way that needs more than this many times the cost of the cheapest before its sums are factored is passed over: factoring hardly ever
/// halves a long count.
const MOST_FACTORED: usize = 2;

/// A way of no more operations is never passed over: of few operations most may go.
const SHORT: usize = 200;

/// The plan by each way that has a chance to be the cheaper one, forward first.
pub(super) fn ways(
    tree: &Tree,
    request: &Request,
    formulation: Formulation,
    without: &BTreeSet<Technique>,
    plan: &Plan,
) -> Vec<Plan> {
    let ways = [false, true].map(|is_reverse| plan.with(Technique::Reverse, is_reverse));
    let [forward, reverse] = ways;
    if without.contains(&Technique::Reverse) {
        return vec![forward];
    }
    let Rows {
        forward: of_forward,
        reverse: of_reverse,
    } = request.swept_rows(tree);
    let n_nodes = LazyCell::new(|| request.values().derive(tree, formulation, plan).graph.len());
    let has_chance =
        |own: usize, other: usize| own <= MOST_TIMES * other || own * *n_nodes <= MOST_NODES;
    let mut plans = Vec::with_capacity(2);
    if has_chance(of_forward, of_reverse) {
        plans.push(forward);
    }
    if has_chance(of_reverse, of_forward) {
        plans.push(reverse);
    }
    plans
}

/// The first of these that costs least, and what it derives; `None` where each costs more than `most`.
pub(super) fn fewest(
    tree: &Tree,
    request: &Request,
    arrangements: Vec<Arrangement>,
    most: usize,
) -> Option<Planned> {
    let mut least = most;
    let mut best = None;
    // The last is the most promising.
    for arrangement in arrangements.into_iter().rev() {
        let derived = request.derive_arranged(tree, &arrangement);
        // Sines that are to be given are computed here yet: each counts as one operation, not as it costs.
        if operations(&derived).total() > SHORT.max(least.saturating_mul(MOST_FACTORED)) {
            continue;
        }
        let derived = finished(tree, request, &arrangement, derived);
        let cost = cost_of(request, &derived);
        if cost <= least {
            least = cost;
            best = Some(Planned {
                arrangement,
                derived,
            });
        }
    }
    best
}
