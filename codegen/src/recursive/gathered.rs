//! Composite bodies while they are gathered inward, link by link, with how fast their moments change.

use super::{
    linkage::Linkage,
    moments::{Changing, Moments},
};
use crate::{
    expr::ExprGraph,
    id::{BodyId, BodyMap},
};

/// What each link has gathered so far.
pub(super) struct Gathered<R> {
    pub(super) moments: BodyMap<Moments>,
    pub(super) rates: BodyMap<R>,
}

impl<R: Changing> Gathered<R> {
    /// Nothing but the links themselves, which do not change.
    pub(super) fn new(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> Self {
        let n_bodies = linkage.tree.bodies.len();
        Self {
            moments: BodyMap::outward(n_bodies, |body, _| Moments::of(&linkage.links[body])),
            rates: BodyMap::outward(n_bodies, |_, _| R::zero(graph)),
        }
    }

    /// Names what has come to a link, before columns that have come with it are named.
    pub(super) fn hint(graph: &mut ExprGraph, (arrived, changing): (&Moments, &R)) {
        arrived.hint(graph, "composite_on_lower");
        changing.hint(graph, "composite_on_lower");
    }

    /// Adds what has come to a link through a joint on it.
    pub(super) fn add(
        &mut self,
        graph: &mut ExprGraph,
        lower: BodyId,
        (arrived, changing): (&Moments, &R),
    ) {
        graph.enter(lower);
        let (moments, rates) = (&mut self.moments[lower], &mut self.rates[lower]);
        *moments = moments.plus(graph, arrived);
        *rates = rates.plus(graph, changing);
        moments.hint(graph, "composite");
        rates.hint(graph, "composite");
    }
}
