//! Accelerations for given forces: the plan's solver on the plan's links, along the axes that it takes.

use super::{
    articulated, composite, exchange, inverse_dynamics,
    linkage::Linkage,
    plan::{Plan, Technique},
};
use crate::{
    expr::{Expr, ExprGraph},
    given::{Accelerations, Loads, mechanics},
    solve,
    tree::Tree,
};

/// `u_dot` with `M u_dot + bias = tau`, and the loads' generalized forces beside `tau` where there are any; `tau` is less what
/// springs and dampers take.
pub fn forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    mut tau: Vec<Expr>,
    loads: Loads,
) -> Vec<Expr> {
    let linkage = Linkage::of_solution(graph, tree, plan);
    exchange::forces(graph, &linkage, &mut tau);
    let mut solution = if plan.uses(Technique::Articulated) {
        articulated::solution(graph, &linkage, tau, loads)
    } else {
        let bias = inverse_dynamics::forces(graph, &linkage, Accelerations::Zero, loads);
        let mut matrix = composite::matrix(graph, &linkage);
        mechanics::add_rotors(graph, tree, &mut matrix);
        let factors = solve::factorise(graph, tree, matrix);
        solve::subtract(graph, tree, &mut tau, &bias);
        factors.solve(graph, tau)
    };
    exchange::accelerations(graph, &linkage, &mut solution);
    solution
}
