//! Derivatives of Jacobians of frames: how each column changes by the motion of another one.

use super::moving::{Twist, seen_from_frame};
use crate::{
    differentiate::Sweep,
    expr::{Expr, ExprGraph, Vector},
    functions::{
        argument::Argument,
        formulation::Way,
        function::ByArguments,
        roots::{
            derivatives::{carrying::Carrying, swept::swept},
            frames,
        },
        subject::{Subject, View},
    },
    id::SpeedId,
    recursive::Plan,
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let entries = frames::jacobian(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &all(tree), entries)
}

pub(in crate::functions) fn jacobian_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let entries = frames::jacobian_packed(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &subject.speeds(tree), entries)
}

pub(in crate::functions) fn point_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let entries = frames::point_jacobian(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &all(tree), entries)
}

fn all(tree: &Tree) -> Vec<SpeedId> {
    (0..tree.n_speeds).map(SpeedId::new).collect()
}

/// How the columns of these speeds change, entries by rows: with a motion that carries their axis they turn as a whole; by others the axis
/// stays, and the frame moves. Along the frame's own axes what turns as a whole does not change.
fn of_columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    subject: &Subject,
    speeds: &[SpeedId],
    entries: Vec<Expr>,
) -> ByArguments {
    let by_q = if subject.view == View::Other || tree.has_followers() {
        swept(graph, tree, Argument::Q, Sweep::Forward, &entries)
    } else {
        let n = speeds.len();
        let columns = of_rows(&entries, n);
        let carrying = Carrying::new(tree);
        let mut rows = vec![vec![graph.zero(); tree.n_speeds]; entries.len()];
        for (place, &speed) in speeds.iter().enumerate() {
            for (by, &cause) in speeds.iter().enumerate() {
                let is_carried = carrying.carries(cause, speed);
                let (own, other) = (columns[place], columns[by]);
                let changes = match (subject.view == View::Local, is_carried) {
                    (true, true) => continue,
                    (true, false) => seen_from_frame(graph, other, own),
                    (false, _) => changed(graph, own, other, is_carried),
                };
                for (i, &entry) in changes.as_flattened().iter().enumerate() {
                    rows[i * n + place][cause.index()] = entry;
                }
            }
        }
        rows
    };
    ByArguments {
        by: vec![(Argument::Q, by_q)],
        values: Some(entries),
        mass: None,
    }
}

/// How a column, linear and angular, changes by the motion of another one, along axes that do not turn.
fn changed(graph: &mut ExprGraph, [v, w]: Twist, [v_by, w_by]: Twist, is_carried: bool) -> Twist {
    if is_carried {
        [graph.cross(w_by, v), graph.cross(w_by, w)]
    } else {
        [graph.cross(w, v_by), graph.zero_vector()]
    }
}

/// The columns of a Jacobian, linear and angular, of its entries by rows.
pub(super) fn of_rows(entries: &[Expr], n_columns: usize) -> Vec<Twist> {
    let vector = |first: usize, column: usize| -> Vector {
        std::array::from_fn(|i| entries[(first + i) * n_columns + column])
    };
    let columns = 0..n_columns;
    columns
        .map(|column| [vector(0, column), vector(3, column)])
        .collect()
}

/// The rows of a matrix of its entries.
pub(super) fn by_rows(entries: &[Expr], n_columns: usize) -> SpeedMatrix {
    entries.chunks(n_columns).map(<[Expr]>::to_vec).collect()
}
