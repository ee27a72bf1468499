//! Components of what is turned: they change with the angle by one another.
//!
//! With the sine `s` and the cosine `c` of one angle, the derivative of `x' = c x - s y` by the angle is `-y'`, and that of
//! `y' = s x + c y` is `x'`. A function that computes both needs no derivatives by sine and cosine.

use crate::expr::{Expr, ExprGraph, Node, NodeId};

/// How a component changes with its angle and with what is turned.
#[derive(Clone, Debug)]
pub(super) struct Turned {
    /// The angle, and how the component changes with it.
    pub(super) by_angle: (NodeId, Expr),
    /// What is turned, with its sine or cosine.
    pub(super) by_others: Vec<(NodeId, Expr)>,
}

/// A sine or cosine times something.
struct Term {
    angle: NodeId,
    /// The sine or cosine, with the sign of the term.
    entry: Expr,
    /// The same, changed with the angle.
    changed: Expr,
    other: NodeId,
}

/// For each node that `roots` need whether it is such a component, where the one by which it changes is needed too.
pub(super) fn turned(graph: &ExprGraph, roots: &[Expr]) -> Vec<Option<Turned>> {
    let uses = graph.uses(roots);
    let is_needed = |expr: &Expr| uses[expr.node().index()] > 0;
    let component = |id: NodeId| {
        let terms = match graph.node(id) {
            Node::Mul(..) => vec![term(graph, Expr::of(id))?],
            // What other sums have too is cheaper as a product of its own.
            Node::Add(a, b) if [a, b].iter().all(|own| uses[own.node().index()] == 1) => {
                vec![term(graph, a)?, term(graph, b)?]
            }
            _ => return None,
        };
        let mut changed = terms.iter();
        let product = |term: &Term| graph.known_product(term.changed, Expr::of(term.other));
        let mut slope = product(changed.next()?)?;
        for term in changed {
            if term.angle != terms[0].angle {
                return None;
            }
            slope = graph.known_sum(slope, product(term)?)?;
        }
        let others = terms.iter().map(|term| (term.other, term.entry));
        Some(slope).filter(is_needed).map(|slope| Turned {
            by_angle: (terms[0].angle, slope),
            by_others: others.collect(),
        })
    };
    let ids = graph.ids().map(|id| {
        let is_needed = uses[id.index()] > 0;
        is_needed.then(|| component(id)).flatten()
    });
    ids.collect()
}

/// A product, as a sine or cosine times something.
fn term(graph: &ExprGraph, product: Expr) -> Option<Term> {
    let Node::Mul(a, b) = graph.node(product.node()) else {
        return None;
    };
    let turning = |factor: NodeId, other: NodeId| {
        let (angle, changed) = match graph.node(factor) {
            Node::Sin(angle) => (angle, graph.known_cos(Expr::of(angle))?),
            Node::Cos(angle) => (angle, -graph.known_sin(Expr::of(angle))?),
            _ => return None,
        };
        let signed = |entry: Expr| entry.signed(product.is_negative());
        Some(Term {
            angle,
            entry: signed(Expr::of(factor)),
            changed: signed(changed),
            other,
        })
    };
    turning(a, b).or_else(|| turning(b, a))
}
