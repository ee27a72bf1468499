//! The root expressions of regressors.

use crate::{
    expr::{Expr, ExprGraph},
    given::mechanics,
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

pub(super) fn regressor(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::regressor::regressor(graph, tree)
}

pub(super) fn regressor_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    recursive::regressor::regressor(graph, tree, plan)
}

pub(super) fn joint_regressor(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    mechanics::unit_forces(graph, tree).concat()
}
