//! Branches. Needs: no operation that depends on parameters alone. Afterwards: what branches of the tree that are alike go through
//! alike, such as the legs of a robot, is written once, as a helper that is run on all of them side by side. Keeps: the operations,
//! and the bits of every root but for the sign of a zero. Does not: change a function that would not become a good deal shorter.
//!
//! Branches are alike if their joints are: of the same kinds, joined in the same way. Whatever their bodies measure, most of what
//! is derived for one has its like in the others, operation by operation, with other numbers and perhaps with other signs.

mod alike;
mod calls;
mod groups;
mod layers;
mod signs;
mod traced;
mod write;

use self::{alike::Branches, calls::Calls, groups::Groups, traced::Traced};
use crate::{
    expr::{Binding, Expr, ExprGraph, Node, NodeId},
    tree::Tree,
};

/// Shorter functions stay as they are: they are read line by line, and their machine code fits the first cache.
const SHORTEST: usize = 2_000;

/// The graph with what is alike side by side, and its roots.
pub fn run(tree: &Tree, graph: ExprGraph, roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    let n_operations = written(&graph, &roots);
    if n_operations < SHORTEST {
        return (graph, roots);
    }
    let (packed, new_roots) = side_by_side(tree, graph.clone(), roots.clone());
    // A fifth fewer outside of helpers at least.
    if 5 * written(&packed, &new_roots) <= 4 * n_operations {
        (packed, new_roots)
    } else {
        (graph, roots)
    }
}

/// The same, however long it is.
pub fn side_by_side(
    tree: &Tree,
    mut graph: ExprGraph,
    mut roots: Vec<Expr>,
) -> (ExprGraph, Vec<Expr>) {
    for branches in Branches::of(tree) {
        let traced = Traced::of(tree, &branches, &graph, &roots);
        let mut groups = Groups::of(&branches, &graph, &traced);
        let calls = Calls::of(&graph, &roots, &mut groups);
        if !calls.groups.is_empty() {
            (graph, roots) = write::written(&graph, &roots, &groups, &calls);
        }
    }
    (graph, roots)
}

/// How many operations of a graph its text would have, without those of helpers.
fn written(graph: &ExprGraph, roots: &[Expr]) -> usize {
    let needed = graph.reachable(roots);
    let is_operation = |id: &NodeId| {
        let is_leaf = matches!(graph.node(*id), Node::Number(_) | Node::Input(_));
        needed[id.index()] && !is_leaf && graph.binding(*id) == Binding::State
    };
    graph.ids().filter(is_operation).count()
}
