//! Numbers of the description: values, gravity, vectors fixed in bodies, constant rotations.

use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Vector, negated},
    geometry::{Rotation, transposed},
    tree::{Offset, Tree, Value},
};

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

/// Gravity as weights feel it, less what is lifted of all alike: inertial components.
pub fn acting_gravity(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let gravity = gravity(graph, tree);
    let share = graph.number(1.0 - tree.lifted);
    graph.scale(share, gravity)
}

/// A vector fixed in a body, along the axes of the whole.
pub fn fixed(graph: &mut ExprGraph, offset: &Offset) -> Vector {
    let mut sum = graph.zero_vector();
    for step in offset.steps() {
        let own = vector(graph, step.vector);
        let mut turned = constant_back(graph, &step.rotation, own);
        if step.negative {
            turned = negated(turned);
        }
        sum = graph.add_vectors(sum, turned);
    }
    sum
}

/// A constant rotation as expressions.
pub fn constant(graph: &mut ExprGraph, rotation: &Rotation) -> Matrix {
    rotation.map(|row| row.map(|entry| graph.number(entry)))
}

/// The components, before a constant rotation, of a vector given by those after it.
pub fn constant_back(graph: &mut ExprGraph, rotation: &Rotation, v: Vector) -> Vector {
    let back = constant(graph, &transposed(rotation));
    graph.mul_vector(&back, v)
}
