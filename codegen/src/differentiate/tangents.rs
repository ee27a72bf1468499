//! The same as numbers: how the values of roots change, at given inputs.

use std::collections::BTreeMap;

use crate::{
    expr::{Expr, ExprGraph, Input, Node},
    number::Number,
};

/// Entries by their places, which ascend; what is not there is zero.
type Numbers<N> = Vec<(usize, N)>;

/// How the value of each root changes with every variable, where inputs have these values and change so.
pub fn tangents<N: Number + PartialEq>(
    graph: &ExprGraph,
    roots: &[Expr],
    mut input: impl FnMut(Input) -> N,
    seeds: &BTreeMap<Input, Numbers<N>>,
) -> Vec<Numbers<N>> {
    let needed = graph.reachable(roots);
    let mut values = vec![N::constant(0.0); graph.len()];
    let mut rows: Vec<Numbers<N>> = vec![Vec::new(); graph.len()];
    let one = N::constant(1.0);
    for id in graph.ids().filter(|id| needed[id.index()]) {
        let of = |expr: Expr| signed(expr, values[expr.node().index()]);
        let (value, slopes): (N, [Option<(usize, N)>; 2]) = match graph.node(id) {
            Node::Number(bits) => (N::constant(f64::from_bits(bits)), [None; 2]),
            Node::Input(given) => {
                rows[id.index()] = seeds.get(&given).cloned().unwrap_or_default();
                values[id.index()] = input(given);
                continue;
            }
            Node::Sin(a) => {
                let (sin, cos) = values[a.index()].sin_cos();
                (sin, [Some((a.index(), cos)), None])
            }
            Node::Cos(a) => {
                let (sin, cos) = values[a.index()].sin_cos();
                (cos, [Some((a.index(), -sin)), None])
            }
            Node::Abs(a) => {
                let (own, size) = (values[a.index()], values[a.index()].abs());
                (size, [Some((a.index(), own / size)), None])
            }
            Node::Add(a, b) => {
                let slope = |term: Expr| Some((term.node().index(), signed(term, one)));
                (of(a) + of(b), [slope(a), slope(b)])
            }
            Node::Mul(a, b) => {
                let (a, b) = (a.index(), b.index());
                let product = values[a] * values[b];
                (product, [Some((a, values[b])), Some((b, values[a]))])
            }
            Node::Div(a, b) => {
                let reciprocal = one / values[b.index()];
                let quotient = values[a.index()] * reciprocal;
                let slopes = [(a, reciprocal), (b, -(quotient * reciprocal))];
                let slopes = slopes.map(|(operand, slope)| Some((operand.index(), slope)));
                (quotient, slopes)
            }
        };
        values[id.index()] = value;
        let slopes = slopes.into_iter().flatten();
        let slopes = slopes.filter(|(operand, _)| !rows[*operand].is_empty());
        let row = slopes.fold(Vec::new(), |sum, (operand, slope)| {
            added(sum, &rows[operand], slope)
        });
        rows[id.index()] = row;
    }
    let signed_row = |root: &Expr| {
        let row = rows[root.node().index()].iter();
        row.map(|&(place, entry)| (place, signed(*root, entry)))
            .collect()
    };
    roots.iter().map(signed_row).collect()
}

/// The sum of a row and another one times a factor; what becomes zero is left out.
fn added<N: Number + PartialEq>(sum: Numbers<N>, other: &Numbers<N>, factor: N) -> Numbers<N> {
    let mut both = BTreeMap::from_iter(sum);
    for &(place, entry) in other {
        let term = entry * factor;
        let entry = both.get(&place).map_or(term, |&own| own + term);
        both.insert(place, entry);
    }
    let zero = N::constant(0.0);
    both.retain(|_, entry| *entry != zero);
    both.into_iter().collect()
}

fn signed<N: Number>(expr: Expr, value: N) -> N {
    if expr.is_negative() { -value } else { value }
}
