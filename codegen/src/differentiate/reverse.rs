//! From each root to the inputs: by how much it changes with each node.

use super::{
    entries::{Use, by_angle, entries},
    partials::partials,
    row::{Row, Seeds, added, scaled},
    squares::squares,
    turned::turned,
};
use crate::expr::{Expr, ExprGraph, Node, NodeId, Purpose};

/// How each root changes with every variable.
pub fn reverse(graph: &mut ExprGraph, roots: &[Expr], seeds: &Seeds) -> Vec<Row> {
    graph.begin(Purpose::Derivative);
    let ids: Vec<NodeId> = graph.ids().collect();
    let squares = squares(graph, roots);
    let varying = varying(graph, seeds);
    let varies = |id: NodeId| varying[id.index()];
    let turned = turned(graph, roots);
    let entries = entries(graph, &turned, varies);
    // By how much the roots, by their places, change with each node: of squares twice that, of entries the products that say so.
    let mut slopes: Vec<Row> = vec![Row::new(); ids.len()];
    let mut uses: Vec<Vec<Use>> = vec![Vec::new(); ids.len()];
    for (place, root) in roots.iter().enumerate() {
        let one = graph.one().signed(root.is_negative());
        add(graph, &mut slopes[root.node().index()], vec![(place, one)]);
    }
    let two = graph.number(2.0);
    let mut jacobian = vec![Row::new(); roots.len()];
    for id in ids.into_iter().rev().filter(|id| varies(*id)) {
        graph.enter(graph.scope(id));
        let mut own = std::mem::take(&mut slopes[id.index()]);
        if let Some((angle, slope)) = entries[id.index()] {
            let uses = std::mem::take(&mut uses[id.index()]);
            if own.is_empty()
                && let Some(row) = by_angle(graph, slope, &uses)
            {
                add(graph, &mut slopes[angle.index()], row);
                continue;
            }
            for Use { factor, of } in uses {
                let term = scaled(graph, factor, &of);
                add(graph, &mut own, term);
            }
        }
        if own.is_empty() {
            continue;
        }
        let operands = match graph.node(id) {
            Node::Input(input) => {
                for (root, slope) in own {
                    let row = scaled(graph, slope, &seeds[&input]);
                    add(graph, &mut jacobian[root], row);
                }
                continue;
            }
            Node::Mul(a, b) if a == b => {
                if !squares[id.index()] {
                    own = scaled(graph, two, &own);
                }
                vec![(a, Expr::of(a))]
            }
            _ => partials(graph, id, turned[id.index()].as_ref(), varies),
        };
        for (operand, mut factor) in operands {
            if squares[operand.index()] && !squares[id.index()] {
                factor = graph.mul(two, factor);
            }
            if entries[operand.index()].is_some() {
                let of = own.clone();
                uses[operand.index()].push(Use { factor, of });
            } else {
                let term = scaled(graph, factor, &own);
                add(graph, &mut slopes[operand.index()], term);
            }
        }
    }
    jacobian
}

/// Adds a row to another.
fn add(graph: &mut ExprGraph, sum: &mut Row, row: Row) {
    let before = std::mem::take(sum);
    *sum = added(graph, before, row);
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
