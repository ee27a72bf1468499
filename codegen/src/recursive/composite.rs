//! The mass matrix from composite bodies (Walker and Orin 1982): each body with all that it carries is one
//! rigid body, whose momentum for a unit speed is carried inward and read off at every speed that it passes.

use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::{BodyId, BodyMap, SpeedId},
    kane::dynamics::SpeedMatrix,
    recursive::{
        frames::{self, Rotation},
        inertia::{self, Composite},
    },
    tree::Tree,
};

/// Momentum of a composite body for a unit value of one speed: a column of the mass matrix on its way inward.
#[derive(Clone, Copy, Debug)]
struct Column {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    body: BodyId,
    speed: SpeedId,
    /// The speed's coordinate among its body's: "theta1" to "s3".
    coordinate: &'static str,
    linear: Vector,
    /// About the current origin.
    angular: Vector,
}

/// `A`, Eq. (42), re-associated along the tree.
pub fn mass_matrix(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let frames = frames::frames(graph, tree);
    let mut composites = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        inertia::own(graph, tree.body(body))
    });
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut a = vec![vec![graph.zero(); tree.n_speeds]; tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut composite = composites[body];
        inertia::name(graph, &composite.inertia, "composite");
        graph.name_vector(composite.moment, "composite");
        let mut carried = std::mem::take(&mut columns[body]);
        for rotation in frames[body].rotations.iter().rev() {
            read_angle(graph, &mut a, body, rotation, &composite, &mut carried);
            composite = rotation.backward_composite(graph, &composite);
            for column in &mut carried {
                graph.enter(column.body);
                column.linear = rotation.backward(graph, column.linear);
                column.angular = rotation.backward(graph, column.angular);
            }
            graph.enter(body);
        }
        for (axis, s) in tree.body(body).joint.translations.iter().enumerate() {
            if let Some(speed) = s.speed() {
                read_translation(graph, &mut a, body, axis, speed, &composite, &mut carried);
            }
        }
        if let Some(lower) = tree.lower(body) {
            let offset = frames[body].offset;
            for column in &mut carried {
                graph.enter(column.body);
                let lever = graph.cross(offset, column.linear);
                column.angular = graph.add_vectors(column.angular, lever);
                name_column(graph, tree, lower, column);
            }
            graph.enter(body);
            let moved = composite.moved(graph, offset);
            graph.enter(lower);
            composites[lower] = composites[lower].plus(graph, &moved);
            columns[lower].extend(carried);
        }
    }
    a
}

/// The row of an angle, and its column: a rotation about an axis through the origin.
fn read_angle(
    graph: &mut ExprGraph,
    a: &mut SpeedMatrix,
    body: BodyId,
    rotation: &Rotation,
    composite: &Composite,
    carried: &mut Vec<Column>,
) {
    let Some(speed) = rotation.coordinate.speed() else {
        return;
    };
    let axis = rotation.axis.index();
    let unit = graph.unit_vector(axis);
    carried.push(Column {
        body,
        speed,
        coordinate: ["theta1", "theta2", "theta3"][axis],
        linear: graph.cross(unit, composite.moment),
        angular: composite.inertia.column(axis),
    });
    for column in carried {
        set(a, speed, column.speed, column.angular[axis]);
    }
}

/// The row of a translation, and its column.
fn read_translation(
    graph: &mut ExprGraph,
    a: &mut SpeedMatrix,
    body: BodyId,
    axis: usize,
    speed: SpeedId,
    composite: &Composite,
    carried: &mut Vec<Column>,
) {
    let unit = graph.unit_vector(axis);
    carried.push(Column {
        body,
        speed,
        coordinate: ["s1", "s2", "s3"][axis],
        linear: graph.scale(composite.mass, unit),
        angular: graph.cross(composite.moment, unit),
    });
    for column in carried {
        set(a, speed, column.speed, column.linear[axis]);
    }
}

/// Labels a column by its coordinate and the body at whose origin it has arrived.
fn name_column(graph: &mut ExprGraph, tree: &Tree, at: BodyId, column: &Column) {
    let at = &tree.body(at).identifier;
    graph.name_vector(column.linear, &format!("{}_f_{at}", column.coordinate));
    graph.name_vector(column.angular, &format!("{}_n_{at}", column.coordinate));
}

fn set(a: &mut SpeedMatrix, row: SpeedId, column: SpeedId, entry: Expr) {
    a[row.index()][column.index()] = entry;
    a[column.index()][row.index()] = entry;
}
