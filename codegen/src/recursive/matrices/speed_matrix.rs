//! Entries of matrices over speeds, from those of motions: one speed may move several joints.

use crate::{
    expr::{Expr, ExprGraph},
    solve::SpeedMatrix,
    tree::Motion,
};

/// Adds an entry of two motions, row and column, to that of their speeds.
pub(in crate::recursive) fn add(
    graph: &mut ExprGraph,
    matrix: &mut SpeedMatrix,
    [row, column]: [Motion; 2],
    entry: Expr,
) {
    let factor = graph.number(row.factor * column.factor);
    let entry = graph.mul(factor, entry);
    let sum = &mut matrix[row.speed.index()][column.speed.index()];
    *sum = graph.add(*sum, entry);
}

/// The same of a symmetric matrix: with its mirror image, where it is not on the diagonal of all motions.
pub(in crate::recursive) fn add_mirrored(
    graph: &mut ExprGraph,
    matrix: &mut SpeedMatrix,
    motions: [Motion; 2],
    entry: Expr,
    is_diagonal: bool,
) {
    add(graph, matrix, motions, entry);
    let [row, column] = motions.map(|motion| motion.speed.index());
    if row == column && !is_diagonal {
        // Two motions of one speed: the entry and its mirror image fall together.
        add(graph, matrix, motions, entry);
    }
    matrix[column][row] = matrix[row][column];
}
