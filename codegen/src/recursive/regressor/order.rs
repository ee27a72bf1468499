//! The order of the text: columns one after the other, each from its body to the inertial frame, the motion of a body before its
//! first. A processor then holds the dozen numbers of one column, where those of all columns would wait in memory.

use crate::expr::{Expr, ExprGraph, NodeId, Rebuilt};

/// The entries of another graph, row after row of so many columns, in this graph.
pub(super) fn by_columns(
    graph: &mut ExprGraph,
    other: &ExprGraph,
    entries: &[Expr],
    n_columns: usize,
) -> Vec<Expr> {
    let mut rebuilt = Rebuilt::new(other);
    let mut copies = vec![graph.zero(); entries.len()];
    for column in 0..n_columns {
        for place in (column..entries.len()).step_by(n_columns) {
            let entry = entries[place];
            copy(graph, other, entry.node(), &mut rebuilt);
            copies[place] = rebuilt.expr(entry);
        }
    }
    copies
}

/// Copies a node after all that it needs and that is not there yet.
fn copy(graph: &mut ExprGraph, other: &ExprGraph, node: NodeId, rebuilt: &mut Rebuilt) {
    let mut pending = vec![node];
    while let Some(&id) = pending.last() {
        let mut operands = other.node(id).operands();
        if let Some(first) = operands.find(|operand| !rebuilt.has(*operand)) {
            pending.push(first);
            continue;
        }
        pending.pop();
        if !rebuilt.has(id) {
            graph.enter_like(other, id);
            let expr = rebuilt.copy(graph, other, id);
            graph.name_like(expr, other, id);
            rebuilt.set(id, expr);
        }
    }
}
