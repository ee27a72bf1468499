//! What joints transmit: by Newton and Euler, all that the bodies outward of a joint need, summed in the inertial frame.

use super::{
    dynamics::{self, Wrench},
    orientation, position,
};
use crate::{
    expr::{ExprGraph, transpose},
    given::Accelerations,
    id::BodyMap,
    tree::Tree,
};

/// Force and moment that each joint transmits to its body from the lower body, about the body's internal origin, which is
/// where the joint sits: internal axes.
pub fn joint_wrenches(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Wrench> {
    let needed = dynamics::needed(graph, tree, Accelerations::Given);
    let lifts = dynamics::lifts(graph, tree);
    let relative = orientation::relative(graph, tree);
    let rotations = orientation::absolute(graph, tree, &relative);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    // About the inertial origin, inertial components.
    let mut sums = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let Wrench { force, moment } = needed[body].minus(graph, &lifts[body]);
        let lever = graph.cross(centers[body], force);
        let moment = graph.add_vectors(moment, lever);
        let back = transpose(&rotations[body]);
        Wrench {
            force: graph.mul_vector(&back, force),
            moment: graph.mul_vector(&back, moment),
        }
    });
    for body in tree.body_ids().rev() {
        if let Some(lower) = tree.lower(body) {
            graph.enter(lower);
            let (own, below) = (sums[body], sums[lower]);
            sums[lower] = Wrench {
                force: graph.add_vectors(below.force, own.force),
                moment: graph.add_vectors(below.moment, own.moment),
            };
        }
    }
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let force = graph.mul_vector(&rotations[body], sums[body].force);
        let moment = graph.mul_vector(&rotations[body], sums[body].moment);
        let lever = graph.cross(origins[body], force);
        Wrench {
            force,
            moment: graph.sub_vectors(moment, lever),
        }
    })
}
