//! Derivatives of dynamics, put together from composite bodies and from what acts in joints.

use super::{argument::Argument, derive, variable::Variable};
use crate::{
    differentiate::{Seeds, forward},
    expr::ExprGraph,
    given::{Accelerations, Loads},
    recursive::{Plan, derivatives, inverse_dynamics},
    solve::{self, Factors, SpeedMatrix},
    tree::Tree,
};

type Jacobians = Vec<(Argument, SpeedMatrix)>;

pub(super) fn of_inverse_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Jacobians {
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

pub(super) fn forward_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Jacobians {
    of_accelerations(graph, tree, plan, Loads::Absent)
}

pub(super) fn loaded_forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    of_accelerations(graph, tree, plan, Loads::Given)
}

/// By coordinates and speeds `-M^-1` times how the forces change at these accelerations; by forces `M^-1`.
fn of_accelerations(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    loads: Loads,
) -> Jacobians {
    let zero = Accelerations::Zero;
    // What is said of the mass matrix does not depend on accelerations, so that it is there for them.
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, zero, loads);
    let matrix = derive::with_rotors(graph, tree, found.by_u_dot);
    let factors = solve::factorise(graph, tree, matrix);
    let bias = match loads {
        Loads::Absent => inverse_dynamics::inverse_dynamics(graph, tree, plan, zero),
        Loads::Given => inverse_dynamics::loaded_inverse_dynamics(graph, tree, plan, zero),
    };
    let bias = derive::with_forces(graph, tree, zero, bias);
    let mut net = derive::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &bias);
    let u_dot = factors.solve(graph, net);
    let given = Accelerations::Values(&u_dot);
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, given, loads);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    add_mechanics(graph, tree, zero, &mut all);
    for (_, matrix) in &mut all {
        *matrix = solved(graph, &factors, matrix);
    }
    let inverse = factors.inverse(graph, tree);
    all.push((Argument::Tau, inverse));
    all
}

/// `-M^-1 X`, column by column.
fn solved(graph: &mut ExprGraph, factors: &Factors, matrix: &SpeedMatrix) -> SpeedMatrix {
    let columns = 0..matrix.len();
    let columns = columns.map(|column| {
        let needed = matrix.iter().map(|row| -row[column]);
        factors.solve(graph, needed.collect())
    });
    transposed(&columns.collect::<Vec<_>>())
}

fn transposed(matrix: &SpeedMatrix) -> SpeedMatrix {
    let columns = 0..matrix.len();
    let column = |column| matrix.iter().map(|row| row[column]).collect();
    columns.map(column).collect()
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
