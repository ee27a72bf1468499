//! Links on the inertial frame: where they are, of which the way to them knows nothing.

use super::{link::Link, rotation::Turn};
use crate::{
    expr::{ExprGraph, Vector},
    given,
    id::{BodyId, BodyMap},
    recursive::plan::{Plan, Regroup},
    tree::Tree,
};

/// The plan with all inertia of links on the inertial frame where it is: below them is none that could have it.
pub(in crate::recursive) fn kept_whole(tree: &Tree, plan: &Plan) -> Plan {
    let roots = tree.body_ids().filter(|body| tree.lower(*body).is_none());
    roots.fold(plan.clone(), |plan, root| {
        plan.with_regroup(Some(root), Regroup::None)
    })
}

/// From the inertial origin to the origin of a link on the inertial frame, inertial components. The link's may stand elsewhere
/// on its axis than its body's.
pub(in crate::recursive) fn origin(
    graph: &mut ExprGraph,
    tree: &Tree,
    link: &Link,
    body: BodyId,
) -> Vector {
    graph.enter(body);
    let offset = given::offset(graph, tree.body(body));
    let zero = graph.zero_vector();
    let own = link.point_of_body(graph, zero);
    let own = link.passage.backward_to_joint(graph, own);
    let own = link.passage.constant.backward(graph, own);
    graph.sub_vectors(offset, own)
}

/// From the origin of the first link on the inertial frame to that of another one, inertial components.
pub(in crate::recursive) fn from_first(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    body: BodyId,
) -> Vector {
    let first = BodyId::new(0);
    if body == first {
        return graph.zero_vector();
    }
    let from = origin(graph, tree, &links[first], first);
    let to = origin(graph, tree, &links[body], body);
    graph.sub_vectors(to, from)
}
