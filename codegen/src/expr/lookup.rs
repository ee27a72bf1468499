//! Nodes that are in the graph already; nothing is built.

use super::{Expr, ExprGraph, Node};

impl ExprGraph {
    fn known(&self, node: Node) -> Option<Expr> {
        self.nodes.find(&node).ok().map(Expr::of)
    }

    /// `sin(a)`, if it is there.
    pub fn known_sin(&self, a: Expr) -> Option<Expr> {
        let sine = self.known(Node::Sin(a.node()))?;
        Some(sine.signed(a.is_negative()))
    }

    /// `cos(a)`, if it is there.
    pub fn known_cos(&self, a: Expr) -> Option<Expr> {
        self.known(Node::Cos(a.node()))
    }

    /// `a b`, if it is there as a product.
    pub fn known_product(&self, a: Expr, b: Expr) -> Option<Expr> {
        let negative = a.is_negative() ^ b.is_negative();
        let (a, b) = (a.node(), b.node());
        let product = self.known(Node::Mul(a, b));
        let product = product.or_else(|| self.known(Node::Mul(b, a)))?;
        Some(product.signed(negative))
    }

    /// `a + b`, if it is there as a sum.
    pub fn known_sum(&self, a: Expr, b: Expr) -> Option<Expr> {
        let (first, second) = if a.node() < b.node() { (a, b) } else { (b, a) };
        let negative = first.is_negative();
        let sum = Node::Add(first.signed(negative), second.signed(negative));
        Some(self.known(sum)?.signed(negative))
    }
}
