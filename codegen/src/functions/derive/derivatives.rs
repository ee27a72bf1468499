//! Derivatives of dynamics, put together from composite bodies and from what acts in joints.

use super::dynamics;
use crate::{
    differentiate::{Seeds, forward},
    expr::ExprGraph,
    functions::{argument::Argument, function::Told, variable::Variable},
    given::{Accelerations, Loads},
    recursive::{
        Plan,
        derivatives::{self, Wanted},
    },
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn of_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Absent))
}

pub(in crate::functions) fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Given))
}

pub(in crate::functions) fn bias(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Zero, Loads::Absent))
}

fn of_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (accelerations, loads): (Accelerations<'_>, Loads),
) -> Told {
    let found =
        derivatives::of_inverse_dynamics(graph, tree, plan, accelerations, loads, Wanted::ALL);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    if accelerations == Accelerations::Given {
        all.push((Argument::UDot, found.by_u_dot));
    }
    add_mechanics(graph, tree, plan, accelerations, &mut all);
    Told {
        by: all,
        values: None,
    }
}

/// Adds how springs, dampers, rotors and what lifts bodies change.
pub(super) fn add_mechanics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
    all: &mut [(Argument, SpeedMatrix)],
) {
    let none = vec![graph.zero(); tree.n_speeds];
    let acting = dynamics::with_forces(graph, tree, Some(plan), accelerations, none);
    let mut seeds = Seeds::new();
    for (place, (argument, _)) in all.iter().enumerate() {
        let first = place * tree.n_speeds;
        Variable::Given(*argument).seed(graph, tree, first, &mut seeds);
    }
    let rows = forward(graph, &acting, &seeds);
    for (row, entries) in rows.into_iter().enumerate() {
        for (place, entry) in entries {
            let (matrix, column) = (place / tree.n_speeds, place % tree.n_speeds);
            let sum = &mut all[matrix].1[row][column];
            *sum = graph.add(*sum, entry);
        }
    }
}
