//! The root expressions of how bodies stand and move.

use super::user_axes;
use crate::{
    expr::{Expr, ExprGraph, Matrix, Vector},
    given::Accelerations,
    id::BodyMap,
    kane::{angular, orientation, position, velocity},
    partition::Row,
    tree::Tree,
};

fn vectors(vectors: BodyMap<Vector>) -> Vec<Expr> {
    vectors.into_values().flatten().collect()
}

fn matrices(matrices: BodyMap<Matrix>) -> Vec<Expr> {
    matrices.into_values().flatten().flatten().collect()
}

pub(in crate::functions) fn relative_rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    matrices(user_axes::relative_rotations(graph, tree, &relative))
}

pub(in crate::functions) fn rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    matrices(user_axes::rotations(graph, tree, &absolute))
}

pub(in crate::functions) fn relative_angular_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    let w_rel = angular::relative_velocity(graph, tree);
    vectors(user_axes::vectors(graph, tree, &w_rel))
}

pub(in crate::functions) fn angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let w = velocity::rotational(graph, tree).w;
    vectors(user_axes::vectors(graph, tree, &w))
}

pub(in crate::functions) fn angular_acceleration(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let velocity::Rotational { relative, w_rel, w } = &rotational;
    let given = Accelerations::Given;
    let alpha = angular::acceleration(graph, tree, relative, w_rel, w, given);
    vectors(user_axes::vectors(graph, tree, &alpha))
}

pub(in crate::functions) fn partial_angular_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> BodyMap<Row> {
    let relative = orientation::relative(graph, tree);
    let partial = angular::partial(graph, tree, &relative);
    user_axes::rows(graph, tree, partial)
}

pub(in crate::functions) fn partial_angular_velocity_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> BodyMap<Row> {
    let dot = partials_dot(graph, tree).angular;
    user_axes::rows(graph, tree, dot)
}

pub(in crate::functions) fn origin_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    vectors(user_axes::origins(graph, tree, &origins))
}

pub(in crate::functions) fn mass_center_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    vectors(user_axes::vectors(graph, tree, &centers))
}

pub(in crate::functions) fn origin_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let velocities = velocity::origin(graph, tree, &rotational);
    vectors(user_axes::origin_velocities(
        graph,
        tree,
        &rotational,
        &velocities,
    ))
}

pub(in crate::functions) fn mass_center_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let origin = velocity::origin(graph, tree, &rotational);
    let velocities = velocity::mass_center(graph, tree, &rotational, &origin);
    vectors(user_axes::vectors(graph, tree, &velocities))
}

fn partials(graph: &mut ExprGraph, tree: &Tree) -> velocity::Partials {
    let relative = orientation::relative(graph, tree);
    velocity::partials(graph, tree, &relative)
}

fn partials_dot(graph: &mut ExprGraph, tree: &Tree) -> velocity::Partials {
    let rotational = velocity::rotational(graph, tree);
    let partials = velocity::partials(graph, tree, &rotational.relative);
    velocity::partials_dot(graph, tree, &rotational, &partials)
}

pub(in crate::functions) fn partial_velocity_origin(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> BodyMap<Row> {
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    user_axes::origin_rows(graph, tree, &relative, &partials.angular, &partials.origin)
}

pub(in crate::functions) fn partial_velocity_origin_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> BodyMap<Row> {
    let rotational = velocity::rotational(graph, tree);
    let partials = velocity::partials(graph, tree, &rotational.relative);
    let dot = velocity::partials_dot(graph, tree, &rotational, &partials);
    let angular = (&partials.angular, &dot.angular);
    user_axes::origin_rows_dot(graph, tree, &rotational, angular, &dot.origin)
}

pub(in crate::functions) fn partial_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let partial = partials(graph, tree).mass_center;
    user_axes::rows(graph, tree, partial)
}

pub(in crate::functions) fn partial_velocity_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> BodyMap<Row> {
    let dot = partials_dot(graph, tree).mass_center;
    user_axes::rows(graph, tree, dot)
}

pub(in crate::functions) fn mass_center_acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    let accelerations = velocity::accelerations(graph, tree, Accelerations::Given).mass_center;
    vectors(user_axes::vectors(graph, tree, &accelerations))
}
