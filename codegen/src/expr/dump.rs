//! A graph as text, for tests and for looking at what a derivation made.

use super::{Expr, ExprGraph, Node};

impl ExprGraph {
    /// One expression in infix notation, inputs by their `Debug` text.
    pub fn dump(&self, expr: Expr) -> String {
        let id = expr.node();
        let of = |node| self.dump(Expr::new(node, false));
        let text = match self.node(id) {
            Node::Number(bits) => format!("{:?}", f64::from_bits(bits)),
            Node::Input(input) => format!("{input:?}"),
            Node::Sin(a) => format!("sin({})", of(a)),
            Node::Cos(a) => format!("cos({})", of(a)),
            Node::Abs(a) => format!("|{}|", of(a)),
            Node::Add(a, b) if b.is_negative() => format!("({} - {})", self.dump(a), self.dump(-b)),
            Node::Add(a, b) => format!("({} + {})", self.dump(a), self.dump(b)),
            Node::Mul(a, b) => format!("{} * {}", of(a), of(b)),
            Node::Div(a, b) => format!("{} / ({})", of(a), of(b)),
        };
        if expr.is_negative() {
            format!("-{text}")
        } else {
            text
        }
    }
}
