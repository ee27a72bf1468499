//! The root expressions of energies and momenta.

use crate::{
    expr::{Expr, ExprGraph},
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

pub(in crate::functions) fn kinetic_energy(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vec![kane::energy::kinetic(graph, tree)]
}

pub(in crate::functions) fn kinetic_energy_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    vec![recursive::totals::energy::kinetic(graph, tree, plan)]
}

pub(in crate::functions) fn potential_energy(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vec![kane::energy::potential(graph, tree)]
}

pub(in crate::functions) fn potential_energy_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    vec![recursive::totals::energy::potential(graph, tree, plan)]
}

pub(in crate::functions) fn linear_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::energy::linear_momentum(graph, tree).to_vec()
}

pub(in crate::functions) fn linear_momentum_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::totals::momentum::linear(graph, tree, plan).to_vec()
}

pub(in crate::functions) fn angular_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::energy::angular_momentum(graph, tree).to_vec()
}

pub(in crate::functions) fn angular_momentum_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::totals::momentum::angular(graph, tree, plan).to_vec()
}

pub(in crate::functions) fn kinetic_energies(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let energies = kane::energy::kinetic_by_body(graph, tree);
    energies.into_values().collect()
}

pub(in crate::functions) fn kinetic_energies_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let energies = recursive::totals::body_energies::kinetic_by_body(graph, tree, plan);
    energies.into_values().collect()
}

pub(in crate::functions) fn potential_energies(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let energies = kane::energy::potential_by_body(graph, tree);
    energies.into_values().collect()
}

pub(in crate::functions) fn potential_energies_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let energies = recursive::totals::body_energies::potential_by_body(graph, tree, plan);
    energies.into_values().collect()
}
