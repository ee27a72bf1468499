//! Accelerations for given forces: the plan's solver on the plan's links, along the axes that it takes.

use super::{
    articulated, axes, composite, inverse_dynamics, link,
    plan::{Plan, Technique},
};
use crate::{
    expr::{Expr, ExprGraph},
    kane::{Accelerations, mechanics},
    solve,
    tree::Tree,
};

/// `u_dot` with `M u_dot + bias = tau`; `tau` is less what springs and dampers take.
pub fn forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    mut tau: Vec<Expr>,
) -> Vec<Expr> {
    let links = link::links(graph, tree, plan);
    let axes = axes::of_solution(tree, plan);
    axes::forces(graph, tree, &axes, &links, &mut tau);
    let falls = axes::falling(tree, plan);
    let mut solution = if plan.uses(Technique::Articulated) {
        articulated::solution(graph, tree, plan, (&links, &axes), &falls, &tau)
    } else {
        let zero = (Accelerations::Zero, &falls);
        let bias = inverse_dynamics::inertial_forces(graph, tree, plan, (&links, &axes), zero);
        let mut matrix = composite::matrix(graph, tree, plan, (&links, &axes));
        mechanics::add_rotors(graph, tree, &mut matrix);
        let factors = solve::factorise(graph, tree, matrix);
        solve::subtract(graph, tree, &mut tau, &bias);
        factors.solve(graph, tau)
    };
    axes::accelerations(graph, tree, &axes, &links, &falls, &mut solution);
    solution
}
