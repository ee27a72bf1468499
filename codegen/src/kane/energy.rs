//! Energies and momenta: the integrals against which motion is checked. Each body hands the sum of what it carries
//! to its lower body, so that a body's share shows in the lines of its path alone.

use super::{orientation, position, velocity};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Purpose, Vector, transpose},
    given::{self, mechanics},
    id::BodyMap,
    tree::Tree,
};

/// `1/2 sum_K m_K v_G_K · v_G_K + w_K · I_K w_K`, and that of the rotors, J.
pub fn kinetic(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let twice = twice_kinetic(graph, tree);
    let twice = gather(graph, tree, twice);
    graph.enter(None);
    let half = graph.number(0.5);
    let of_bodies = graph.mul(half, twice);
    let of_rotors = mechanics::kinetic(graph, tree);
    graph.add(of_bodies, of_rotors)
}

/// The same of each body, with the rotors of its joint.
pub fn kinetic_by_body(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Expr> {
    let twice = twice_kinetic(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let of_rotors = mechanics::twice_kinetic_of(graph, tree, body);
        let whole = graph.add(twice[body], of_rotors);
        let half = graph.number(0.5);
        graph.mul(half, whole)
    })
}

/// `m_K v_G_K · v_G_K + w_K · I_K w_K`.
fn twice_kinetic(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Expr> {
    graph.begin(Purpose::Energy);
    let rotational = velocity::rotational(graph, tree);
    let v_origin = velocity::origin(graph, tree, &rotational);
    let v = velocity::mass_center(graph, tree, &rotational, &v_origin);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let inertia = given::inertia(graph, tree.body(body));
        let square = graph.dot(v[body], v[body]);
        let translational = graph.mul(mass, square);
        let momentum = graph.mul_symmetric(&inertia, rotational.w[body]);
        let turning = graph.dot(rotational.w[body], momentum);
        graph.add(translational, turning)
    })
}

/// `-sum_K m_K g · p_G_K` less what is lifted of it, zero at the inertial origin, and that of the springs, zero at rest, J.
pub fn potential(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let potentials = of_weight(graph, tree);
    let of_weights = gather(graph, tree, potentials);
    let of_springs = mechanics::potential(graph, tree);
    graph.add(of_weights, of_springs)
}

/// The same of each body, with the springs of its joint.
pub fn potential_by_body(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Expr> {
    let of_weight = of_weight(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let twice = mechanics::twice_potential_of(graph, tree, body);
        let half = graph.number(0.5);
        let of_springs = graph.mul(half, twice);
        graph.add(of_weight[body], of_springs)
    })
}

/// `-m_K g · p_G_K`, less what is lifted of it.
fn of_weight(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Expr> {
    graph.begin(Purpose::Energy);
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    let gravity = super::dynamics::gravity_in_bodies(graph, tree, &relative);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let along = graph.dot(gravity[body], centers[body]);
        let depth = graph.mul(mass, along);
        let Some(lifted) = given::lifted(graph, tree.body(body)) else {
            return -depth;
        };
        let along = graph.dot(gravity[body], origins[body]);
        let of_origin = graph.mul(lifted.mass, along);
        let beyond = graph.dot(gravity[body], lifted.moment);
        let lifted = graph.add(of_origin, beyond);
        graph.sub(lifted, depth)
    })
}

/// `sum_K m_K v_G_K`, kg m/s, inertial components.
pub fn linear_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let rotational = velocity::rotational(graph, tree);
    let linear = linear_momenta(graph, tree, &rotational);
    gather_vectors(graph, tree, &rotational.relative, linear)
}

/// `sum_K p_G_K × m_K v_G_K + I_K w_K` about the inertial origin, kg m²/s, inertial components.
pub fn angular_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let rotational = velocity::rotational(graph, tree);
    let linear = linear_momenta(graph, tree, &rotational);
    let origins = position::origin(graph, tree, &rotational.relative);
    let centers = position::mass_center(graph, tree, &origins);
    let angular = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let inertia = given::inertia(graph, tree.body(body));
        let orbital = graph.cross(centers[body], linear[body]);
        let spin = graph.mul_symmetric(&inertia, rotational.w[body]);
        graph.add_vectors(orbital, spin)
    });
    gather_vectors(graph, tree, &rotational.relative, angular)
}

/// `m_K v_G_K`, body components, for every body.
fn linear_momenta(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotational: &velocity::Rotational,
) -> BodyMap<Vector> {
    graph.begin(Purpose::Momentum);
    let v_origin = velocity::origin(graph, tree, rotational);
    let v = velocity::mass_center(graph, tree, rotational, &v_origin);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        graph.scale(mass, v[body])
    })
}

/// The sum over all bodies.
pub fn gather(graph: &mut ExprGraph, tree: &Tree, mut shares: BodyMap<Expr>) -> Expr {
    let mut total = graph.zero();
    for body in tree.body_ids().rev() {
        let share = shares[body];
        graph.enter(tree.lower(body));
        match tree.lower(body) {
            Some(lower) => shares[lower] = graph.add(shares[lower], share),
            None => total = graph.add(total, share),
        }
    }
    total
}

/// The sum over all bodies of vectors in body components: inertial components.
pub(super) fn gather_vectors(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    mut shares: BodyMap<Vector>,
) -> Vector {
    let mut total = graph.zero_vector();
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let share = graph.mul_vector(&transpose(&relative[body]), shares[body]);
        graph.enter(tree.lower(body));
        match tree.lower(body) {
            Some(lower) => shares[lower] = graph.add_vectors(shares[lower], share),
            None => total = graph.add_vectors(total, share),
        }
    }
    total
}
