//! How an operation changes with its operands.

use crate::expr::{Expr, ExprGraph, Node, NodeId};

use super::turned::Turned;

/// Each operand among those that `vary`, and how much the node changes with it; of a component of what is turned the angle and
/// what is turned.
pub(super) fn partials(
    graph: &mut ExprGraph,
    id: NodeId,
    turned: Option<&Turned>,
    varies: impl Fn(NodeId) -> bool,
) -> Vec<(NodeId, Expr)> {
    let mut found = Vec::with_capacity(3);
    if let Some(turned) = turned.filter(|turned| turned.holds(&varies)) {
        found.push(turned.by_angle);
        found.extend(&turned.by_others);
        found.retain(|&(operand, _)| varies(operand));
        return found;
    }
    match graph.node(id) {
        Node::Number(_) | Node::Input(_) => {}
        Node::Sin(a) => found.push((a, graph.cos(Expr::of(a)))),
        Node::Cos(a) => found.push((a, -graph.sin(Expr::of(a)))),
        Node::Abs(a) => found.push((a, sign(graph, a))),
        Node::Add(a, b) => {
            let one = graph.one();
            found.extend([a, b].map(|term| (term.node(), one.signed(term.is_negative()))));
        }
        Node::Mul(a, b) if a == b => {
            let two = graph.number(2.0);
            found.push((a, graph.mul(two, Expr::of(a))));
        }
        Node::Mul(a, b) => found.extend([(a, Expr::of(b)), (b, Expr::of(a))]),
        Node::Div(a, b) => {
            let reciprocal = graph.reciprocal(Expr::of(b));
            found.push((a, reciprocal));
            if varies(b) {
                let slope = graph.mul(Expr::of(id), reciprocal);
                found.push((b, -slope));
            }
        }
    }
    found.retain(|&(operand, _)| varies(operand));
    found
}

/// `a / |a|`; zero where `a` is: what is added is not zero in single precision, and less than the rounding of sizes from `1e-22` on.
fn sign(graph: &mut ExprGraph, a: NodeId) -> Expr {
    let least = graph.number(f64::from(f32::MIN_POSITIVE));
    let size = graph.abs(Expr::of(a));
    let size = graph.add(size, least);
    graph.div(Expr::of(a), size)
}
