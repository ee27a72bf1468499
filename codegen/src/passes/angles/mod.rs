//! Angles. Needs: nothing. Afterwards: no sine or cosine is taken of an angle that is a short sum of others whose sines and cosines are
//! taken, some of them negative or several times, and of what is known before the loop: they follow by the addition theorems. Keeps:
//! the value of every root, up to rounding, and the graph where no angle is such a sum.

mod follows;
mod span;
mod sum;

use std::collections::{BTreeMap, BTreeSet};

use self::{follows::Follows, span::Span, sum::Sum};
use super::theorems::of_angle;
use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId, Rebuilt};

/// The graph with as few sines as that, and its roots.
pub fn run(old: ExprGraph, roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    let needed = old.reachable(&roots);
    let sines = sines(&old, &needed);
    let angles: Vec<Expr> = sines.keys().copied().map(Expr::of).collect();
    let within = old.reachable(&angles);
    let followed = followed(&old, &sines, &within);
    if followed.iter().all(|(_, follows)| follows.is_none()) {
        return (old, roots);
    }
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(&old);
    let copy = |graph: &mut ExprGraph, rebuilt: &mut Rebuilt, id: NodeId| {
        graph.enter_like(&old, id);
        let expr = rebuilt.copy(graph, &old, id);
        graph.name_like(expr, &old, id);
        rebuilt.set(id, expr);
    };
    for id in old.ids().filter(|id| within[id.index()]) {
        copy(&mut graph, &mut rebuilt, id);
    }
    let mut pairs: BTreeMap<NodeId, [Expr; 2]> = BTreeMap::new();
    for (angle, follows) in &followed {
        graph.enter_like(&old, sines[angle]);
        let pair = match follows {
            Some(follows) => follows.pair(&mut graph, &rebuilt, &pairs),
            None => of_angle(&mut graph, rebuilt.node(*angle)),
        };
        pairs.insert(*angle, pair);
    }
    for id in old.ids().filter(|id| needed[id.index()]) {
        let of_angle = match old.node(id) {
            Node::Sin(angle) => pairs.get(&angle).map(|[sine, _]| *sine),
            Node::Cos(angle) => pairs.get(&angle).map(|[_, cosine]| *cosine),
            _ => None,
        };
        if let Some(expr) = of_angle {
            graph.enter_like(&old, id);
            graph.name_like(expr, &old, id);
            rebuilt.set(id, expr);
        } else if !rebuilt.has(id) {
            copy(&mut graph, &mut rebuilt, id);
        }
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}

/// The angles whose sines or cosines are needed in the loop, each with the first of these.
fn sines(graph: &ExprGraph, needed: &[bool]) -> BTreeMap<NodeId, NodeId> {
    let mut sines = BTreeMap::new();
    for id in graph.ids().filter(|id| needed[id.index()]) {
        if let Node::Sin(angle) | Node::Cos(angle) = graph.node(id)
            && graph.binding(angle) == Binding::State
        {
            sines.entry(angle).or_insert(id);
        }
    }
    sines
}

/// The angles in an order in which each comes after those that it follows from, if it does.
fn followed(
    graph: &ExprGraph,
    sines: &BTreeMap<NodeId, NodeId>,
    within: &[bool],
) -> Vec<(NodeId, Option<Follows>)> {
    let mut sums: BTreeMap<NodeId, Sum> = BTreeMap::new();
    for id in graph.ids().filter(|id| within[id.index()]) {
        sums.insert(id, Sum::of(graph, &sums, id));
    }
    // Short ones first: what is a sum follows from its terms.
    let order = sines.keys().map(|&angle| (sums[&angle].length(), angle));
    let order: BTreeSet<([usize; 2], NodeId)> = order.collect();
    let mut taken = Vec::new();
    let mut span = Span::default();
    let mut followed = Vec::new();
    for (_, angle) in order {
        let sum = &sums[&angle];
        let from_span = span.take(angle, &sum.varying);
        let from_span = from_span.and_then(|angles| Follows::from_span(sum, &angles, &sums));
        let ways = [Follows::of_longest(sum, &taken), from_span];
        let short = ways.into_iter().flatten().filter(Follows::is_short);
        followed.push((angle, short.min_by_key(Follows::length)));
        taken.push((angle, sum));
    }
    followed
}
