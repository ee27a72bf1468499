//! Derivatives of dynamics, put together from composite bodies and from what acts in joints.

use super::{argument::Argument, derive, variable::Variable};
use crate::{
    differentiate::{Seeds, forward},
    expr::ExprGraph,
    given::{Accelerations, Loads},
    recursive::{Plan, derivatives},
    solve::SpeedMatrix,
    tree::Tree,
};

type Jacobians = Vec<(Argument, SpeedMatrix)>;

pub(super) fn inverse_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Jacobians {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Absent))
}

pub(super) fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Given))
}

pub(super) fn bias(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Jacobians {
    of_forces(graph, tree, plan, (Accelerations::Zero, Loads::Absent))
}

fn of_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (accelerations, loads): (Accelerations<'_>, Loads),
) -> Jacobians {
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, accelerations, loads);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    if accelerations == Accelerations::Given {
        all.push((Argument::UDot, found.by_u_dot));
    }
    add_mechanics(graph, tree, accelerations, &mut all);
    all
}

/// Adds how springs, dampers and rotors change.
fn add_mechanics(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
    all: &mut Jacobians,
) {
    let none = vec![graph.zero(); tree.n_speeds];
    let acting = derive::with_forces(graph, tree, accelerations, none);
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
