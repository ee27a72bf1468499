//! What an equation is given: coordinates, rates, loads, and the numbers of the description.

use crate::{
    expr::{Expr, ExprGraph, Input, Symmetric, Vector},
    id::BodyId,
    tree::{Body, Coordinate, Tree, Value},
};

/// The accelerations with which a right-hand side is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accelerations {
    /// `u_dot` as an argument.
    Given,
    /// Zero: what is left is the bias.
    Zero,
}

/// A number of the description.
pub fn value(graph: &mut ExprGraph, value: Value) -> Expr {
    match value {
        Value::Baked(number) => graph.number(number),
        Value::Runtime(parameter) => graph.input(Input::Parameter(parameter)),
    }
}

/// Three numbers of the description.
pub fn vector(graph: &mut ExprGraph, values: [Value; 3]) -> Vector {
    values.map(|component| value(graph, component))
}

/// Gravity, inertial components.
pub fn gravity(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    graph.enter(None);
    vector(graph, tree.gravity)
}

/// `I'_GK`: the inertia of a body about its mass centre, body components.
pub fn inertia(graph: &mut ExprGraph, body: &Body) -> Symmetric {
    let i = &body.inertia;
    Symmetric {
        diagonal: vector(graph, [i.xx, i.yy, i.zz]),
        mixed: vector(graph, [i.yz, i.xz, i.xy]),
    }
}

/// A relative coordinate: an entry of `q`, or the value at which it is locked.
pub fn coordinate(graph: &mut ExprGraph, coordinate: Coordinate) -> Expr {
    match coordinate {
        Coordinate::Free { coordinate, .. } => graph.input(Input::Q(coordinate)),
        Coordinate::Locked(at) => graph.number(at),
    }
}

/// The rate of a relative coordinate, Eq. (44): an entry of `u`; zero where locked.
pub fn rate(graph: &mut ExprGraph, coordinate: Coordinate) -> Expr {
    match coordinate {
        Coordinate::Free { speed, .. } => graph.input(Input::U(speed)),
        Coordinate::Locked(_) => graph.zero(),
    }
}

/// The second derivative of a relative coordinate: an entry of `u_dot`; zero where locked.
pub fn acceleration(
    graph: &mut ExprGraph,
    coordinate: Coordinate,
    accelerations: Accelerations,
) -> Expr {
    match (coordinate, accelerations) {
        (Coordinate::Free { speed, .. }, Accelerations::Given) => graph.input(Input::UDot(speed)),
        _ => graph.zero(),
    }
}

/// q'_K + s'_K: from the lower body's origin to the body's, lower-body components.
pub fn offset(graph: &mut ExprGraph, body: &Body) -> Vector {
    let attachment = vector(graph, body.attachment);
    let translation = body.joint.translations.map(|s| coordinate(graph, s));
    let offset = graph.add_vectors(attachment, translation);
    graph.name_vector(offset, "offset");
    offset
}

/// A load's force at the mass centre, body components.
pub fn force(graph: &mut ExprGraph, body: BodyId) -> Vector {
    [0, 1, 2].map(|i| graph.input(Input::Force(body, i)))
}

/// A load's moment, body components.
pub fn moment(graph: &mut ExprGraph, body: BodyId) -> Vector {
    [0, 1, 2].map(|i| graph.input(Input::Moment(body, i)))
}
