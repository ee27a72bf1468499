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

/// Rows with a place for each speed.
fn dense(graph: &mut ExprGraph, tree: &Tree, rows: &[Row]) -> SpeedMatrix {
    let rows = rows.iter();
    rows.map(|row| entries(graph, row, 0..tree.n_speeds))
        .collect()
}
