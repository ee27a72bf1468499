//! From each root to the inputs: by how much it changes with each node.

use super::{
    partials::partials,
    row::{Row, Seeds, added, scaled},
    turned::turned,
};
use crate::expr::{Expr, ExprGraph, Node, Purpose};

/// How each root changes with every variable.
pub fn reverse(graph: &mut ExprGraph, roots: &[Expr], seeds: &Seeds) -> Vec<Row> {
    graph.begin(Purpose::Derivative);
    let varies = varying(graph, seeds);
    let turned = turned(graph, roots);
    // By how much the roots, by their places, change with each node.
    let mut slopes: Vec<Row> = vec![Row::new(); varies.len()];
    for (place, root) in roots.iter().enumerate() {
        let one = graph.one().signed(root.is_negative());
        let at = root.node().index();
        slopes[at] = added(graph, std::mem::take(&mut slopes[at]), vec![(place, one)]);
    }
    let mut jacobian = vec![Row::new(); roots.len()];
    let ids: Vec<_> = graph.ids().collect();
    for id in ids.into_iter().rev().filter(|id| varies[id.index()]) {
        let own = std::mem::take(&mut slopes[id.index()]);
        if own.is_empty() {
            continue;
        }
        graph.enter(graph.scope(id));
        if let Node::Input(input) = graph.node(id) {
            for (root, slope) in own {
                let row = scaled(graph, slope, &seeds[&input]);
                let before = std::mem::take(&mut jacobian[root]);
                jacobian[root] = added(graph, before, row);
            }
            continue;
        }
        for (operand, slope) in partials(graph, id, turned[id.index()].as_ref(), |id| {
            varies[id.index()]
        }) {
            let term = scaled(graph, slope, &own);
            let before = std::mem::take(&mut slopes[operand.index()]);
            slopes[operand.index()] = added(graph, before, term);
        }
    }
    jacobian
}

/// For each node, whether it depends on a variable.
fn varying(graph: &ExprGraph, seeds: &Seeds) -> Vec<bool> {
    let mut varies = vec![false; graph.len()];
    for id in graph.ids() {
        varies[id.index()] = match graph.node(id) {
            Node::Input(input) => seeds.contains_key(&input),
            node => node.operands().any(|operand| varies[operand.index()]),
        };
    }
    varies
}
