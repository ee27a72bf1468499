//! Angles. Needs: nothing. Afterwards: no sine or cosine is taken of an angle that is a sum or difference of others whose sines and
//! cosines are taken, and of what is known before the loop: they follow by the addition theorems. Keeps: the value of every root,
//! up to rounding, and the graph where no angle is such a sum. Does not: ask whether a theorem has fewer operations than a sine.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    rebuild::Rebuilt,
    sines::{of_sum, without_crumb},
};
use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId};

/// How often each node is added; what is subtracted counts less than nought times.
type Terms = BTreeMap<NodeId, i32>;

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
    let mut taken: Vec<(NodeId, &Sum)> = Vec::new();
    let mut followed = Vec::new();
    for (_, angle) in order {
        let sum = &sums[&angle];
        followed.push((angle, Follows::of(sum, &taken)));
        taken.push((angle, sum));
    }
    followed
}

/// An angle as a sum.
#[derive(Clone, Default)]
struct Sum {
    /// What depends on the state.
    varying: Terms,
    /// What is known before the loop.
    known: Terms,
}

impl Sum {
    /// A node, after the nodes that it is made of.
    fn of(graph: &ExprGraph, sums: &BTreeMap<NodeId, Self>, id: NodeId) -> Self {
        let mut sum = Self::default();
        if graph.binding(id) != Binding::State {
            sum.known.insert(id, 1);
        } else if let Node::Add(a, b) = graph.node(id) {
            for own in [a, b] {
                sum.add(&sums[&own.node()], sign(own.is_negative()));
            }
        } else {
            sum.varying.insert(id, 1);
        }
        sum
    }

    fn add(&mut self, other: &Self, times: i32) {
        let both = [
            (&mut self.varying, &other.varying),
            (&mut self.known, &other.known),
        ];
        for (own, others) in both {
            for (&id, often) in others {
                *own.entry(id).or_default() += times * often;
            }
            own.retain(|_, often| *often != 0);
        }
    }

    /// How many terms it has: those that vary, then those that are known.
    fn length(&self) -> [usize; 2] {
        [&self.varying, &self.known].map(BTreeMap::len)
    }

    /// True where all terms of another, or their negatives, are terms of this one.
    fn has(&self, other: &Self, times: i32) -> bool {
        !other.varying.is_empty()
            && other.varying.iter().all(|(id, often)| {
                let own = self.varying.get(id).copied().unwrap_or(0);
                let often = times * often;
                own.signum() == often.signum() && own.abs() >= often.abs()
            })
    }
}

fn sign(is_negative: bool) -> i32 {
    if is_negative { -1 } else { 1 }
}

/// What an angle follows from: the sum of other angles, or their negatives, and of what is known.
struct Follows {
    angles: Vec<(NodeId, bool)>,
    known: Terms,
}

impl Follows {
    /// `None` where something is left that none of the angles has.
    fn of(sum: &Sum, taken: &[(NodeId, &Sum)]) -> Option<Self> {
        let mut rest = sum.clone();
        let mut angles = Vec::new();
        while !rest.varying.is_empty() {
            // The longest, of equals the first.
            let found = taken.iter().rev().find_map(|&(angle, other)| {
                let is_negative = [false, true].into_iter();
                let mut found = is_negative.filter(|own| rest.has(other, sign(*own)));
                found.next().map(|is_negative| (angle, other, is_negative))
            });
            let (angle, other, is_negative) = found?;
            rest.add(other, -sign(is_negative));
            angles.push((angle, is_negative));
        }
        Some(Self {
            angles,
            known: rest.known,
        })
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
            let times = graph.number(f64::from(often));
            let term = graph.mul(times, rebuilt.node(id));
            known = graph.add(known, term);
        }
        let known = pair(graph, known).map(|entry| without_crumb(graph, entry));
        self.angles.iter().fold(known, |sum, (angle, is_negative)| {
            let [sine, cosine] = pairs[angle];
            of_sum(graph, sum, [sine.signed(*is_negative), cosine])
        })
    }
}
