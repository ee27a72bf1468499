//! The meaning of a graph: its value at given inputs. Every pass is tested against it.

use std::collections::BTreeMap;

use super::{CallId, Expr, ExprGraph, Input, Node};
use crate::number::Number;

impl ExprGraph {
    /// The values of `roots` where `input` gives the inputs, in any kind of numbers.
    pub fn evaluate<N: Number>(&self, roots: &[Expr], mut input: impl FnMut(Input) -> N) -> Vec<N> {
        self.evaluate_by(roots, &mut input)
    }

    /// The same, which helpers of calls go through in turn.
    fn evaluate_by<N: Number>(&self, roots: &[Expr], input: &mut dyn FnMut(Input) -> N) -> Vec<N> {
        let needed = self.reachable(roots);
        let mut values = vec![N::constant(f64::NAN); self.len()];
        let mut called = BTreeMap::new();
        for id in self.ids().filter(|id| needed[id.index()]) {
            let of = |expr: Expr| signed(expr, values[expr.node().index()]);
            values[id.index()] = match self.node(id) {
                Node::Number(bits) => N::folded(self.rounded(id, f64::from_bits(bits))),
                Node::Input(Input::CallResult(result)) => {
                    let lanes = called
                        .entry(result.call)
                        .or_insert_with(|| self.evaluate_call(result.call, of));
                    lanes[usize::from(result.lane)][usize::from(result.place)]
                }
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

    /// What a call computes for each column, where its operands have these values.
    fn evaluate_call<N: Number>(
        &self,
        CallId { lockstep, call }: CallId,
        of: impl Fn(Expr) -> N,
    ) -> Vec<Vec<N>> {
        let lockstep = self.lockstep(lockstep);
        let call = &lockstep.calls[&call];
        let helper = &lockstep.helpers[call.helper];
        let lanes = (0..helper.lanes).map(|lane| {
            helper
                .graph
                .evaluate_by(&helper.roots, &mut |input| match input {
                    Input::Shared(place) => of(lockstep.shared[place]),
                    Input::Side(place) => of(call.sides[place][lane]),
                    other => unreachable!("expr: a helper is not given {other:?}"),
                })
        });
        lanes.collect()
    }
}

/// An expression's value, from its node's.
pub(crate) fn signed<N: Number>(expr: Expr, value: N) -> N {
    if expr.is_negative() { -value } else { value }
}
