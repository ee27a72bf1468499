//! Accelerations for given forces: the plan's solver on the plan's links, along the axes that it takes.

use std::collections::BTreeSet;

use super::hybrid_dynamics::hybrid_dynamics;
use crate::{
    expr::{Expr, ExprGraph},
    given::Loads,
    recursive::plan::Plan,
    tree::Tree,
};

/// `u_dot` with `M u_dot + bias = tau`, and the loads' generalized forces beside `tau` where there are any; `tau` is less what
/// springs and dampers take.
pub fn forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    tau: Vec<Expr>,
    loads: Loads,
) -> Vec<Expr> {
    hybrid_dynamics(graph, tree, plan, tau, &BTreeSet::new(), loads).accelerations
}
