//! Derivatives of the partial velocities of the mass centre: how each column changes by the motion of another one.

use super::{carrying, swept::swept};
use crate::{
    differentiate::Sweep,
    expr::{ExprGraph, Vector},
    functions::{argument::Argument, entries::Entries as _, function::ByArguments},
    recursive::{Plan, totals::momentum_matrix},
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let (by_q, entries) = if tree.has_followers() {
        let entries = momentum_matrix::center_jacobian(graph, tree, plan).entries();
        let by_q = swept(graph, tree, Argument::Q, Sweep::Forward, &entries);
        (by_q, entries)
    } else {
        let (by_q, columns) = by_motions(graph, tree, plan);
        (by_q, columns.entries())
    };
    ByArguments {
        by: vec![(Argument::Q, by_q)],
        values: Some(entries),
        mass: None,
    }
}

/// By coordinates, with the columns. A motion turns the columns of all motions whose axes it carries; of others on its path it moves what
/// they turn, so that of two motions the outer one's column is turned by the inner one, whichever changes.
fn by_motions(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> (SpeedMatrix, Vec<Vector>) {
    let [axes, columns] = momentum_matrix::center_jacobian_with_axes(graph, tree, plan);
    let rows = carrying::changes(graph, tree, 3, |graph, carrying, [own, by]| {
        let [inner, outer] = if carrying.carries(by, own) {
            [by, own]
        } else if carrying.carries(own, by) {
            [own, by]
        } else {
            return Vec::new();
        };
        graph
            .cross(axes[inner.index()], columns[outer.index()])
            .to_vec()
    });
    (rows, columns)
}
