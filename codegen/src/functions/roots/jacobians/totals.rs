//! Derivatives of energies and momenta of the whole system: gradients are forces and momenta, which have recursions of their own.

use std::collections::BTreeMap;

use super::swept::swept;
use crate::{
    differentiate::Sweep,
    expr::{Expr, ExprGraph, Input, Vector},
    functions::{argument::Argument, formulation::Way, function::Jacobians, roots::matrices},
    given::mechanics,
    kane::center::Momentum,
    recursive::{
        Plan,
        forces::gravity,
        totals::{energy, momentum, momentum_matrix},
    },
    tree::Tree,
};

/// By coordinates what holds the system at rest against weight and springs.
pub(in crate::functions) fn potential_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let of_weights = gravity::gravity_forces(graph, tree, plan);
    let springs = mechanics::potential(graph, tree);
    let of_springs = swept(graph, tree, Argument::Q, Sweep::Reverse, &[springs]).concat();
    let gradient = of_weights.into_iter().zip(of_springs);
    let gradient = gradient.map(|(weight, spring)| graph.add(weight, spring));
    Jacobians {
        by: vec![(Argument::Q, vec![gradient.collect()])],
        ..Jacobians::default()
    }
}

/// By speeds the mass matrix times these.
pub(in crate::functions) fn kinetic_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let product = matrices::product(graph, tree, Way::Recursive(plan));
    let speeds: Vec<Expr> = Argument::U
        .inputs(tree)
        .map(|own| graph.input(own))
        .collect();
    let speeds: BTreeMap<Input, Expr> = Argument::UDot.inputs(tree).zip(speeds).collect();
    let by_u = graph.substituted(&product, &speeds);
    let energy = energy::kinetic(graph, tree, plan);
    Jacobians {
        by: vec![
            (
                Argument::Q,
                swept(graph, tree, Argument::Q, Sweep::Reverse, &[energy]),
            ),
            (Argument::U, vec![by_u]),
        ],
        ..Jacobians::default()
    }
}

pub(in crate::functions) fn linear_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let momentum = momentum::linear(graph, tree, plan);
    of_momentum(graph, tree, plan, momentum, |own| own.linear)
}

pub(in crate::functions) fn angular_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let momentum = momentum::angular(graph, tree, plan);
    of_momentum(graph, tree, plan, momentum, |own| own.angular)
}

/// By speeds the columns of the momentum matrix.
fn of_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    momentum: Vector,
    part: fn(&Momentum) -> Vector,
) -> Jacobians {
    let columns = momentum_matrix::about_origin(graph, tree, plan);
    let row = |axis: usize| columns.iter().map(|own| part(own)[axis]).collect();
    let by_u = (0..3).map(row).collect();
    Jacobians {
        by: vec![
            (
                Argument::Q,
                swept(graph, tree, Argument::Q, Sweep::Forward, &momentum),
            ),
            (Argument::U, by_u),
        ],
        values: Some(momentum.to_vec()),
        mass: None,
    }
}
