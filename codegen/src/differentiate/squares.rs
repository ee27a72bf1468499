//! Squares: the derivative `2 a` has a factor that can be had for nothing.
//!
//! A root that changes by `r` with a square changes by `2 r a` with what is squared. Squares of angular velocity are added up,
//! and their sums meet constants; if these are doubled, a sweep has `2 r` without a product.

use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId};

/// For each node, whether it is a square or a sum of such nodes, and whatever needs it has it as a term of such a sum or times
/// something that is known before the loop.
pub(super) fn squares(graph: &ExprGraph, roots: &[Expr]) -> Vec<bool> {
    let needed = graph.reachable(roots);
    let ids: Vec<NodeId> = graph.ids().filter(|id| needed[id.index()]).collect();
    let mut found = vec![false; needed.len()];
    for &id in &ids {
        found[id.index()] = match graph.node(id) {
            Node::Mul(a, b) => a == b,
            Node::Add(a, b) => [a, b].iter().all(|term| found[term.node().index()]),
            _ => false,
        };
    }
    for root in roots {
        found[root.node().index()] = false;
    }
    // What is taken back may take back what it is a term of, and the other terms of that.
    let mut before = Vec::new();
    while before != found {
        before.clone_from(&found);
        for &id in ids.iter().rev() {
            let node = graph.node(id);
            let keeps = match node {
                Node::Mul(factor, _) => graph.binding(factor) != Binding::State,
                _ => found[id.index()],
            };
            let is_sum = matches!(node, Node::Add(..));
            if is_sum && !node.operands().all(|operand| found[operand.index()]) {
                found[id.index()] = false;
            }
            for operand in node.operands().filter(|_| !keeps) {
                found[operand.index()] = false;
            }
        }
    }
    found
}
