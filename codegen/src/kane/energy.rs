//! Energies and momenta: the integrals against which motion is checked.

use super::{given, orientation, position, velocity};
use crate::{
    expr::{Expr, ExprGraph, Vector, transpose},
    tree::Tree,
};

/// `1/2 sum_K m_K v_G_K · v_G_K + w_K · I_K w_K`, J.
pub fn kinetic(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let rotational = velocity::rotational(graph, tree);
    let v_origin = velocity::origin(graph, tree, &rotational);
    let v = velocity::mass_center(graph, tree, &rotational, &v_origin);
    let mut twice = graph.zero();
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::value(graph, tree.body(body).mass);
        let inertia = given::inertia(graph, tree.body(body));
        let square = graph.dot(v[body], v[body]);
        let translational = graph.mul(mass, square);
        let momentum = graph.mul_symmetric(&inertia, rotational.w[body]);
        let turning = graph.dot(rotational.w[body], momentum);
        let own = graph.add(translational, turning);
        twice = graph.add(twice, own);
    }
    graph.enter(None);
    let half = graph.number(0.5);
    graph.mul(half, twice)
}

/// `-sum_K m_K g · p_G_K`, J: zero at the inertial origin.
pub fn potential(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    let gravity = given::gravity(graph, tree);
    let mut sum = graph.zero();
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::value(graph, tree.body(body).mass);
        let g = graph.mul_vector(&absolute[body], gravity);
        let height = graph.dot(g, centers[body]);
        let own = graph.mul(mass, height);
        sum = graph.sub(sum, own);
    }
    sum
}

/// Linear momentum, kg m/s, and angular momentum about the inertial origin, kg m²/s, inertial components.
pub fn momenta(graph: &mut ExprGraph, tree: &Tree) -> (Vector, Vector) {
    let rotational = velocity::rotational(graph, tree);
    let v_origin = velocity::origin(graph, tree, &rotational);
    let v = velocity::mass_center(graph, tree, &rotational, &v_origin);
    let absolute = orientation::absolute(graph, tree, &rotational.relative);
    let origins = position::origin(graph, tree, &rotational.relative);
    let centers = position::mass_center(graph, tree, &origins);
    let (mut linear, mut angular) = (graph.zero_vector(), graph.zero_vector());
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::value(graph, tree.body(body).mass);
        let inertia = given::inertia(graph, tree.body(body));
        let to_inertial = transpose(&absolute[body]);
        let own = graph.scale(mass, v[body]);
        let about_origin = graph.cross(centers[body], own);
        let spin = graph.mul_symmetric(&inertia, rotational.w[body]);
        let turning = graph.add_vectors(about_origin, spin);
        let own = graph.mul_vector(&to_inertial, own);
        let turning = graph.mul_vector(&to_inertial, turning);
        linear = graph.add_vectors(linear, own);
        angular = graph.add_vectors(angular, turning);
    }
    (linear, angular)
}
