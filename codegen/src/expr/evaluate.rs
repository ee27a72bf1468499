//! The meaning of a graph: its value at given inputs. Every pass is tested against it.

use super::{Expr, ExprGraph, Input, Node};

impl ExprGraph {
    /// The values of `roots` where `input` gives the inputs, in f64.
    ///
    /// Sines and cosines are the crate libm's, so the result is the same on every machine.
    pub fn evaluate(&self, roots: &[Expr], mut input: impl FnMut(Input) -> f64) -> Vec<f64> {
        let needed = self.reachable(roots);
        let mut values = vec![f64::NAN; self.len()];
        for id in self.ids().filter(|id| needed[id.index()]) {
            let signed = |expr: Expr| sign(expr) * values[expr.node().index()];
            values[id.index()] = match self.node(id) {
                Node::Number(bits) => f64::from_bits(bits),
                Node::Input(given) => input(given),
                Node::Sin(a) => libm::sin(values[a.index()]),
                Node::Cos(a) => libm::cos(values[a.index()]),
                Node::Abs(a) => values[a.index()].abs(),
                Node::Add(a, b) => signed(a) + signed(b),
                Node::Mul(a, b) => values[a.index()] * values[b.index()],
                Node::Div(a, b) => values[a.index()] / values[b.index()],
            };
        }
        roots
            .iter()
            .map(|&root| sign(root) * values[root.node().index()])
            .collect()
    }
}

fn sign(expr: Expr) -> f64 {
    if expr.is_negative() { -1.0 } else { 1.0 }
}
