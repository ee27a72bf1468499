//! The root expressions of energies by body.

use crate::{
    expr::{Expr, ExprGraph},
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

pub(super) fn kinetic_energies(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let energies = kane::energy::kinetic_by_body(graph, tree);
    energies.into_values().collect()
}

pub(super) fn kinetic_energies_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let energies = recursive::energy::kinetic_by_body(graph, tree, plan);
    energies.into_values().collect()
}

pub(super) fn potential_energies(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let energies = kane::energy::potential_by_body(graph, tree);
    energies.into_values().collect()
}

pub(super) fn potential_energies_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let energies = recursive::energy::potential_by_body(graph, tree, plan);
    energies.into_values().collect()
}
