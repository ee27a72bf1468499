//! Results in the user's frames: the equations are written in the bodies' internal ones.

use crate::{
    expr::{ExprGraph, Matrix, Vector, negated, transpose},
    geometry::IDENTITY,
    given,
    id::{BodyId, BodyMap},
    kane::velocity::Rotational,
    partition::Row,
    tree::Tree,
};

/// A vector of a body, from its internal axes to the user's.
pub(in crate::functions) fn vector(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    v: Vector,
) -> Vector {
    let pose = given::constant(graph, &tree.body(body).pose.rotation);
    graph.mul_vector(&pose, v)
}

/// Vectors of all bodies.
pub(in crate::functions) fn vectors(
    graph: &mut ExprGraph,
    tree: &Tree,
    vectors: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        vector(graph, tree, body, vectors[body])
    })
}

/// Rows of partitions of all bodies, in body components.
pub(in crate::functions) fn rows(
    graph: &mut ExprGraph,
    tree: &Tree,
    rows: BodyMap<Row>,
) -> BodyMap<Row> {
    let mut rows = rows;
    for body in tree.body_ids() {
        rows[body] = row(graph, tree, Some(body), &rows[body]);
    }
    rows
}

fn row(graph: &mut ExprGraph, tree: &Tree, body: Option<BodyId>, row: &Row) -> Row {
    let Some(body) = body.filter(|body| tree.body(*body).pose.rotation != IDENTITY) else {
        return row.clone();
    };
    graph.enter(body);
    let pose = given::constant(graph, &tree.body(body).pose.rotation);
    row.premultiplied(graph, &pose)
}

/// Transformation matrices to internal axes: to the user's.
pub(in crate::functions) fn rotations(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotations: &BodyMap<Matrix>,
) -> BodyMap<Matrix> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let pose = given::constant(graph, &tree.body(body).pose.rotation);
        graph.mul_matrices(&pose, &rotations[body])
    })
}

/// Relative transformation matrices between internal axes: between the user's.
pub(super) fn relative_rotations(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
) -> BodyMap<Matrix> {
    let outer = rotations(graph, tree, relative);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let Some(lower) = tree.lower(body) else {
            return outer[body];
        };
        let pose = given::constant(graph, &tree.body(lower).pose.rotation);
        graph.mul_matrices(&outer[body], &transpose(&pose))
    })
}

/// Positions of the internal origins, internal axes: of the user's origins, the user's axes.
pub(in crate::functions) fn origins(
    graph: &mut ExprGraph,
    tree: &Tree,
    origins: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let own = given::fixed(graph, &tree.body(body).pose.origin);
        let position = graph.add_vectors(origins[body], own);
        vector(graph, tree, body, position)
    })
}

/// Velocities of the internal origins, lower-body internal axes: of the user's origins, lower-body user axes.
pub(super) fn origin_velocities(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotational: &Rotational,
    velocities: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let own = given::fixed(graph, &tree.body(body).pose.origin);
        let turned = graph.cross(rotational.w[body], own);
        let turned = graph.mul_vector(&transpose(&rotational.relative[body]), turned);
        let velocity = graph.add_vectors(velocities[body], turned);
        match tree.lower(body) {
            Some(lower) => vector(graph, tree, lower, velocity),
            None => velocity,
        }
    })
}

/// Partial velocities of the internal origins, lower-body internal axes: of the user's origins, lower-body user axes.
pub(super) fn origin_rows(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    angular: &BodyMap<Row>,
    origins: &BodyMap<Row>,
) -> BodyMap<Row> {
    moved_rows(graph, tree, relative, origins, |graph, body, own| {
        angular[body].crossed(graph, own)
    })
}

/// The same for the time derivatives: `d/dt (R^T X) = R^T (X_dot + w_rel × X)` with `X = W × o`.
pub(super) fn origin_rows_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotational: &Rotational,
    (angular, angular_dot): (&BodyMap<Row>, &BodyMap<Row>),
    origins_dot: &BodyMap<Row>,
) -> BodyMap<Row> {
    moved_rows(
        graph,
        tree,
        &rotational.relative,
        origins_dot,
        |graph, body, own| {
            let accelerated = angular_dot[body].crossed(graph, own);
            let turned = angular[body]
                .crossed(graph, own)
                .crossed(graph, negated(rotational.w_rel[body]));
            accelerated.plus(graph, turned)
        },
    )
}

/// Rows of origins, each with what the way from the internal origin to the user's adds, body components, where there is
/// such a way.
fn moved_rows(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    rows: &BodyMap<Row>,
    mut added: impl FnMut(&mut ExprGraph, BodyId, Vector) -> Row,
) -> BodyMap<Row> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let origin = &tree.body(body).pose.origin;
        let mut moved = rows[body].clone();
        if !origin.steps().is_empty() {
            let own = given::fixed(graph, origin);
            let added = added(graph, body, own);
            let added = added.premultiplied(graph, &transpose(&relative[body]));
            moved = moved.plus(graph, added);
        }
        row(graph, tree, tree.lower(body), &moved)
    })
}
