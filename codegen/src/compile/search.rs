//! The cheapest plan of the recursion for a function that differentiates nothing, by count.
//!
//! In: a tree, a function, the techniques that may not be used. Out: a [`Plan`]. Afterwards: of a function of up to `MOST_EXACT`
//! nodes each technique that can matter was tried, used and left out, until none lowered the cost, and axes were merged once
//! more; of larger ones each was tried once, before factoring. Choices link by link are tried until `MOST_NODES` were built, or
//! `MOST_ASKED` sums and products were asked for.
//! The same choices are tried in the same order on every machine.

use std::collections::{BTreeMap, BTreeSet};

use crate::{
    functions::Request,
    id::BodyId,
    recursive::{self, Plan, Regroup, Technique},
    tree::Tree,
};

use super::{
    pipeline::{finished, with_sines},
    planned::{MOST_NODES, Planned, cost_of},
};

/// Beyond this many nodes factoring is left out of the count that plans are compared by: it changes a thousandth.
const MOST_EXACT: usize = 4_000;

/// How many sums and products may be asked for to compare choices link by link: a second's work. Where most of them fold, as of
/// bodies that turn about one line, they build few nodes.
const MOST_ASKED: usize = 10_000_000;

/// Up to this many nodes the search starts several times: what is sparse and small has more than one local optimum.
const MOST_STARTS: usize = 1_500;

/// The cheapest plan that was found for the function, without the techniques in `without`.
pub(super) fn plan(tree: &Tree, request: &Request, without: &BTreeSet<Technique>) -> Plan {
    let best = of_starts(tree, request, without);
    let rates = Technique::Rates;
    if !request.heeds(rates) || without.contains(&rates) {
        return best;
    }
    // Little of what suits one way to rates suits the other.
    let mut without = without.clone();
    without.insert(rates);
    let other = of_starts(tree, request, &without);
    let [cost, of_other] = [&best, &other].map(|plan| {
        let planned = Planned::new(tree, request, request.arranged_by(tree, plan));
        cost_of(request, &planned.derived)
    });
    if of_other < cost { other } else { best }
}

/// The cheapest of those that were found from each start.
fn of_starts(tree: &Tree, request: &Request, without: &BTreeSet<Technique>) -> Plan {
    let mut counts = Counts::new();
    let mut best: Option<Found> = None;
    for left_out in starts(request, without) {
        let found = from(tree, request, without, &left_out, &mut counts);
        let is_small = found.n_first <= MOST_STARTS;
        if best.as_ref().is_none_or(|best| found.least < best.least) {
            best = Some(found);
        }
        if !is_small {
            break;
        }
    }
    best.expect("search: one start is made").plan
}

/// What is left out where the search starts. How inertias are best regrouped depends most on two techniques; what else is best for
/// a frame depends on how it passes.
fn starts(request: &Request, without: &BTreeSet<Technique>) -> Vec<Vec<Technique>> {
    use Technique::{Balance, Inward, Levers, Regroup, Slide};
    let of_links: &[&[Technique]] = if request.heeds(Regroup) {
        &[&[], &[Balance], &[Slide], &[Balance, Slide]]
    } else {
        &[&[], &[Slide]]
    };
    let of_frames: &[&[Technique]] = if request.heeds(Inward) {
        &[&[], &[Inward], &[Inward, Levers]]
    } else {
        &[&[]]
    };
    let mut starts: Vec<Vec<Technique>> = Vec::new();
    for own in of_frames {
        for start in of_links.iter().map(|links| [*links, *own].concat()) {
            let start = start.into_iter().filter(|one| !without.contains(one));
            let start: Vec<Technique> = start.collect();
            if !starts.contains(&start) {
                starts.push(start);
            }
        }
    }
    starts
}

/// What a search found.
struct Found {
    plan: Plan,
    /// Its count.
    least: usize,
    /// How many nodes were built for the first plan.
    n_first: usize,
}

/// What was counted, by plan and by whether it was [exact](Search::is_exact): searches come to the same plans again.
type Counts = BTreeMap<(bool, Plan), Count>;

/// What a plan costs.
#[derive(Clone, Copy)]
struct Count {
    cost: usize,
    /// How many nodes were built to count it.
    n_nodes: usize,
    /// How many sums and products were asked for.
    n_asked: usize,
}

/// The search that starts with all techniques but those of `left_out`.
fn from(
    tree: &Tree,
    request: &Request,
    without: &BTreeSet<Technique>,
    left_out: &[Technique],
    counts: &mut Counts,
) -> Found {
    let mut plan = Plan::full(tree).with_parallel(None, false);
    plan.set(Technique::Lockstep, false);
    for &technique in without.iter().chain(left_out) {
        plan.set(technique, false);
    }
    let mut search = Search {
        tree,
        request,
        counts,
        least: usize::MAX,
        plan: plan.clone(),
        n_nodes: 0,
        n_asked: 0,
        n_first: 0,
        is_exact: true,
    };
    search.try_all(&plan);
    search.try_solving_by_columns();
    search.try_solving_by_factors();
    search.try_none(&plan, without);
    search.try_parallel_axes();
    search.try_regrouping();
    search.try_single_techniques(without);
    if search.is_exact {
        // What is merged may pay only without what was left out since.
        search.try_parallel_axes();
    }
    Found {
        plan: search.plan,
        least: search.least,
        n_first: search.n_first,
    }
}

struct Search<'a> {
    tree: &'a Tree,
    request: &'a Request,
    counts: &'a mut Counts,
    /// The count of `plan`.
    least: usize,
    plan: Plan,
    /// How many nodes were built, for all plans and for the first; a plan that is met twice counts twice.
    n_nodes: usize,
    n_first: usize,
    /// How many sums and products were asked for, likewise.
    n_asked: usize,
    /// True while plans are compared by what is left after factoring.
    is_exact: bool,
}

impl Search<'_> {
    /// Takes a plan if it is cheaper than the best.
    fn try_one(&mut self, plan: Plan) {
        if plan == self.plan && self.least != usize::MAX {
            return;
        }
        let was_exact = self.is_exact;
        let mut count = self.count(&plan);
        if was_exact && !self.is_exact {
            // Counts of two kinds do not compare: the best so far is counted anew.
            if self.least != usize::MAX {
                let best = self.plan.clone();
                self.least = self.count(&best);
            }
            count = self.count(&plan);
        }
        if count < self.least {
            (self.least, self.plan) = (count, plan);
        }
        if self.n_first == 0 {
            self.n_first = self.n_nodes;
        }
    }

    fn count(&mut self, plan: &Plan) -> usize {
        let key = (self.is_exact, plan.clone());
        let known = self.counts.get(&key).copied();
        let count = known.unwrap_or_else(|| {
            let count = self.counted(plan);
            self.counts.insert(key, count);
            count
        });
        self.n_nodes += count.n_nodes;
        self.n_asked += count.n_asked;
        self.is_exact &= count.n_nodes <= MOST_EXACT;
        count.cost
    }

    fn counted(&self, plan: &Plan) -> Count {
        let &Self { tree, request, .. } = self;
        let arrangement = request.arranged_by(tree, plan);
        let derived = request.derive_arranged(tree, &arrangement);
        let n_asked = derived.graph.n_asked();
        let (derived, n_nodes) = if self.is_exact {
            let derived = finished(tree, request, &arrangement, derived);
            let n_nodes = derived.graph.n_needed(&derived.roots);
            (derived, n_nodes)
        } else {
            let n_nodes = derived.graph.len();
            (with_sines(tree, request, derived), n_nodes)
        };
        Count {
            cost: cost_of(request, &derived),
            n_nodes,
            n_asked,
        }
    }

    /// True once choices link by link have taken long enough.
    fn is_long(&self) -> bool {
        self.n_nodes > MOST_NODES || self.n_asked > MOST_ASKED
    }

    /// The plan, with each way to regroup all links.
    fn try_all(&mut self, plan: &Plan) {
        let choices = if self.regroups(plan) {
            &Regroup::ALL[..]
        } else {
            &[Regroup::None]
        };
        for &choice in choices {
            // The two axes across the joint's are alike where nothing is zero, as in most of what is large.
            if choice != Regroup::Last || self.is_exact {
                self.try_one(plan.with_regroup(None, choice));
            }
        }
    }

    /// The inverse column by column from articulated bodies.
    fn try_solving_by_columns(&mut self) {
        let carriers = Technique::Carriers;
        if self.request.heeds(carriers) && self.plan.uses(carriers) {
            self.try_one(self.plan.with(carriers, false));
        }
    }

    /// `L^T D L` in place of articulated bodies, where that has a chance.
    fn try_solving_by_factors(&mut self) {
        if self.plan.uses(Technique::Articulated) && self.factors_have_a_chance() {
            self.try_all(&self.plan.with(Technique::Articulated, false));
        }
    }

    /// No technique at all but how frames pass: on a small tree each may cost something before the others save more.
    fn try_none(&mut self, start: &Plan, without: &BTreeSet<Technique>) {
        if self.is_exact {
            let factor = !without.contains(&Technique::Factor);
            let mut plain = Plan::plain(self.tree).with(Technique::Factor, factor);
            for way in [Technique::Inward, Technique::Levers] {
                plain.set(
                    way,
                    self.request.heeds(Technique::Inward) && start.uses(way),
                );
            }
            self.try_one(plain);
        }
    }

    /// All links with parallel axes merged, then single ones that are not, or are.
    fn try_parallel_axes(&mut self) {
        if !self.plan.uses(Technique::Parallel) {
            return;
        }
        self.try_one(self.plan.with_parallel(None, true));
        let matters = self.request.paths(self.tree);
        let bodies = recursive::parallel_axes(self.tree, &self.plan).into_iter();
        for body in bodies.filter(|body| matters[*body]) {
            if self.is_long() {
                return;
            }
            let merged = self.plan.parallel(body);
            self.try_one(self.plan.with_parallel(Some(body), !merged));
        }
    }

    /// Other choices for single links: where neither the link's numbers nor those of its lower link have zeros, there is
    /// nothing that regrouping could fill.
    fn try_regrouping(&mut self) {
        if !self.regroups(&self.plan) {
            return;
        }
        let sparse = recursive::sparse_inertias(self.tree);
        let bodies: Vec<BodyId> = self.tree.body_ids().rev().collect();
        for body in bodies {
            let lower = self.tree.lower(body);
            if !sparse[body] && lower.is_none_or(|lower| !sparse[lower]) {
                continue;
            }
            for choice in Regroup::ALL {
                if self.is_long() {
                    return;
                }
                self.try_one(self.plan.with_regroup(Some(body), choice));
            }
        }
    }

    /// One technique after the other, left out or used, until no change pays.
    fn try_single_techniques(&mut self, without: &BTreeSet<Technique>) {
        let mut before = usize::MAX;
        // What is large is gone through once.
        while self.least < before && (self.is_exact || before == usize::MAX) {
            before = self.least;
            for (_, technique) in Technique::ALL {
                if self.says_something(technique) && !without.contains(&technique) {
                    let used = self.plan.uses(technique);
                    self.try_one(self.plan.with(technique, !used));
                }
            }
        }
    }

    /// True where the count may depend on whether the technique is used.
    fn says_something(&self, technique: Technique) -> bool {
        match technique {
            Technique::Articulated => self.factors_have_a_chance(),
            // A search of its own finds what suits each way.
            Technique::Rates => false,
            _ => self.request.heeds(technique),
        }
    }

    /// True where the count depends on how a plan regroups inertias.
    fn regroups(&self, plan: &Plan) -> bool {
        self.request.heeds(Technique::Regroup) && plan.uses(Technique::Regroup)
    }

    /// Where something is solved for, and `L^T D L` would not alone need twice as much.
    fn factors_have_a_chance(&self) -> bool {
        self.request.solves() && self.request.factorising(self.tree) <= 2 * self.least
    }
}
