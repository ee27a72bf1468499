//! The inverse of the mass matrix, and what it makes of forces: the plan's solver on a system at rest without weight.

use std::collections::BTreeSet;

use super::{articulated, carriers, exchange, gains};
use crate::{
    expr::{Expr, ExprGraph, LANES},
    given::Accelerations,
    id::SpeedId,
    recursive::{
        forces::product, links::linkage::Linkage, matrices::composite, plan::Plan,
        technique::Technique,
    },
    solve::{self, Carriers, Factors, FreeSpeeds, Inversion, Partitioned, SpeedMatrix},
    tree::Tree,
};

/// The `u_dot` with `M u_dot = tau`.
pub fn solution(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, tau: Vec<Expr>) -> Vec<Expr> {
    let none = vec![graph.zero(); tree.n_speeds];
    partition(graph, tree, plan, (tau, &none), &BTreeSet::new()).accelerations
}

/// The `u_dot` of the free speeds and the `tau` of the prescribed ones with `M u_dot = tau`, where `u_dot` of the prescribed ones is given; zero of
/// the others.
pub fn partition(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (mut tau, given): (Vec<Expr>, &[Expr]),
    prescribed: &BTreeSet<SpeedId>,
) -> Partitioned {
    let linkage = Linkage::of_solution_without_weight(graph, tree, plan, prescribed);
    exchange::forces(graph, &linkage, &mut tau);
    let mut solution = if plan.uses(Technique::Articulated) {
        let wrenches = product::needed(graph, &linkage, Accelerations::Values(given));
        articulated::solution(graph, &linkage, tau, prescribed, &wrenches)
    } else {
        let matrix = composite::matrix_with_rotors(graph, &linkage);
        let needed = solve::product(graph, &matrix, given);
        let free = FreeSpeeds::new(graph, tree, matrix, prescribed);
        free.partitioned(graph, tree, tau, &needed)
    };
    exchange::accelerations(graph, &linkage, &mut solution.accelerations);
    solution
}

/// `M^-1`.
pub fn inverse(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let linkage = Linkage::of_solution_without_weight(graph, tree, plan, &BTreeSet::new());
    let is_articulated = plan.uses(Technique::Articulated);
    let mut inverse = if is_articulated && !plan.uses(Technique::Carriers) {
        by_articulated_bodies(graph, &linkage)
    } else {
        let carriers = carriers::carriers(graph, &linkage);
        let factors = if is_articulated {
            gains::factors(graph, &linkage)
        } else {
            of_composite_bodies(graph, &linkage, &carriers)
        };
        let how = Inversion {
            carriers: &carriers,
            left_out: &[],
            // No lane stays empty.
            in_lockstep: plan.uses(Technique::Lockstep).then_some(LANES),
        };
        factors.inverse(graph, tree, how)
    };
    exchange::compliance(graph, &linkage, &mut inverse);
    inverse
}

/// `L^T D L` of the mass matrix, on floating trees through carriers.
fn of_composite_bodies(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    carriers: &Carriers,
) -> Factors {
    let matrix = composite::matrix_with_rotors(graph, linkage);
    solve::factorise_on_carriers(graph, linkage.tree, matrix, carriers)
}

/// Column by column, each the accelerations for a unit force. Of two entries that are the same that one is taken whose force
/// acts farther out: its column needs the accelerations on its own branch, and those of lower-numbered bodies.
fn by_articulated_bodies(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> SpeedMatrix {
    let order = solve::elimination(linkage.tree);
    let unit = |graph: &mut ExprGraph, speed: usize| {
        let mut tau = vec![graph.zero(); order.len()];
        tau[speed] = graph.one();
        tau
    };
    let forces: Vec<Vec<Expr>> = order.iter().map(|speed| unit(graph, *speed)).collect();
    let columns = articulated::solutions_at_rest(graph, linkage, &forces);
    let mut inverse = solve::zero_matrix(graph, order.len());
    for (place, (&own, column)) in order.iter().zip(&columns).enumerate() {
        for &other in &order[place..] {
            inverse[own][other] = column[other];
            inverse[other][own] = column[other];
        }
    }
    inverse
}
