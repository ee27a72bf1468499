//! The root expressions of the Coriolis matrix, and of the rate of the mass matrix.

use crate::{
    expr::{Expr, ExprGraph},
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

pub(super) fn coriolis_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::coriolis::coriolis_matrix(graph, tree).concat()
}

pub(super) fn coriolis_matrix_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::coriolis::coriolis_matrix(graph, tree, plan).concat()
}

pub(super) fn mass_matrix_dot(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::coriolis::mass_matrix_dot(graph, tree).concat()
}

pub(super) fn mass_matrix_dot_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::mass_matrix_dot::mass_matrix_dot(graph, tree, plan).concat()
}
