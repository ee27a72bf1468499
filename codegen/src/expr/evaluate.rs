//! The meaning of a graph: its value at given inputs. Every pass is tested against it.

use super::{Expr, ExprGraph, Input, Node};
use crate::number::Number;

impl ExprGraph {
    /// The values of `roots` where `input` gives the inputs, in any kind of numbers.
    pub fn evaluate<N: Number>(&self, roots: &[Expr], mut input: impl FnMut(Input) -> N) -> Vec<N> {
        let needed = self.reachable(roots);
        let mut values = vec![N::constant(f64::NAN); self.len()];
        for id in self.ids().filter(|id| needed[id.index()]) {
            let of = |expr: Expr| signed(expr, values[expr.node().index()]);
            values[id.index()] = match self.node(id) {
                Node::Number(bits) => N::folded(self.rounded(id, f64::from_bits(bits))),
                Node::Input(given) => input(given),
                Node::Sin(a) => values[a.index()].sin_cos().0,
                Node::Cos(a) => values[a.index()].sin_cos().1,
                Node::Abs(a) => values[a.index()].abs(),
                Node::Add(a, b) => of(a) + of(b),
                Node::Mul(a, b) => values[a.index()] * values[b.index()],
                Node::Div(a, b) => values[a.index()] / values[b.index()],
            };
        }
        roots
            .iter()
            .map(|&root| signed(root, values[root.node().index()]))
            .collect()
    }
}

/// An expression's value, from its node's.
pub(crate) fn signed<N: Number>(expr: Expr, value: N) -> N {
    if expr.is_negative() { -value } else { value }
}
