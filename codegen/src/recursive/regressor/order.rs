//! The order of the text: columns one after the other, each from its body to the inertial frame, the motion of a body before its
//! first. A processor then holds the dozen numbers of one column, where those of all columns would wait in memory.

use crate::expr::{Expr, ExprGraph, NodeId};

/// The entries of another graph, row after row of so many columns, in this graph.
pub(super) fn by_columns(
    graph: &mut ExprGraph,
    other: &ExprGraph,
    entries: &[Expr],
    n_columns: usize,
) -> Vec<Expr> {
    let mut copied: Vec<Option<Expr>> = vec![None; other.len()];
    let mut copies = vec![graph.zero(); entries.len()];
    for column in 0..n_columns {
        for place in (column..entries.len()).step_by(n_columns) {
            let entry = entries[place];
            let copy = copy(graph, other, entry.node(), &mut copied);
            copies[place] = copy.signed(entry.is_negative());
        }
    }
    copies
}

/// Copies a node after all that it needs and that is not there yet.
fn copy(
    graph: &mut ExprGraph,
    other: &ExprGraph,
    node: NodeId,
    copied: &mut [Option<Expr>],
) -> Expr {
    if let Some(copy) = copied[node.index()] {
        return copy;
    }
    let mut pending = vec![node];
    while let Some(&id) = pending.last() {
        let node = other.node(id);
        let mut operands = node.operands();
        if let Some(first) = operands.find(|operand| copied[operand.index()].is_none()) {
            pending.push(first);
            continue;
        }
        pending.pop();
        graph.enter_like(other, id);
        let operand =
            |id: NodeId| copied[id.index()].expect("regressor: operands are copied first");
        let expr = graph.copied(node, operand);
        graph.name_like(expr, other, id);
        copied[id.index()] = Some(expr);
    }
    copied[node.index()].expect("regressor: the node is copied last")
}
