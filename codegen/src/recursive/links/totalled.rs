//! What all bodies have together: each link's own passes inward with what its upper links sent, down to the inertial frame.

use super::passage::{Passage, Passenger};
use crate::{
    expr::ExprGraph,
    id::{BodyId, BodyMap},
    tree::Tree,
};

/// What adds up where branches meet.
pub(in crate::recursive) trait Addend: Passenger + Copy {
    /// Both together, about one point and along one set of axes.
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self;

    /// Names what has come through a link's joint, before it is added up.
    fn name_below(&self, _: &mut ExprGraph) {}
}

/// Adds up what links have, and names what stands at each with all that it carries. At each root it is handed over, about the root
/// link's origin and along inertial axes.
pub(in crate::recursive) fn totalled<'a, A: Addend>(
    graph: &mut ExprGraph,
    tree: &Tree,
    passage: impl Fn(BodyId) -> &'a Passage,
    mut own: BodyMap<A>,
    name: impl Fn(&A, &mut ExprGraph),
    mut at_root: impl FnMut(&mut ExprGraph, BodyId, A),
) {
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut passing = own[body];
        name(&passing, graph);
        passage(body).inward(graph, &mut passing);
        graph.enter(body);
        passing.name_below(graph);
        let lower = tree.lower(body);
        graph.enter(lower);
        match lower {
            Some(lower) => own[lower] = own[lower].plus(graph, &passing),
            None => at_root(graph, body, passing),
        }
    }
}
