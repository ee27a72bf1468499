//! The root expressions of hybrid dynamics: accelerations of some joints are prescribed, forces of the others.

use super::dynamics::{applied, matrix, needed, with_forces};
use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::formulation::Way,
    given::{Accelerations, Loads},
    recursive::{Plan, accelerations::hybrid_dynamics as recursive},
    solve::{self, FreeSpeeds, Partitioned},
    tree::Tree,
};

pub(in crate::functions) fn hybrid_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let found = match way {
        Way::Notes => by_partitions(graph, tree),
        Way::Recursive(plan) => by_plan(graph, tree, plan),
    };
    whole(graph, tree, found)
}

fn by_partitions(graph: &mut ExprGraph, tree: &Tree) -> Partitioned {
    let given = Accelerations::GivenOf(&tree.prescribed);
    let needed = needed(graph, tree, Way::Notes, given, Loads::Absent);
    let a = matrix(graph, tree, Way::Notes);
    let tau = applied(graph, tree);
    let free = FreeSpeeds::new(graph, tree, a, &tree.prescribed);
    free.partitioned(graph, tree, tau, &needed)
}

fn by_plan(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Partitioned {
    let given = Accelerations::GivenOf(&tree.prescribed);
    let mut net = applied(graph, tree);
    let zero = vec![graph.zero(); net.len()];
    let taken = with_forces(graph, tree, Way::Recursive(plan), given, zero);
    solve::subtract(graph, tree, &mut net, &taken);
    let prescribed = &tree.prescribed;
    let mut found = recursive::hybrid_dynamics(graph, tree, plan, net, prescribed, Loads::Absent);
    let bodies = tree.speed_bodies();
    for speed in prescribed.iter().map(|speed| speed.index()) {
        graph.enter(bodies[speed]);
        found.forces[speed] = graph.add(found.forces[speed], taken[speed]);
    }
    found
}

/// All accelerations, then all forces: what was found among what is given.
pub(super) fn whole(graph: &mut ExprGraph, tree: &Tree, found: Partitioned) -> Vec<Expr> {
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
