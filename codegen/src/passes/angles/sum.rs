//! Angles as sums of terms.

use std::collections::BTreeMap;

use crate::expr::{Binding, ExprGraph, Node, NodeId};

/// How often each node is added; what is subtracted counts less than nought times.
pub(super) type Terms = BTreeMap<NodeId, i64>;

/// Larger multiples of an angle are no sums.
const MOST_TIMES: i32 = 4;

/// An angle as a sum.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    /// What depends on the state.
    pub(super) varying: Terms,
    /// What is known before the loop.
    pub(super) known: Terms,
}

impl Sum {
    /// A node, after the nodes that it is made of.
    pub(super) fn of(graph: &ExprGraph, sums: &BTreeMap<NodeId, Self>, id: NodeId) -> Self {
        let mut sum = Self::default();
        if graph.binding(id) != Binding::State {
            sum.known.insert(id, 1);
            return sum;
        }
        let node = graph.node(id);
        if let Node::Add(a, b) = node {
            for own in [a, b] {
                let times = if own.is_negative() { -1 } else { 1 };
                sum.add(&sums[&own.node()], times);
            }
        } else if let Node::Mul(number, angle) = node
            && let Some(times) = times(graph, number)
        {
            sum.add(&sums[&angle], times);
        } else {
            sum.varying.insert(id, 1);
        }
        sum
    }

    /// Adds another one so many times.
    pub(super) fn add(&mut self, other: &Self, times: i64) {
        add(&mut self.varying, &other.varying, times);
        add(&mut self.known, &other.known, times);
    }

    /// How many terms it has: those that vary, then those that are known.
    pub(super) fn length(&self) -> [usize; 2] {
        [&self.varying, &self.known].map(BTreeMap::len)
    }

    /// True where so many times the terms of another are terms of this one.
    pub(super) fn has(&self, other: &Self, times: i64) -> bool {
        !other.varying.is_empty()
            && other.varying.iter().all(|(id, often)| {
                let own = self.varying.get(id).copied().unwrap_or(0);
                let often = times * often;
                own.signum() == often.signum() && own.abs() >= often.abs()
            })
    }
}

/// Adds other terms so many times; what is left of none is gone. Returns the largest count, without its sign, of those that changed.
pub(super) fn add(terms: &mut Terms, others: &Terms, times: i64) -> i64 {
    let mut most = 0;
    for (&id, often) in others {
        let sum = terms.get(&id).copied().unwrap_or(0) + times * often;
        most = most.max(sum.abs());
        match sum {
            0 => terms.remove(&id),
            _ => terms.insert(id, sum),
        };
    }
    most
}

/// Makes it so many times as often. Returns the largest count, without its sign.
pub(super) fn scale(terms: &mut Terms, times: i64) -> i64 {
    let scaled = terms.values_mut().map(|often| {
        *often *= times;
        often.abs()
    });
    scaled.max().unwrap_or(0)
}

/// The small whole number that a node is.
fn times(graph: &ExprGraph, id: NodeId) -> Option<i64> {
    let Node::Number(bits) = graph.node(id) else {
        return None;
    };
    let mut all = 1..=MOST_TIMES;
    let found = all.find(|times| f64::from(*times).to_bits() == bits)?;
    Some(found.into())
}
