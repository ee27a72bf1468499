//! Positions, Eqs. (22), (23).

use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector},
    given,
    id::BodyMap,
    tree::Tree,
};

/// `p_O_K = JR_K (p_O_J + q_K + s_K)`, Eq. (22): from the inertial origin, body components, for every body.
pub fn origin(graph: &mut ExprGraph, tree: &Tree, relative: &BodyMap<Matrix>) -> BodyMap<Vector> {
    graph.begin(Purpose::Position);
    BodyMap::outward(tree.bodies.len(), |body, origins| {
        graph.enter(body);
        let mut position = given::offset(graph, tree.body(body));
        if let Some(lower) = tree.lower(body) {
            position = graph.add_vectors(origins[lower], position);
        }
        let position = graph.mul_vector(&relative[body], position);
        graph.name_vector(position, "p_o");
        position
    })
}

/// `p_G_K = p_O_K + r_K`, Eq. (23): from the inertial origin, body components, for every body.
pub fn mass_center(
    graph: &mut ExprGraph,
    tree: &Tree,
    origins: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    graph.begin(Purpose::Position);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let r = given::mass_center(graph, tree.body(body));
        let position = graph.add_vectors(origins[body], r);
        graph.name_vector(position, "p_g");
        position
    })
}
