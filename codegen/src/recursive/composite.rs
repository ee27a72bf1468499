//! The mass matrix from composite bodies (Walker and Orin 1982): each body with all that it carries is one
//! rigid body, whose momentum for a unit speed is carried inward and read off at every speed that it passes.

use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::{BodyId, BodyMap},
    kane::dynamics::SpeedMatrix,
    recursive::{
        inertia::{self, Composite},
        link::Turning,
        linkage::Linkage,
        plan::Plan,
        rotation::Turn,
        shortcut::Shortcuts,
    },
    tree::{Motion, Tree},
};

/// Momentum of a composite body for a unit value of one speed: a column of the mass matrix on its way inward.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    pub(super) body: BodyId,
    motion: Motion,
    /// The speed's coordinate among its body's: "theta1" or "w1" to "s3".
    coordinate: &'static str,
    pub(super) linear: Vector,
    /// About the current origin.
    pub(super) angular: Vector,
    /// The linear part where its root's translations are read, once it is there; `linear` is then zero.
    pub(super) arrived: Option<Vector>,
}

/// `A`, Eq. (42), re-associated along the tree.
pub fn mass_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    matrix(graph, &linkage)
}

/// The same on links that are there.
pub(super) fn matrix(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> SpeedMatrix {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    let mut shortcuts = Shortcuts::new(graph, linkage);
    let mut composites = BodyMap::outward(tree.bodies.len(), |body, _| links[body].inertia);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut a = vec![vec![graph.zero(); tree.n_speeds]; tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut composite = composites[body];
        inertia::name(graph, &composite.inertia, "composite");
        graph.name_vector(composite.moment, "composite");
        let mut carried = std::mem::take(&mut columns[body]);
        let link = &links[body];
        let joint = &tree.body(body).joint;
        let names = joint.motion_names();
        let [turns, shifts] = axes[body].along_link(joint);
        // Inside a body the translations' columns are read first: they are the sparsest.
        for (axis, motion) in shifts.into_iter().flatten().enumerate() {
            let reading = Reading::shift(body, axis, Some(motion));
            reading.run(graph, &mut a, &composite, &mut carried);
        }
        for (axis, motion) in turns.into_iter().flatten().enumerate() {
            let reading = Reading::turn(body, axis, Some(motion), names[axis]);
            reading.run(graph, &mut a, &composite, &mut carried);
        }
        match &link.turning {
            Turning::Angles(rotations) => {
                for rotation in rotations.iter().rev() {
                    let axis = rotation.axis.index();
                    let motion = rotation.motion.filter(|_| turns.is_none());
                    let reading = Reading::turn(body, axis, motion, names[axis]);
                    reading.run(graph, &mut a, &composite, &mut carried);
                    if motion.is_some() {
                        shortcuts.take(graph, body, &mut carried);
                    }
                    composite = rotation.backward_composite(graph, &composite);
                    turn_columns(graph, &mut carried, rotation);
                    graph.enter(body);
                }
            }
            Turning::Matrix(matrix) => {
                composite = matrix.backward_composite(graph, &composite);
                turn_columns(graph, &mut carried, matrix);
                graph.enter(body);
            }
        }
        for (axis, motion) in joint.shifts().into_iter().enumerate() {
            let motion = motion.filter(|_| shifts.is_none());
            let reading = Reading::shift(body, axis, motion);
            reading.run(graph, &mut a, &composite, &mut carried);
        }
        composite = link.constant.backward_composite(graph, &composite);
        turn_columns(graph, &mut carried, &link.constant);
        graph.enter(body);
        if let Some(lower) = tree.lower(body) {
            for column in &mut carried {
                graph.enter(column.body);
                let lever = graph.cross(link.offset, column.linear);
                column.angular = graph.add_vectors(column.angular, lever);
                name_column(graph, tree, lower, column);
            }
            graph.enter(body);
            let moved = composite.moved(graph, link.offset);
            graph.enter(lower);
            composites[lower] = composites[lower].plus(graph, &moved);
            columns[lower].extend(carried);
        }
    }
    a
}

/// Turns the columns that are on their way inward.
fn turn_columns(graph: &mut ExprGraph, columns: &mut [Column], turn: &impl Turn) {
    for column in columns {
        graph.enter(column.body);
        column.linear = turn.backward(graph, column.linear);
        column.angular = turn.backward(graph, column.angular);
    }
}

/// Where a speed moves a composite body: its column begins here, and its row is read off all columns.
#[derive(Clone, Copy)]
struct Reading {
    body: BodyId,
    axis: usize,
    motion: Option<Motion>,
    coordinate: &'static str,
    is_turn: bool,
}

impl Reading {
    /// A rotation about an axis through the origin.
    fn turn(body: BodyId, axis: usize, motion: Option<Motion>, coordinate: &'static str) -> Self {
        Self {
            body,
            axis,
            motion,
            coordinate,
            is_turn: true,
        }
    }

    /// A translation along an axis.
    fn shift(body: BodyId, axis: usize, motion: Option<Motion>) -> Self {
        Self {
            body,
            axis,
            motion,
            coordinate: ["s1", "s2", "s3"][axis],
            is_turn: false,
        }
    }

    fn run(
        self,
        graph: &mut ExprGraph,
        a: &mut SpeedMatrix,
        composite: &Composite,
        carried: &mut Vec<Column>,
    ) {
        let Some(motion) = self.motion else {
            return;
        };
        let unit = graph.unit_vector(self.axis);
        let (linear, angular) = if self.is_turn {
            (
                graph.cross(unit, composite.moment),
                composite.inertia.column(self.axis),
            )
        } else {
            (
                graph.scale(composite.mass, unit),
                graph.cross(composite.moment, unit),
            )
        };
        carried.push(Column {
            body: self.body,
            motion,
            coordinate: self.coordinate,
            linear,
            angular,
            arrived: None,
        });
        let last = carried.len() - 1;
        for (place, column) in carried.iter().enumerate() {
            let momentum = if self.is_turn {
                column.angular
            } else {
                column.arrived.unwrap_or(column.linear)
            };
            let entry = momentum[self.axis];
            add(graph, a, motion, column.motion, entry, place == last);
        }
    }
}

/// Labels a column by its coordinate and the body at whose origin it has arrived.
fn name_column(graph: &mut ExprGraph, tree: &Tree, at: BodyId, column: &Column) {
    let at = &tree.body(at).identifier;
    graph.name_vector(column.linear, &format!("{}_f_{at}", column.coordinate));
    graph.name_vector(column.angular, &format!("{}_n_{at}", column.coordinate));
}

/// Adds an entry, and its mirror image where it is not on the diagonal of all motions.
fn add(
    graph: &mut ExprGraph,
    a: &mut SpeedMatrix,
    row: Motion,
    column: Motion,
    entry: Expr,
    is_diagonal: bool,
) {
    let factor = graph.number(row.factor * column.factor);
    let entry = graph.mul(factor, entry);
    let (row, column) = (row.speed.index(), column.speed.index());
    let mut sum = graph.add(a[row][column], entry);
    if row == column && !is_diagonal {
        // Two motions of one speed: the entry and its mirror image fall together.
        sum = graph.add(sum, entry);
    }
    a[row][column] = sum;
    a[column][row] = sum;
}
