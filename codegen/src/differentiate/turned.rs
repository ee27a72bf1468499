//! Components of what is turned: they change with the angle by one another.
//!
//! With the sine `s` and the cosine `c` of one angle, the derivative of `x' = c x - s y` by the angle is `-y'`, and that of
//! `y' = s x + c y` is `x'`. A function that computes both needs no derivatives by sine and cosine. Of what is turned twice,
//! `s (k s)` and `c (k s)`, the derivatives are `2 c (k s)` and `k - 2 s (k s)`, where `k` is no variable itself.

use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId};

/// How a component changes with its angle and with what is turned.
#[derive(Clone, Debug)]
pub(super) struct Turned {
    /// The angle, and how the component changes with it.
    pub(super) by_angle: (NodeId, Expr),
    /// What is turned, with its sine or cosine.
    pub(super) by_others: Vec<(NodeId, Expr)>,
    /// The `k` of what is turned twice, which must not vary.
    constant: Option<NodeId>,
}

impl Turned {
    /// True where the component changes with its angle as this says.
    pub(super) fn holds(&self, varies: impl Fn(NodeId) -> bool) -> bool {
        varies(self.by_angle.0) && !self.constant.is_some_and(varies)
    }
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
pub(super) fn turned(graph: &mut ExprGraph, roots: &[Expr]) -> Vec<Option<Turned>> {
    let uses = graph.uses(roots);
    let components = graph.ids().map(|id| {
        let is_needed = uses[id.index()] > 0;
        let found = is_needed.then(|| twice(graph, &uses, id).or_else(|| once(graph, &uses, id)));
        found.flatten()
    });
    components.collect()
}

/// A component of a vector.
fn once(graph: &ExprGraph, uses: &[u32], id: NodeId) -> Option<Turned> {
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
    (uses[slope.node().index()] > 0).then(|| Turned {
        by_angle: (terms[0].angle, slope),
        by_others: others.collect(),
        constant: None,
    })
}

/// An entry of a tensor that has one constant entry before it is turned: `e (k f)` with a sine or cosine `e`, and one `f`. It
/// changes by `e' (k f) + e (k f')`, which is `2 e' (k f)`, more by `k` where `e` is a cosine and `f` is a sine, and less
/// by it the other way round.
fn twice(graph: &mut ExprGraph, uses: &[u32], id: NodeId) -> Option<Turned> {
    let outer = term(graph, Expr::of(id))?;
    let Node::Mul(constant, inner) = graph.node(outer.other) else {
        return None;
    };
    let [outer_node, inner_node] = [outer.entry.node(), inner].map(|entry| graph.node(entry));
    let constant_change = match (outer_node, inner_node) {
        (Node::Sin(a), Node::Sin(b)) | (Node::Cos(a), Node::Cos(b)) if a == b => None,
        (Node::Cos(a), Node::Sin(b)) if a == b => Some(Expr::of(constant)),
        (Node::Sin(a), Node::Cos(b)) if a == b => Some(-Expr::of(constant)),
        _ => return None,
    };
    let partner = graph.known_product(outer.changed, Expr::of(outer.other))?;
    if graph.binding(constant) == Binding::State || uses[partner.node().index()] == 0 {
        return None;
    }
    graph.enter(graph.scope(id));
    let mut slope = graph.add(partner, partner);
    if let Some(change) = constant_change {
        slope = graph.add(slope, change);
    }
    Some(Turned {
        by_angle: (outer.angle, slope),
        by_others: Vec::new(),
        constant: Some(constant),
    })
}

/// A product, as a sine or cosine times something.
fn term(graph: &ExprGraph, product: Expr) -> Option<Term> {
    let Node::Mul(a, b) = graph.node(product.node()) else {
        return None;
    };
    let turning = |factor: NodeId, other: NodeId| {
        let (angle, changed) = slope_of_entry(graph, factor)?;
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

/// The angle of a sine or cosine, and how it changes with that, where the function computes it.
pub(super) fn slope_of_entry(graph: &ExprGraph, entry: NodeId) -> Option<(NodeId, Expr)> {
    match graph.node(entry) {
        Node::Sin(angle) => Some((angle, graph.known_cos(Expr::of(angle))?)),
        Node::Cos(angle) => Some((angle, -graph.known_sin(Expr::of(angle))?)),
        _ => None,
    }
}
