//! Derivatives of forces, put together from composite bodies and from what acts in joints.

use super::swept::swept;
use crate::{
    differentiate::{Seeds, Sweep, forward},
    expr::ExprGraph,
    functions::{
        argument::Argument, formulation::Way, function::ByArguments, roots::dynamics,
        variable::Variable,
    },
    given::{Accelerations, Loads},
    recursive::{
        Plan,
        derivatives::{self, Wanted},
        totals::energy,
    },
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Absent))
}

pub(in crate::functions) fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Given))
}

pub(in crate::functions) fn bias(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> ByArguments {
    of_forces(graph, tree, plan, (Accelerations::Zero, Loads::Absent))
}

/// What is left of loads once bodies have what they need at zero accelerations.
pub(in crate::functions) fn forcing(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let mut needed = of_forces(graph, tree, plan, (Accelerations::Zero, Loads::Given));
    for (_, matrix) in &mut needed.by {
        for entry in matrix.iter_mut().flatten() {
            *entry = -*entry;
        }
    }
    needed
}

/// A system at rest without weight, whose rotors do not depend on coordinates.
pub(in crate::functions) fn mass_matrix_product(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let found = derivatives::of_mass_matrix_product(graph, tree, plan, Accelerations::Given);
    let mass = dynamics::with_rotors(graph, tree, found.by_u_dot);
    ByArguments {
        by: vec![(Argument::Q, found.by_q), (Argument::UDot, mass.clone())],
        values: None,
        mass: Some(mass),
    }
}

/// Weights have a potential: its second derivatives are symmetric but along turns about axes of one body, whose order matters.
pub(in crate::functions) fn gravity_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let potential = energy::of_weights(graph, tree, plan);
    let forces = swept(graph, tree, Argument::Q, Sweep::Reverse, &[potential]).concat();
    let mut by_q = swept(graph, tree, Argument::Q, Sweep::Forward, &forces);
    let kept = tree.order_dependent_turns();
    let pairs = (0..tree.n_speeds).flat_map(|row| (0..row).map(move |column| [row, column]));
    for [row, column] in pairs.filter(|pair| !kept.contains(pair)) {
        by_q[column][row] = by_q[row][column];
    }
    ByArguments {
        by: vec![(Argument::Q, by_q)],
        values: Some(forces),
        mass: None,
    }
}

fn of_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (accelerations, loads): (Accelerations<'_>, Loads),
) -> ByArguments {
    let found =
        derivatives::of_inverse_dynamics(graph, tree, plan, accelerations, loads, Wanted::ALL);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    let mass = if accelerations == Accelerations::Given {
        all.push((Argument::UDot, found.by_u_dot));
        add_mechanics(graph, tree, plan, accelerations, &mut all);
        all[2].1.clone()
    } else {
        add_mechanics(graph, tree, plan, accelerations, &mut all);
        dynamics::with_rotors(graph, tree, found.by_u_dot)
    };
    ByArguments {
        by: all,
        values: None,
        mass: Some(mass),
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
    let acting = dynamics::with_forces(graph, tree, Way::Recursive(plan), accelerations, none);
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
