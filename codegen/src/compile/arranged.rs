//! The cheapest arrangement of a joined function: which parts are derived by one plan, which by a plan of their own, and which are
//! read off what others find.
//!
//! In: the function by one plan for all parts, and each part alone by its own. Out: the cheapest [`Planned`]. Afterwards: it needs
//! no more operations than by one plan.

use super::{
    planned::{Planned, operations},
    search::SINE_OF_SEVERAL,
};
use crate::{
    functions::{Arrangement, Formulation, Request},
    tree::Tree,
};

/// How many operations may be derived to try the parts one by one.
const MOST_TRIED: usize = 400_000;

/// The cheapest of the arrangements that are tried.
pub(super) fn cheapest(
    tree: &Tree,
    request: &Request,
    together: &Planned,
    own: &[Planned],
) -> Planned {
    let plans = own.iter().map(|own| own.arrangement.plan(0).clone());
    let own = Arrangement::new(plans);
    let places = 0..request.parts().len();
    let mut search = Search {
        tree,
        request,
        least: cost(together),
        best: together.clone(),
    };
    search.try_one(own.clone());
    let read_by = |arrangement: &Arrangement| {
        let can = |place: &usize| request.may_read_off(arrangement, *place);
        places.clone().filter(can).collect::<Vec<usize>>()
    };
    for arrangement in [&together.arrangement, &own] {
        let read = read_by(arrangement).into_iter();
        let apart = read.fold(arrangement.clone(), |all, place| {
            all.with_read_off(place, false)
        });
        search.try_one(apart);
    }
    if 4 * request.parts().len() * operations(&search.best.derived).total() > MOST_TRIED {
        return search.best;
    }
    let mut before = usize::MAX;
    while search.least < before {
        before = search.least;
        for place in places.clone() {
            search.try_part(place, [&together.arrangement, &own]);
        }
    }
    search.best
}

/// There is one sine and one cosine a joint, whatever another one would save.
fn cost(planned: &Planned) -> usize {
    let operations = operations(&planned.derived);
    operations.total() + SINE_OF_SEVERAL * operations.trig
}

struct Search<'a> {
    tree: &'a Tree,
    request: &'a Request,
    best: Planned,
    /// What that costs.
    least: usize,
}

impl Search<'_> {
    /// The part by its plan in these, read off and in its own way.
    fn try_part(&mut self, place: usize, others: [&Arrangement; 2]) {
        for other in others {
            let best = &self.best.arrangement;
            self.try_one(best.with_plan(place, other.plan(place).clone()));
        }
        let best = &self.best.arrangement;
        if self.request.may_read_off(best, place) {
            self.try_one(best.with_read_off(place, !best.is_read_off(place)));
        }
    }

    /// Takes an arrangement if it is cheaper than the best.
    fn try_one(&mut self, arrangement: Arrangement) {
        if arrangement == self.best.arrangement {
            return;
        }
        let &mut Self { tree, request, .. } = self;
        let planned = Planned::new(tree, request, Formulation::Recursive, arrangement);
        let cost = cost(&planned);
        if cost < self.least {
            (self.least, self.best) = (cost, planned);
        }
    }
}
