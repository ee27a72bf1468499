//! What joints transmit: the wrenches of all that a link carries, read off before they pass its joint.
//!
//! Links keep all their inertia here: what a joint does not move of a link is carried by the joint all the same.

use super::{gravity, loaded};
use crate::{
    expr::{ExprGraph, Purpose, Vector},
    given::{Accelerations, Loads},
    id::BodyMap,
    recursive::{
        links::{linkage::Linkage, totalled::Addend, wrench::Wrench},
        plan::Plan,
        technique::Technique,
    },
    tree::Tree,
};

/// Force and moment that each joint transmits to its body from the lower body, about the body's internal origin, which is
/// where the joint sits: internal axes.
pub fn joint_wrenches(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<[Vector; 2]> {
    let plan = plan.with(Technique::Regroup, false);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let mut wrenches = loaded::needed(graph, &linkage, Accelerations::Given, Loads::Given);
    if tree.lifts_some() {
        let lifts = gravity::lifts(graph, tree, &linkage.links);
        wrenches = BodyMap::outward(tree.bodies.len(), |body, _| {
            graph.enter(body);
            let lift = lifts[body].as_ref();
            lift.map_or(wrenches[body], |lift| wrenches[body].minus(graph, lift))
        });
    }
    graph.begin(Purpose::Forces);
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut passing = wrenches[body];
        graph.name_vector(passing.force, "f");
        graph.name_vector(passing.moment, "n");
        if let Some(lower) = tree.lower(body) {
            linkage.passages[body].inward(graph, &mut passing);
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &passing);
        }
    }
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let (link, Wrench { force, moment }) = (&linkage.links[body], wrenches[body]);
        let zero = graph.zero_vector();
        let origin = link.point_of_body(graph, zero);
        let lever = graph.cross(origin, force);
        let moment = graph.sub_vectors(moment, lever);
        [force, moment].map(|v| link.to_body(graph, v))
    })
}
