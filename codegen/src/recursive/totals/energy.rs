//! Energies of the whole system. For the sum over bodies alone, links need not keep their own inertia: regrouped, it is the same.

use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Symmetric, Vector},
    given::mechanics,
    id::BodyMap,
    kane,
    recursive::{
        forces::weight::{Field, Weight},
        links::{
            inertia::Composite,
            link,
            link_velocity::{self, LinkVelocity},
            root,
            totalled::totalled,
        },
        plan::Plan,
    },
    tree::Tree,
};

/// `1/2 sum m v · v + 2 h · (v × w) + w · I w` of links about their origins, and that of the rotors, J.
pub fn kinetic(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Expr {
    let links = link::links(graph, tree, plan);
    graph.begin(Purpose::Outward);
    let velocities = link_velocity::velocities(graph, tree, &links);
    graph.begin(Purpose::Energy);
    let twice = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        twice_kinetic(graph, &links[body].inertia, &velocities[body])
    });
    let twice = kane::energy::gather(graph, tree, twice);
    graph.enter(None);
    let half = graph.number(0.5);
    let of_bodies = graph.mul(half, twice);
    let of_rotors = mechanics::kinetic(graph, tree);
    graph.add(of_bodies, of_rotors)
}

/// That of all weights and of the springs, J.
pub fn potential(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Expr {
    let of_weights = of_weights(graph, tree, plan);
    let of_springs = mechanics::potential(graph, tree);
    graph.add(of_weights, of_springs)
}

/// `-g · h` of all first moments, less what is lifted, zero at the inertial origin, J.
pub fn of_weights(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Expr {
    // Below links on the inertial frame is none that could have their weight.
    let links = link::links(graph, tree, &root::kept_whole(tree, plan));
    let field = Field::new(graph, tree, plan);
    graph.begin(Purpose::Weight);
    let weights = BodyMap::outward(tree.bodies.len(), |body, _| {
        Weight::left(graph, tree, &field, &links[body], body)
    });
    let name = |weight: &Weight, graph: &mut ExprGraph| {
        graph.name_vector(weight.moment, "composite");
    };
    let mut moment = graph.zero_vector();
    let passage = |body| &links[body].passage;
    totalled(
        graph,
        tree,
        passage,
        weights,
        name,
        |graph, body, weight| {
            let origin = root::origin(graph, tree, &links[body], body);
            graph.enter(None);
            let own = weight.moved(graph, origin);
            moment = graph.add_vectors(moment, own.moment);
        },
    );
    graph.begin(Purpose::Energy);
    graph.enter(None);
    graph.dot(field.upward, moment)
}

/// `m v · v + 2 h · (v × w) + w · I w`, about a point with velocity `v`.
fn twice_kinetic(graph: &mut ExprGraph, inertia: &Composite, velocity: &LinkVelocity) -> Expr {
    let LinkVelocity { linear, angular } = *velocity;
    let two = graph.number(2.0);
    let moment = graph.scale(two, inertia.moment);
    let translational = if graph.is_zero(inertia.mass) {
        let across = graph.cross(linear, angular);
        graph.dot(moment, across)
    } else {
        let carried = graph.scale(inertia.mass, linear);
        let swept = graph.cross(angular, moment);
        let both = graph.add_vectors(carried, swept);
        graph.dot(linear, both)
    };
    let turning = square_by(graph, &inertia.inertia, angular);
    graph.add(translational, turning)
}

/// `w · I w`: each product of two components once.
fn square_by(graph: &mut ExprGraph, tensor: &Symmetric, w: Vector) -> Expr {
    let two = graph.number(2.0);
    let mut sum = graph.zero();
    for a in Axis::ALL.map(Axis::index) {
        let mut row = graph.mul(tensor.entry(a, a), w[a]);
        for (b, other) in w.into_iter().enumerate().skip(a + 1) {
            let twice = graph.mul(two, tensor.entry(a, b));
            let term = graph.mul(twice, other);
            row = graph.add(row, term);
        }
        let own = graph.mul(w[a], row);
        sum = graph.add(sum, own);
    }
    sum
}
