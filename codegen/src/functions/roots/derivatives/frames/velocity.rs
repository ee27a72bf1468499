//! Derivatives of velocities of frames: a motion carries what motions farther out add, and moves the frame under those before it.

use super::{
    columns::{by_rows, of_rows},
    moving::{Moving, Twist, put, seen_from_frame},
};
use crate::{
    expr::{Expr, ExprGraph},
    functions::{
        argument::Argument,
        formulation::Way,
        function::ByArguments,
        roots::{derivatives::swept::by_motions_or_swept, frames},
        subject::{Subject, View},
    },
    given::Accelerations,
    recursive::Plan,
    solve::SpeedMatrix,
    tree::Tree,
};

/// By speeds the Jacobian, from which the rest follows.
pub(in crate::functions) fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let way = Way::Recursive(plan);
    let by_u = frames::jacobian(graph, tree, way, subject);
    let (values, [by_q]) = by_motions_or_swept(
        graph,
        tree,
        [Argument::Q],
        |graph| frames::velocity(graph, tree, way, subject),
        |graph| {
            let columns = of_rows(&by_u, tree.n_speeds);
            let (values, by_q) = by_motions(graph, tree, subject, &columns);
            (values, [by_q])
        },
    );
    let by_u = by_rows(&by_u, tree.n_speeds);
    ByArguments {
        by: vec![(Argument::Q, by_q), (Argument::U, by_u)],
        values: Some(values),
        mass: None,
    }
}

/// The velocity, and by coordinates, with the columns of the Jacobian.
pub(super) fn by_motions(
    graph: &mut ExprGraph,
    tree: &Tree,
    subject: &Subject,
    columns: &[Twist],
) -> (Vec<Expr>, SpeedMatrix) {
    let moving = Moving::new(graph, tree, subject, columns, Accelerations::Zero);
    let mut rows = vec![vec![graph.zero(); tree.n_speeds]; 6];
    for (place, group) in moving.groups.iter().enumerate() {
        let (before, after) = (moving.before[place].velocity, moving.after[place].velocity);
        for &speed in &group.speeds {
            let own = columns[speed.index()];
            let changes = if subject.view == View::Local {
                seen_from_frame(graph, own, before)
            } else {
                changed(graph, own, before, after)
            };
            put(&mut rows, speed.index(), changes);
        }
    }
    (moving.after[0].velocity.concat(), rows)
}

/// By a motion with this column, along inertial axes, with what motions before it and from it on add.
fn changed(graph: &mut ExprGraph, [v, w]: Twist, [_, w_before]: Twist, after: Twist) -> Twist {
    let (carried, moved) = (graph.cross(w, after[0]), graph.cross(w_before, v));
    [graph.add_vectors(carried, moved), graph.cross(w, after[1])]
}
