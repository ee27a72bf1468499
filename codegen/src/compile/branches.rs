//! Whether branches that are alike go side by side.
//!
//! In: a function's expressions after all other passes. Out: its program. Does not: change a function that would not become a
//! good deal shorter.

use crate::{
    expr::{Expr, ExprGraph},
    functions::Argument,
    passes::branches,
    program::{self, Program},
    tree::Tree,
};

/// Shorter functions stay as they are: they are read line by line, and their machine code fits the first cache.
const SHORTEST: usize = 2_000;

/// The program of a function of these arguments: with branches side by side if it is long and a fifth of its text is saved.
pub(super) fn flattened(
    tree: &Tree,
    arguments: &[Argument],
    graph: &ExprGraph,
    roots: &[Expr],
) -> Program {
    let apart = program::flatten(graph, roots);
    if apart.written() < SHORTEST {
        return apart;
    }
    let Some((graph, roots)) = branches::run(tree, arguments, graph, roots) else {
        return apart;
    };
    let beside = program::flatten(&graph, &roots);
    if 5 * beside.written() <= 4 * apart.written() {
        beside
    } else {
        apart
    }
}
