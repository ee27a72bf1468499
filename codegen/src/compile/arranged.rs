//! The cheapest arrangement of a joined function: which parts are derived by one plan, which in a way of their own, and which are
//! read off what others find.
//!
//! In: the function by one plan for all parts, and how each part alone is derived. Out: the cheapest [`Planned`]. Afterwards: it costs no
//! more than by one plan. What would take long is left as it is.

use std::collections::BTreeSet;

use super::planned::{MOST_NODES, Planned, cost_of};
use crate::{
    functions::{Arrangement, Request},
    tree::Tree,
};

/// The cheapest of the arrangements that are tried.
pub(super) fn cheapest(
    tree: &Tree,
    request: &Request,
    together: Planned,
    own: impl FnOnce() -> Arrangement,
) -> Planned {
    if together.derived.graph.len() > MOST_NODES {
        return together;
    }
    let mut search = Search {
        tree,
        request,
        least: cost_of(request, &together.derived),
        tried: BTreeSet::from([together.arrangement.clone()]),
        n_nodes: 0,
        best: together,
    };
    let together = search.best.arrangement.clone();
    let own = own();
    search.try_one(own.clone());
    for arrangement in [&together, &own] {
        search.try_one(search.apart(arrangement));
    }
    let mut before = None;
    while before != Some(search.least) {
        before = Some(search.least);
        for place in 0..request.parts().len() {
            search.try_part(place, [&together, &own]);
        }
    }
    search.best
}

struct Search<'a> {
    tree: &'a Tree,
    request: &'a Request,
    best: Planned,
    /// What that costs.
    least: usize,
    tried: BTreeSet<Arrangement>,
    /// How many nodes were built.
    n_nodes: usize,
}

impl Search<'_> {
    /// The arrangement with nothing read off.
    fn apart(&self, arrangement: &Arrangement) -> Arrangement {
        let places = 0..self.request.parts().len();
        let read = places.filter(|place| self.request.may_read_off(arrangement, *place));
        read.fold(arrangement.clone(), |all, place| {
            all.with_read_off(place, false)
        })
    }

    /// The part as it is in these, read off and in its own way.
    fn try_part(&mut self, place: usize, others: [&Arrangement; 2]) {
        for other in others {
            let best = &self.best.arrangement;
            self.try_one(best.with_part(place, other));
        }
        let best = &self.best.arrangement;
        if self.request.may_read_off(best, place) {
            self.try_one(best.with_read_off(place, !best.is_read_off(place)));
        }
    }

    /// Takes an arrangement if it is cheaper than the best.
    fn try_one(&mut self, arrangement: Arrangement) {
        if self.n_nodes > MOST_NODES || !self.tried.insert(arrangement.clone()) {
            return;
        }
        let &mut Self { tree, request, .. } = self;
        let planned = Planned::new(tree, request, arrangement);
        self.n_nodes += planned.derived.graph.len();
        let cost = cost_of(request, &planned.derived);
        if cost < self.least {
            (self.least, self.best) = (cost, planned);
        }
    }
}
