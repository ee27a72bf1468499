//! The root expressions of energies and momenta.

use crate::{
    expr::{Expr, ExprGraph},
    functions::formulation::Way,
    kane::energy as notes,
    recursive::totals::{body_energies, energy, momentum},
    tree::Tree,
};

pub(in crate::functions) fn kinetic_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    vec![match way {
        Way::Notes => notes::kinetic(graph, tree),
        Way::Recursive(plan) => energy::kinetic(graph, tree, plan),
    }]
}

pub(in crate::functions) fn potential_energy(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    vec![match way {
        Way::Notes => notes::potential(graph, tree),
        Way::Recursive(plan) => energy::potential(graph, tree, plan),
    }]
}

pub(in crate::functions) fn linear_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let momentum = match way {
        Way::Notes => notes::linear_momentum(graph, tree),
        Way::Recursive(plan) => momentum::linear(graph, tree, plan),
    };
    momentum.to_vec()
}

pub(in crate::functions) fn angular_momentum(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let momentum = match way {
        Way::Notes => notes::angular_momentum(graph, tree),
        Way::Recursive(plan) => momentum::angular(graph, tree, plan),
    };
    momentum.to_vec()
}

pub(in crate::functions) fn kinetic_energies(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let energies = match way {
        Way::Notes => notes::kinetic_by_body(graph, tree),
        Way::Recursive(plan) => body_energies::kinetic_by_body(graph, tree, plan),
    };
    energies.into_values().collect()
}

pub(in crate::functions) fn potential_energies(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let energies = match way {
        Way::Notes => notes::potential_by_body(graph, tree),
        Way::Recursive(plan) => body_energies::potential_by_body(graph, tree, plan),
    };
    energies.into_values().collect()
}
