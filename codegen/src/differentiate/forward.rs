//! From the inputs to the roots: what each node changes by.

use super::{
    partials::partials,
    row::{Row, Seeds, added, scaled},
    turned::turned,
};
use crate::expr::{Expr, ExprGraph, Node, Purpose};

/// How each root changes with every variable.
pub fn forward(graph: &mut ExprGraph, roots: &[Expr], seeds: &Seeds) -> Vec<Row> {
    graph.begin(Purpose::Derivative);
    let needed = graph.reachable(roots);
    let ids = graph.ids().filter(|id| needed[id.index()]);
    let turned = turned(graph, roots);
    let mut rows: Vec<Row> = vec![Row::new(); needed.len()];
    for id in ids {
        graph.enter(graph.scope(id));
        if let Node::Input(input) = graph.node(id) {
            rows[id.index()] = seeds.get(&input).cloned().unwrap_or_default();
            continue;
        }
        let mut sum = Row::new();
        for (operand, slope) in partials(graph, id, turned[id.index()].as_ref(), |id| {
            !rows[id.index()].is_empty()
        }) {
            let term = scaled(graph, slope, &rows[operand.index()]);
            sum = added(graph, sum, term);
        }
        rows[id.index()] = sum;
    }
    let signed = |root: &Expr| {
        let row = rows[root.node().index()].iter();
        row.map(|&(place, entry)| (place, entry.signed(root.is_negative())))
            .collect()
    };
    roots.iter().map(signed).collect()
}
