//! Whether branches that are alike go side by side.
//!
//! In: a function's expressions after all other passes but `reuse`. Out: these, with what is alike in helpers, or as they are. Does not: change a function that would not become a
//! good deal shorter.

use crate::{
    expr::{Expr, ExprGraph},
    functions::Argument,
    passes::branches,
    program,
    tree::Tree,
};

/// Shorter functions stay as they are: they are read line by line, and their machine code fits the first cache.
const SHORTEST: usize = 2_000;

/// The expressions of a function of these arguments: with branches side by side if it is long and a fifth of its text is saved.
pub(super) fn arranged(
    tree: &Tree,
    arguments: &[Argument],
    graph: ExprGraph,
    roots: Vec<Expr>,
) -> (ExprGraph, Vec<Expr>) {
    let apart = program::flatten(&graph, &roots).written();
    if apart < SHORTEST {
        return (graph, roots);
    }
    let beside = branches::run(tree, arguments, &graph, &roots);
    let beside =
        beside.filter(|(graph, roots)| 5 * program::flatten(graph, roots).written() <= 4 * apart);
    beside.unwrap_or((graph, roots))
}
