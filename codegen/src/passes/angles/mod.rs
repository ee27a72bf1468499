//! Angles. Needs: nothing. Afterwards: no sine or cosine is taken of an angle that is a sum of whole multiples of others whose sines and
//! cosines are taken, and of what is known before the loop: they follow by the addition theorems. Keeps: the value of every root,
//! up to rounding, and the graph where no angle is such a sum. Does not: ask whether theorems have fewer operations than a sine.

mod span;
mod sum;

use std::collections::{BTreeMap, BTreeSet};

use self::{
    span::Span,
    sum::{Sum, Terms},
};
use super::{
    rebuild::Rebuilt,
    sines::{of_sum, without_crumb},
};
use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId};

/// The graph with as few sines as that, and its roots.
pub fn run(old: ExprGraph, roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    let sines = sines(&old, &roots);
    let angles: Vec<Expr> = sines.keys().copied().map(Expr::of).collect();
    let within = old.reachable(&angles);
    let followed = followed(&old, &sines, &within);
    if followed.iter().all(|(_, follows)| follows.is_none()) {
        return (old, roots);
    }
    let needed = old.reachable(&roots);
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
            None => pair(&mut graph, rebuilt.node(*angle)),
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

fn pair(graph: &mut ExprGraph, angle: Expr) -> [Expr; 2] {
    [graph.sin(angle), graph.cos(angle)]
}

/// The angles whose sines or cosines are needed in the loop, each with the first of these.
fn sines(graph: &ExprGraph, roots: &[Expr]) -> BTreeMap<NodeId, NodeId> {
    let needed = graph.reachable(roots);
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
        let by_terms = Follows::by_terms(sum, &taken);
        let by_angles = span.take(angle, &sum.varying);
        let by_angles = by_angles.map(|angles| Follows::by_angles(sum, angles, &sums));
        let follows = [by_terms, by_angles].into_iter().flatten();
        followed.push((angle, follows.min_by_key(Follows::length)));
        taken.push((angle, sum));
    }
    followed
}

/// What an angle follows from: the sum of other angles, each added or subtracted, and of what is known.
struct Follows {
    angles: Vec<(NodeId, bool)>,
    known: Terms,
}

impl Follows {
    /// Of the longest angles that are part of it, one after the other. `None` where something is left that none of them has.
    /// Short ones are taken before long ones.
    fn by_terms(sum: &Sum, taken: &[(NodeId, &Sum)]) -> Option<Self> {
        let mut rest = sum.clone();
        let mut angles = Vec::new();
        while !rest.varying.is_empty() {
            let mut best: Option<(NodeId, bool, Sum)> = None;
            let mut longest = 0;
            for &(angle, other) in taken.iter().rev() {
                if other.varying.len() < longest {
                    break;
                }
                let signs = [(1, false), (-1, true)];
                let fitting = signs.into_iter().find(|(times, _)| rest.has(other, *times));
                let Some((times, is_negative)) = fitting else {
                    continue;
                };
                longest = other.varying.len();
                let mut left = rest.clone();
                left.add(other, -times);
                let is_shorter = |(_, _, known): &(_, _, Sum)| left.length() < known.length();
                if best.as_ref().is_none_or(is_shorter) {
                    best = Some((angle, is_negative, left));
                }
            }
            let (angle, is_negative, left) = best?;
            angles.push((angle, is_negative));
            rest = left;
        }
        Some(Self {
            angles,
            known: rest.known,
        })
    }

    /// Of angles, each as often as that.
    fn by_angles(sum: &Sum, angles: Terms, sums: &BTreeMap<NodeId, Sum>) -> Self {
        let mut rest = sum.clone();
        let mut each = Vec::new();
        for (angle, often) in angles {
            rest.add(&sums[&angle], -often);
            each.extend((0..often.abs()).map(|_| (angle, often < 0)));
        }
        Self {
            angles: each,
            known: rest.known,
        }
    }

    /// How many theorems it takes.
    fn length(&self) -> usize {
        self.angles.len() + usize::from(!self.known.is_empty())
    }

    /// Its sine and cosine, of those of the others.
    fn pair(
        &self,
        graph: &mut ExprGraph,
        rebuilt: &Rebuilt,
        pairs: &BTreeMap<NodeId, [Expr; 2]>,
    ) -> [Expr; 2] {
        let mut known = graph.zero();
        for (&id, &often) in &self.known {
            let terms = (0..often.abs()).map(|_| rebuilt.node(id).signed(often < 0));
            known = terms.fold(known, |sum, term| graph.add(sum, term));
        }
        let known = pair(graph, known).map(|entry| without_crumb(graph, entry));
        self.angles.iter().fold(known, |sum, (angle, is_negative)| {
            let [sine, cosine] = pairs[angle];
            of_sum(graph, sum, [sine.signed(*is_negative), cosine])
        })
    }
}
