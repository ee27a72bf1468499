//! Composite bodies while they are gathered inward, link by link, with how fast their moments change.

use super::moments::{Changing, Moments};
use crate::{
    expr::ExprGraph,
    id::{BodyId, BodyMap},
    recursive::links::linkage::Linkage,
};

/// What each link has gathered so far.
pub(in crate::recursive) struct Gathered<R> {
    pub(in crate::recursive) moments: BodyMap<Moments>,
    pub(in crate::recursive) rates: BodyMap<R>,
}

impl<R: Changing> Gathered<R> {
    /// Nothing but the links themselves, which do not change.
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> Self {
        let n_bodies = linkage.tree.bodies.len();
        Self {
            moments: BodyMap::outward(n_bodies, |body, _| Moments::of(&linkage.links[body])),
            rates: BodyMap::outward(n_bodies, |_, _| R::zero(graph)),
        }
    }

    /// Adds what has come to a link through a joint on it, once it is named, and the columns that have come with it are.
    pub(in crate::recursive) fn add(
        &mut self,
        graph: &mut ExprGraph,
        lower: BodyId,
        (arrived, changing): (&Moments, &R),
        name_columns: impl FnOnce(&mut ExprGraph),
    ) {
        arrived.hint(graph, "composite_on_lower");
        changing.hint(graph, "composite_on_lower");
        name_columns(graph);
        graph.enter(lower);
        let (moments, rates) = (&mut self.moments[lower], &mut self.rates[lower]);
        *moments = moments.plus(graph, arrived);
        *rates = rates.plus(graph, changing);
        moments.hint(graph, "composite");
        rates.hint(graph, "composite");
    }
}
