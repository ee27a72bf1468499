//! Derivatives of what an inertial measurement unit reads: along the frame's own axes those of an acceleration that the inertial frame has too,
//! upward, and of the angular velocity.

use super::{
    acceleration,
    columns::{by_rows, of_rows},
    moving::Twist,
    velocity,
};
use crate::{
    expr::{Expr, ExprGraph, Vector, negated},
    functions::{
        argument::Argument,
        formulation::Way,
        function::ByArguments,
        roots::{derivatives::swept::by_motions_or_swept, frames},
        subject::{Subject, View},
    },
    given::{self, Accelerations},
    recursive::{Plan, frame},
    solve::SpeedMatrix,
    tree::Tree,
};

/// By accelerations the Jacobian of the origin; the rest follows from the whole Jacobian.
pub(in crate::functions) fn imu(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let local = Subject {
        view: View::Local,
        ..subject.clone()
    };
    let jacobian = frames::jacobian(graph, tree, Way::Recursive(plan), &local);
    let (values, [by_q, by_u]) = by_motions_or_swept(
        graph,
        tree,
        [Argument::Q, Argument::U],
        |graph| frames::imu(graph, tree, Way::Recursive(plan), subject),
        |graph| {
            let upward = negated(given::gravity(graph, tree));
            let felt = frame::along_frame(graph, tree, plan, subject.frame(), upward);
            let columns = of_rows(&jacobian, tree.n_speeds);
            by_motions(graph, tree, &local, &columns, felt)
        },
    );
    let mut by_u_dot = by_rows(&jacobian, tree.n_speeds);
    by_u_dot[3..].fill(vec![graph.zero(); tree.n_speeds]);
    ByArguments {
        by: vec![
            (Argument::Q, by_q),
            (Argument::U, by_u),
            (Argument::UDot, by_u_dot),
        ],
        values: Some(values),
        mass: None,
    }
}

/// The readings, and by coordinates and by speeds, with the columns of the Jacobian; `felt` at rest.
fn by_motions(
    graph: &mut ExprGraph,
    tree: &Tree,
    local: &Subject,
    columns: &[Twist],
    felt: Vector,
) -> (Vec<Expr>, [SpeedMatrix; 2]) {
    let given = Accelerations::Given;
    let of_force = acceleration::by_motions(graph, tree, local, columns, (given, felt));
    let (angular, angular_by_q) = velocity::by_motions(graph, tree, local, columns);
    let angular_by_u = (3..6).map(|row| {
        let entries = columns.iter().map(|own| own.as_flattened()[row]);
        entries.collect()
    });
    let angular_by_u: SpeedMatrix = angular_by_u.collect();
    let (mut values, [mut by_q, mut by_u]) = of_force;
    values.splice(3.., angular[3..].iter().copied());
    by_q.splice(3.., angular_by_q[3..].iter().cloned());
    by_u.splice(3.., angular_by_u);
    (values, [by_q, by_u])
}
