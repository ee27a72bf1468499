//! Derivatives of energies, momenta and the mass centre of the whole system: gradients of energies are forces and momenta; the others are
//! resultants.

use std::collections::BTreeMap;

use super::swept::swept;
use crate::{
    differentiate::Sweep,
    expr::{Expr, ExprGraph, Input, Vector},
    functions::{argument::Argument, formulation::Way, function::ByArguments, roots::matrices},
    given::mechanics,
    kane::center::Momentum,
    recursive::{
        Plan,
        derivatives::resultant::{self, Resultant},
        forces::gravity,
        totals::energy,
    },
    tree::Tree,
};

/// By coordinates what holds the system at rest against weight and springs.
pub(in crate::functions) fn potential_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let of_weights = gravity::gravity_forces(graph, tree, plan);
    let springs = mechanics::potential(graph, tree);
    let of_springs = swept(graph, tree, Argument::Q, Sweep::Reverse, &[springs]).concat();
    let gradient = of_weights.into_iter().zip(of_springs);
    let gradient = gradient.map(|(weight, spring)| graph.add(weight, spring));
    ByArguments {
        by: vec![(Argument::Q, vec![gradient.collect()])],
        ..ByArguments::default()
    }
}

/// By speeds the mass matrix times these.
pub(in crate::functions) fn kinetic_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let product = matrices::product(graph, tree, Way::Recursive(plan));
    let speeds: Vec<Expr> = Argument::U
        .inputs(tree)
        .map(|own| graph.input(own))
        .collect();
    let speeds: BTreeMap<Input, Expr> = Argument::UDot.inputs(tree).zip(speeds).collect();
    let by_u = graph.substituted(&product, &speeds);
    let energy = energy::kinetic(graph, tree, plan);
    ByArguments {
        by: vec![
            (
                Argument::Q,
                swept(graph, tree, Argument::Q, Sweep::Reverse, &[energy]),
            ),
            (Argument::U, vec![by_u]),
        ],
        ..ByArguments::default()
    }
}

pub(in crate::functions) fn linear_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_resultant(&resultant::of_momentum(graph, tree, plan), |own| {
        vec![own.linear]
    })
}

pub(in crate::functions) fn angular_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_resultant(&resultant::of_momentum(graph, tree, plan), |own| {
        vec![own.angular]
    })
}

pub(in crate::functions) fn momentum_rate(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_resultant(&resultant::of_momentum_rate(graph, tree, plan), |own| {
        vec![own.linear, own.angular]
    })
}

pub(in crate::functions) fn center_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_resultant(&resultant::of_center_velocity(graph, tree, plan), |own| {
        vec![own.linear]
    })
}

pub(in crate::functions) fn center_jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_resultant(
        &resultant::of_center_acceleration(graph, tree, plan),
        |own| vec![own.linear],
    )
}

/// Of parts of a resultant, a row for each component.
fn of_resultant(found: &Resultant, parts: fn(&Momentum) -> Vec<Vector>) -> ByArguments {
    let values = parts(&found.whole).concat();
    let matrix = |columns: &[Momentum]| {
        let columns: Vec<Vec<Expr>> = columns.iter().map(|own| parts(own).concat()).collect();
        let row = |row: usize| columns.iter().map(|column| column[row]).collect();
        (0..values.len()).map(row).collect()
    };
    ByArguments {
        by: vec![
            (Argument::Q, matrix(&found.by_q)),
            (Argument::U, matrix(&found.by_u)),
        ],
        values: Some(values),
        mass: None,
    }
}
