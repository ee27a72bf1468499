//! The root expressions of hybrid dynamics: accelerations of some joints are prescribed, forces of the others.

use super::dynamics::{applied, matrix, with_forces};
use crate::{
    expr::{Expr, ExprGraph, Input},
    given::{Accelerations, Loads},
    kane::dynamics,
    recursive::{self, Plan},
    solve::{self, Partitioned},
    tree::Tree,
};

pub(in crate::functions) fn hybrid_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let given = Accelerations::GivenOf(&tree.prescribed);
    let needed = dynamics::inverse_dynamics(graph, tree, given);
    let needed = with_forces(graph, tree, None, given, needed);
    let a = matrix(graph, tree);
    let tau = applied(graph, tree);
    let found = solve::partitioned(graph, tree, a, &tree.prescribed, tau, &needed);
    whole(graph, tree, found)
}

pub(in crate::functions) fn hybrid_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let given = Accelerations::GivenOf(&tree.prescribed);
    let mut net = applied(graph, tree);
    let zero = vec![graph.zero(); net.len()];
    let taken = with_forces(graph, tree, Some(plan), given, zero);
    solve::subtract(graph, tree, &mut net, &taken);
    let solved = recursive::accelerations::hybrid_dynamics::hybrid_dynamics;
    let mut found = solved(graph, tree, plan, net, &tree.prescribed, Loads::Absent);
    let bodies = tree.speed_bodies();
    for speed in tree.prescribed.iter().map(|speed| speed.index()) {
        graph.enter(bodies[speed]);
        found.forces[speed] = graph.add(found.forces[speed], taken[speed]);
    }
    whole(graph, tree, found)
}

/// All accelerations, then all forces: what was found among what is given.
fn whole(graph: &mut ExprGraph, tree: &Tree, found: Partitioned) -> Vec<Expr> {
    let Partitioned {
        mut accelerations,
        mut forces,
    } = found;
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in tree.body(body).joint.speeds() {
            if tree.prescribed.contains(&speed) {
                accelerations[speed.index()] = graph.input(Input::UDot(speed));
            } else {
                forces[speed.index()] = graph.input(Input::Tau(speed));
            }
        }
    }
    [accelerations, forces].concat()
}
