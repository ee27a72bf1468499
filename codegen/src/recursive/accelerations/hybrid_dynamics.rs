//! Accelerations of some speeds for given forces, and forces of the others for given accelerations: the plan's solver on the
//! plan's links, along the axes that it takes.

use std::collections::BTreeSet;

use super::{articulated, exchange};
use crate::{
    expr::{Expr, ExprGraph},
    given::{Accelerations, Loads},
    id::SpeedId,
    recursive::{
        forces::{inverse_dynamics, loaded},
        links::linkage::Linkage,
        matrices::composite,
        plan::Plan,
        technique::Technique,
    },
    solve::{FreeSpeeds, Partitioned},
    tree::Tree,
};

/// `u_dot` of the free speeds and `tau` of the prescribed ones with `M u_dot + bias = tau`, and the loads' generalized forces
/// beside `tau` where there are any; `tau` is less what springs, dampers and rotors of prescribed speeds take.
pub fn hybrid_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    mut tau: Vec<Expr>,
    prescribed: &BTreeSet<SpeedId>,
    loads: Loads,
) -> Partitioned {
    let linkage = Linkage::of_solution(graph, tree, plan, prescribed);
    exchange::forces(graph, &linkage, &mut tau);
    let mut solution = if plan.uses(Technique::Articulated) {
        let given = Accelerations::GivenOf(prescribed);
        let wrenches = loaded::needed(graph, &linkage, given, loads);
        articulated::solution(graph, &linkage, tau, prescribed, &wrenches)
    } else {
        let given = Accelerations::GivenOf(prescribed);
        let needed = inverse_dynamics::forces(graph, &linkage, given, loads);
        let matrix = composite::matrix_with_rotors(graph, &linkage);
        let free = FreeSpeeds::new(graph, tree, matrix, prescribed);
        free.partitioned(graph, tree, tau, &needed)
    };
    exchange::accelerations(graph, &linkage, &mut solution.accelerations);
    solution
}
