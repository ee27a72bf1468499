//! The root expressions of the Coriolis matrix, and of the rate of the mass matrix.

use crate::{
    expr::{Expr, ExprGraph},
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

pub(in crate::functions) fn coriolis_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::coriolis::coriolis_matrix(graph, tree).concat()
}

pub(in crate::functions) fn coriolis_matrix_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::matrices::coriolis::coriolis_matrix(graph, tree, plan).concat()
}

pub(in crate::functions) fn mass_matrix_dot(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::coriolis::mass_matrix_dot(graph, tree).concat()
}

pub(in crate::functions) fn mass_matrix_dot_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::matrices::mass_matrix_dot::mass_matrix_dot(graph, tree, plan).concat()
}
