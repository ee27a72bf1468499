//! Branches. Needs: no operation that depends on parameters alone. Afterwards: what branches of the tree that are alike go through
//! alike, such as the legs of a robot, is written once, as a helper that is run on all of them side by side. Keeps: the operations,
//! and the bits of every root but for the sign of a zero. Does not: ask whether that is worth it for the whole function.
//!
//! Branches are alike if their joints are: of the same kinds, joined in the same way. Whatever their bodies measure, most of what
//! is derived for one has its like in the others, operation by operation, with other numbers and perhaps with other signs.

mod alike;
mod calls;
mod givens;
mod groups;
mod layers;
mod signs;
mod traced;
mod write;

use self::{alike::Branches, calls::Calls, givens::Givens, groups::Groups, traced::Traced};
use crate::{
    expr::{Expr, ExprGraph},
    functions::Argument,
    tree::Tree,
};

/// The graph of a function of these arguments with what is alike side by side, and its roots; `None` if nothing is.
pub fn run(
    tree: &Tree,
    arguments: &[Argument],
    graph: &ExprGraph,
    roots: &[Expr],
) -> Option<(ExprGraph, Vec<Expr>)> {
    let branches = Branches::of(tree);
    if branches.is_empty() {
        return None;
    }
    let givens = Givens::of(tree, &branches, arguments);
    let traced = Traced::of(&branches, &givens, graph, roots);
    let mut groups = Groups::of(&branches, graph, &traced);
    let calls = Calls::of(graph, roots, &mut groups);
    let is_any = !calls.groups.is_empty() && calls.have_numbers(graph);
    is_any.then(|| write::rewritten(graph, roots, &groups, &calls))
}
