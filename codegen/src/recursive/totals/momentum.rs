//! Momentum of all bodies: links move outward, and their momenta pass inward as wrenches do.

use super::center;
use crate::{
    expr::{ExprGraph, Purpose, Vector},
    id::BodyMap,
    recursive::{
        links::{link, link_velocity, root, totalled::totalled, wrench::Wrench},
        plan::Plan,
    },
    tree::Tree,
};

/// `sum_K m_K v_G_K`, inertial components, kg m/s: how the first moment of all bodies changes.
pub fn linear(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vector {
    let links = link::links(graph, tree, plan);
    center::moment_rate(graph, tree, &links)
}

/// `sum_K p_G_K × m_K v_G_K + I_K w_K` about the inertial origin, inertial components, kg m²/s.
pub fn angular(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vector {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Outward);
    let velocities = link_velocity::velocities(graph, tree, &links);
    graph.begin(Purpose::Momentum);
    let momenta = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let velocity = &velocities[body];
        Wrench::of_inertia(
            graph,
            &links[body].inertia,
            velocity.linear,
            velocity.angular,
        )
    });
    let name = |momentum: &Wrench, graph: &mut ExprGraph| {
        graph.name_vector(momentum.force, "p");
        graph.name_vector(momentum.moment, "l");
    };
    let mut sum = graph.zero_vector();
    let passage = |body| &links[body].passage;
    totalled(
        graph,
        tree,
        passage,
        momenta,
        name,
        |graph, body, momentum| {
            let origin = root::origin(graph, tree, &links[body], body);
            graph.enter(None);
            let about_origin = momentum.moved(graph, origin);
            sum = graph.add_vectors(sum, about_origin.moment);
        },
    );
    sum
}
