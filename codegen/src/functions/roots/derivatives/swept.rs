//! Derivatives by one argument that are swept for, where there is no shorter way to them.

use crate::{
    differentiate::{Row, Seeds, Sweep},
    expr::{Expr, ExprGraph},
    functions::{argument::Argument, derivatives::derivative::entries, variable::Variable},
    solve::SpeedMatrix,
    tree::Tree,
};

/// How values change by coordinates, speeds, or what else has an entry for each speed.
pub(super) fn swept(
    graph: &mut ExprGraph,
    tree: &Tree,
    argument: Argument,
    sweep: Sweep,
    values: &[Expr],
) -> SpeedMatrix {
    let mut seeds = Seeds::new();
    Variable::Given(argument).seed(graph, tree, 0, &mut seeds);
    let rows = sweep.rows(graph, values, &seeds);
    dense(graph, tree, &rows)
}

/// Values, and their derivatives by these arguments, from motion to motion; where a speed moves several joints, by sweeps over the values.
pub(super) fn by_motions_or_swept<const N: usize>(
    graph: &mut ExprGraph,
    tree: &Tree,
    by: [Argument; N],
    values: impl FnOnce(&mut ExprGraph) -> Vec<Expr>,
    by_motions: impl FnOnce(&mut ExprGraph) -> (Vec<Expr>, [SpeedMatrix; N]),
) -> (Vec<Expr>, [SpeedMatrix; N]) {
    if !tree.has_followers() {
        return by_motions(graph);
    }
    let values = values(graph);
    let by = by.map(|argument| swept(graph, tree, argument, Sweep::Forward, &values));
    (values, by)
}

/// Rows with a place for each speed.
fn dense(graph: &mut ExprGraph, tree: &Tree, rows: &[Row]) -> SpeedMatrix {
    let rows = rows.iter();
    rows.map(|row| entries(graph, row, 0..tree.n_speeds))
        .collect()
}
