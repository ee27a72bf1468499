//! How the values of roots change with variables, in numbers.

use std::collections::BTreeMap;

use super::row::merged;
use crate::{
    expr::{Expr, ExprGraph, Input, Node, NodeId, signed},
    number::Number,
};

/// Entries by their places, which ascend; what is not there is zero.
type Numbers<N> = Vec<(usize, N)>;

/// How the value of each root changes with every variable, where inputs have these values and change so.
pub fn tangents<N: Number + PartialEq>(
    graph: &ExprGraph,
    roots: &[Expr],
    input: impl FnMut(Input) -> N,
    seeds: &BTreeMap<Input, Numbers<N>>,
) -> Vec<Numbers<N>> {
    let needed = graph.reachable(roots);
    let needed: Vec<NodeId> = graph.ids().filter(|id| needed[id.index()]).collect();
    let nodes: Vec<Expr> = needed.iter().copied().map(Expr::of).collect();
    let mut values = vec![N::constant(f64::NAN); graph.len()];
    for (id, value) in needed.iter().zip(graph.evaluate(&nodes, input)) {
        values[id.index()] = value;
    }
    let mut rows: Vec<Numbers<N>> = vec![Vec::new(); graph.len()];
    for id in needed {
        rows[id.index()] = if let Node::Input(given) = graph.node(id) {
            seeds.get(&given).cloned().unwrap_or_default()
        } else {
            let slopes = slopes(graph.node(id), values[id.index()], &values);
            let slopes = slopes.into_iter().flatten();
            let slopes = slopes.filter(|(operand, _)| !rows[operand.index()].is_empty());
            slopes.fold(Vec::new(), |sum, (operand, slope)| {
                added(sum, &rows[operand.index()], slope)
            })
        };
    }
    let signed_row = |root: &Expr| {
        let row = rows[root.node().index()].iter();
        row.map(|&(place, entry)| (place, signed(*root, entry)))
            .collect()
    };
    roots.iter().map(signed_row).collect()
}

/// How a node with this value changes with each of its operands.
fn slopes<N: Number>(node: Node, value: N, values: &[N]) -> [Option<(NodeId, N)>; 2] {
    let one = N::constant(1.0);
    match node {
        Node::Number(_) | Node::Input(_) => [None; 2],
        Node::Sin(a) => {
            let (_, cos) = values[a.index()].sin_cos();
            [Some((a, cos)), None]
        }
        Node::Cos(a) => {
            let (sin, _) = values[a.index()].sin_cos();
            [Some((a, -sin)), None]
        }
        Node::Abs(a) => [Some((a, values[a.index()] / value)), None],
        Node::Add(a, b) => [a, b].map(|term| Some((term.node(), signed(term, one)))),
        Node::Mul(a, b) => [Some((a, values[b.index()])), Some((b, values[a.index()]))],
        Node::Div(a, b) => {
            let reciprocal = one / values[b.index()];
            [Some((a, reciprocal)), Some((b, -(value * reciprocal)))]
        }
    }
}

/// The sum of a row and another one times a factor; what becomes zero is left out.
fn added<N: Number + PartialEq>(sum: Numbers<N>, other: &Numbers<N>, factor: N) -> Numbers<N> {
    let terms = other.iter().map(|&(place, entry)| (place, entry * factor));
    let mut sum = merged(sum, terms.collect(), |own, term| own + term);
    let zero = N::constant(0.0);
    sum.retain(|(_, entry)| *entry != zero);
    sum
}
