//! The forces that are needed at no accelerations, of which derivatives by speeds hold a part.

use crate::{
    expr::{Expr, ExprGraph, Input, Purpose},
    given::Loads,
    id::BodyId,
    recursive::{
        Plan,
        forces::{gravity, inverse_dynamics},
    },
    solve::{self, SpeedMatrix},
    tree::Tree,
};

/// The forces that bodies need where no speed changes: weight, less what lifts and the loads, and what motion needs. That is
/// quadratic in the speeds: half of its derivatives by them, times the speeds.
pub(super) fn bias_of(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    loads: Loads,
    by_u: &SpeedMatrix,
) -> Vec<Expr> {
    let mut bias = gravity::gravity_forces_of_masses(graph, tree, plan);
    if loads == Loads::Given {
        let given = inverse_dynamics::generalized_forces(graph, tree, plan);
        solve::subtract(graph, tree, &mut bias, &given);
    }
    graph.begin(Purpose::Forces);
    let half = graph.number(0.5);
    let speeds = |body: BodyId| tree.body(body).joint.speeds().into_iter();
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in speeds(body) {
            let u = graph.input(Input::U(speed));
            let u = graph.mul(half, u);
            for (row, bias) in by_u.iter().zip(&mut bias) {
                let term = graph.mul(row[speed.index()], u);
                *bias = graph.add(*bias, term);
            }
        }
    }
    bias
}
