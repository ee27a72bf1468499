//! What links need from their joints and from the links that they carry: what moves them as they move, weight included, less
//! the loads on them.

use crate::{
    expr::{ExprGraph, Purpose},
    given::{self, Accelerations, Loads},
    id::{BodyId, BodyMap},
    recursive::links::{link::Link, link_motion, linkage::Linkage, wrench::Wrench},
    tree::Tree,
};

/// The wrench that each link needs, about its origin.
pub(in crate::recursive) fn needed(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
    loads: Loads,
) -> BodyMap<Wrench> {
    let inertial = link_motion::inertial_wrenches(graph, linkage, accelerations);
    if loads == Loads::Absent {
        return inertial;
    }
    let Linkage { tree, links, .. } = linkage;
    graph.begin(Purpose::Loads);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let load = load(graph, tree, &links[body], body);
        inertial[body].minus(graph, &load)
    })
}

/// The load of a body about its link's origin.
pub(in crate::recursive) fn load(
    graph: &mut ExprGraph,
    tree: &Tree,
    link: &Link,
    body: BodyId,
) -> Wrench {
    graph.enter(body);
    let center = given::mass_center(graph, tree.body(body));
    let center = link.point_of_body(graph, center);
    let (force, moment) = (
        given::force(graph, tree, body),
        given::moment(graph, tree, body),
    );
    let [force, moment] = [force, moment].map(|v| link.of_body(graph, v));
    let lever = graph.cross(center, force);
    Wrench {
        force,
        moment: graph.add_vectors(moment, lever),
    }
}
