//! The root expressions of coordinates and their rates.

use crate::{
    expr::{Expr, ExprGraph},
    kane::{angular, dynamics, orientation},
    tree::Tree,
};

pub(in crate::functions) fn angle_rates(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rates = angular::angle_rates(graph, tree);
    rates.into_values().flatten().collect()
}

pub(in crate::functions) fn q_dot(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    angular::coordinate_rates(graph, tree)
}

pub(in crate::functions) fn normalize(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    orientation::normalized(graph, tree)
}

pub(in crate::functions) fn singularity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    tree.body_ids()
        .map(|body| dynamics::singularity(graph, tree, body))
        .collect()
}
