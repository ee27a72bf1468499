//! Derivatives of the partial velocities of the mass centre: how each column changes by the motion of another one.

use super::{carrying, swept::by_motions_or_swept};
use crate::{
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
    let (entries, [by_q]) = by_motions_or_swept(
        graph,
        tree,
        [Argument::Q],
        |graph| momentum_matrix::center_jacobian(graph, tree, plan).entries(),
        |graph| {
            let (by_q, columns) = by_motions(graph, tree, plan);
            (columns.entries(), [by_q])
        },
    );
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
