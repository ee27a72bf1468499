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
    let mut sums_with: Vec<Vec<NodeId>> = vec![Vec::new(); needed.len()];
    let mut open: Vec<NodeId> = roots.iter().map(|root| root.node()).collect();
    for &id in &ids {
        let node = graph.node(id);
        let keeps = match node {
            Node::Mul(factor, _) => graph.binding(factor) != Binding::State,
            _ => found[id.index()],
        };
        if !keeps {
            open.extend(node.operands());
        } else if let Node::Add(a, b) = node {
            for term in [a, b] {
                sums_with[term.node().index()].push(id);
            }
        }
    }
    // What is taken back takes back what it is a term of, and, where it is a sum, its own terms.
    while let Some(id) = open.pop() {
        if !std::mem::take(&mut found[id.index()]) {
            continue;
        }
        open.append(&mut sums_with[id.index()]);
        let node = graph.node(id);
        if matches!(node, Node::Add(..)) {
            open.extend(node.operands());
        }
    }
    found
}
