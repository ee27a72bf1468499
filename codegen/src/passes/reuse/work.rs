//! A graph in which values were replaced: what is needed of it, in which order, how often, and what falls away with a value.

use std::{
    cmp::Reverse,
    collections::{BTreeMap, BTreeSet},
};

use super::made::{Found, Made};
use crate::{
    expr::{Binding, Expr, ExprGraph, Input, Node, NodeId, SINE},
    id::BodyId,
};

/// How much is counted of what falls away with a value.
const MOST_ALONE: usize = 64;

/// The graph, with what its values are made of now.
#[derive(Clone)]
pub(super) struct Work<'a> {
    pub(super) graph: &'a ExprGraph,
    pub(super) roots: &'a [Expr],
    made: Vec<Option<Made>>,
    /// What the roots need, operands first, and as far as that allows in the order of the graph.
    pub(super) order: Vec<NodeId>,
    /// The place of each node in this order.
    places: Vec<usize>,
    /// How often each is used.
    uses: Vec<u32>,
}

/// What depends on a value.
pub(super) struct Dependents {
    /// The value's place.
    first: usize,
    /// For this place and the next ones.
    known: Vec<bool>,
}

impl Dependents {
    /// True if some of what a value could be made of is among them.
    pub(super) fn has(&self, work: &Work<'_>, made: Made) -> bool {
        made.operands().any(|operand| {
            let place = work.place(operand);
            place >= self.first && self.known[place - self.first]
        })
    }
}

/// The place of what is not needed.
const NOWHERE: usize = usize::MAX;

impl<'a> Work<'a> {
    pub(super) fn new(graph: &'a ExprGraph, roots: &'a [Expr]) -> Self {
        let mut work = Self {
            graph,
            roots,
            made: vec![None; graph.len()],
            order: Vec::new(),
            places: Vec::new(),
            uses: Vec::new(),
        };
        work.put_in_order();
        work
    }

    /// What the value is made of instead of its own operations.
    pub(super) fn made(&self, id: NodeId) -> Option<Made> {
        self.made[id.index()]
    }

    /// The place in the order.
    pub(super) fn place(&self, id: NodeId) -> usize {
        self.places[id.index()]
    }

    /// What the value is computed from: all that a call reads, where it computes it.
    pub(super) fn operands(&self, id: NodeId) -> impl Iterator<Item = NodeId> + use<'_> {
        let node = self.graph.node(id);
        let (made, own) = match (self.made(id), node) {
            (Some(made), _) => (Some(made.operands()), None),
            (None, node) => (None, Some(node.operands())),
        };
        let called = match node {
            Node::Input(Input::CallResult(result)) => Some(self.graph.read_by(result.call)),
            _ => None,
        };
        let made = made.into_iter().flatten();
        let called = called.into_iter().flatten().map(Expr::node);
        made.chain(own.into_iter().flatten()).chain(called)
    }

    /// Sets the order, the places and the uses.
    fn put_in_order(&mut self) {
        let mut needed = vec![false; self.graph.len()];
        let mut pending: Vec<NodeId> = self.roots.iter().map(|root| root.node()).collect();
        while let Some(id) = pending.pop() {
            if !std::mem::replace(&mut needed[id.index()], true) {
                pending.extend(self.operands(id));
            }
        }
        let mut order = Vec::with_capacity(self.order.len());
        let mut is_there = vec![false; self.graph.len()];
        for id in self.graph.ids().filter(|id| needed[id.index()]) {
            pending.push(id);
            while let Some(&next) = pending.last() {
                if is_there[next.index()] {
                    pending.pop();
                    continue;
                }
                let n_before = pending.len();
                pending.extend(self.operands(next).filter(|id| !is_there[id.index()]));
                if pending.len() == n_before {
                    is_there[next.index()] = true;
                    order.push(next);
                    pending.pop();
                }
            }
        }
        self.uses = vec![0; self.graph.len()];
        for root in self.roots {
            self.uses[root.node().index()] += 1;
        }
        let mut uses = std::mem::take(&mut self.uses);
        for &id in &order {
            for operand in self.operands(id) {
                uses[operand.index()] += 1;
            }
        }
        self.uses = uses;
        self.places = vec![NOWHERE; self.graph.len()];
        for (place, id) in order.iter().enumerate() {
            self.places[id.index()] = place;
        }
        self.order = order;
    }

    /// What the loop's own operation costs.
    fn cost(&self, id: NodeId) -> usize {
        match self.graph.node(id) {
            Node::Number(_) | Node::Input(_) => 0,
            Node::Sin(_) | Node::Cos(_) => SINE,
            Node::Abs(_) | Node::Add(..) | Node::Mul(..) | Node::Div(..) => 1,
        }
    }

    /// How many operations of each body depend on parameters alone: none where they were hoisted.
    pub(super) fn on_parameters(&self) -> BTreeMap<Option<BodyId>, usize> {
        let is_one =
            |id: &&NodeId| self.cost(**id) > 0 && self.graph.binding(**id) != Binding::State;
        let mut counts = BTreeMap::new();
        for id in self.order.iter().filter(is_one) {
            *counts.entry(self.graph.scope(*id)).or_default() += 1;
        }
        counts
    }

    /// All operations, as users count them: an angle has two, whether both its sine and its cosine are needed or one.
    pub(super) fn total(&self) -> usize {
        let mut angles = BTreeSet::new();
        let mut n = 0;
        for &id in &self.order {
            match self.graph.node(id) {
                Node::Number(_) | Node::Input(_) | Node::Abs(_) => {}
                Node::Sin(angle) | Node::Cos(angle) => _ = angles.insert(angle),
                Node::Add(..) | Node::Mul(..) | Node::Div(..) => n += 1,
            }
        }
        n + 2 * angles.len()
    }

    /// What falls away of its body with the value, itself first, and what that costs; of much, the first part.
    pub(super) fn alone(&self, head: NodeId) -> (Vec<NodeId>, usize) {
        let mut all = vec![head];
        let mut left: Vec<(NodeId, u32)> = Vec::new();
        let mut cost = 0;
        let mut next = 0;
        while let Some(&id) = all.get(next).filter(|_| next < MOST_ALONE) {
            next += 1;
            cost += self.cost(id);
            if matches!(self.graph.node(id), Node::Input(_)) {
                continue;
            }
            for operand in self.operands(id) {
                let place = left.iter().position(|(other, _)| *other == operand);
                let place = place.unwrap_or_else(|| {
                    left.push((operand, self.uses[operand.index()]));
                    left.len() - 1
                });
                left[place].1 -= 1;
                let is_own = self.graph.scope(operand) == self.graph.scope(head);
                if left[place].1 == 0 && is_own && self.cost(operand) > 0 {
                    all.push(operand);
                }
            }
        }
        (all, cost)
    }

    /// True if some of what the value could be made of falls away with it, or is plainly made of it.
    pub(super) fn is_lost(&self, made: Made, id: NodeId, alone: &[NodeId]) -> bool {
        made.operands()
            .any(|operand| alone.contains(&operand) || self.operands(operand).any(|own| own == id))
    }

    /// True if all that the value could be made of comes before it.
    pub(super) fn is_early(&self, made: Made, id: NodeId) -> bool {
        let mut operands = made.operands();
        operands.all(|operand| self.place(operand) < self.place(id))
    }

    /// What depends on the value.
    pub(super) fn dependents(&self, id: NodeId) -> Dependents {
        let first = self.place(id);
        let mut known = vec![true];
        for &next in self.order[first..].iter().skip(1) {
            let depends = self.operands(next).any(|operand| {
                let place = self.place(operand);
                place >= first && place != NOWHERE && known[place - first]
            });
            known.push(depends);
        }
        Dependents { first, known }
    }

    /// Replaces values by what was found, those first with which most falls away. The bodies of which values were replaced.
    pub(super) fn replace(&mut self, mut all: Vec<Found>) -> BTreeSet<Option<BodyId>> {
        all.sort_by_key(|found| (Reverse(found.gain), self.place(found.id)));
        let mut changed = BTreeSet::new();
        for Found { id, made, gain } in all {
            let is_there = |id: NodeId| self.place(id) != NOWHERE;
            if !is_there(id) || !made.operands().all(is_there) {
                continue;
            }
            let (alone, cost) = self.alone(id);
            if cost < gain + made.cost() || self.is_lost(made, id, &alone) {
                continue;
            }
            let is_early = self.is_early(made, id);
            if !is_early && self.dependents(id).has(self, made) {
                continue;
            }
            self.make(id, made);
            if !is_early {
                self.put_behind(id, made);
            }
            changed.insert(self.graph.scope(id));
        }
        if !changed.is_empty() {
            self.put_in_order();
        }
        changed
    }

    /// Moves a value and what depends on it behind what it is made of now.
    fn put_behind(&mut self, id: NodeId, made: Made) {
        let Dependents { first, known } = self.dependents(id);
        let last = made.operands().map(|operand| self.place(operand)).max();
        let last = last.filter(|last| *last > first).unwrap_or(first);
        let between = self.order[first..=last].iter().zip(known);
        let (behind, before): (Vec<_>, Vec<_>) = between.partition(|(_, depends)| *depends);
        let moved: Vec<NodeId> = before
            .into_iter()
            .chain(behind)
            .map(|(id, _)| *id)
            .collect();
        for (place, id) in (first..).zip(moved) {
            self.order[place] = id;
            if self.places[id.index()] != NOWHERE {
                self.places[id.index()] = place;
            }
        }
    }

    /// Makes a value of others, and forgets what falls away.
    fn make(&mut self, id: NodeId, made: Made) {
        let mut released: Vec<NodeId> = self.operands(id).collect();
        self.made[id.index()] = Some(made);
        for operand in made.operands() {
            self.uses[operand.index()] += 1;
        }
        while let Some(id) = released.pop() {
            self.uses[id.index()] -= 1;
            if self.uses[id.index()] == 0 {
                self.places[id.index()] = NOWHERE;
                released.extend(self.operands(id));
            }
        }
    }
}
