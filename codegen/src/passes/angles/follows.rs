//! How an angle follows from others.

use std::collections::BTreeMap;

use super::sum::{Sum, Terms};
use crate::{
    expr::{Expr, ExprGraph, NodeId, Rebuilt},
    passes::theorems::{of_angle, of_sum, without_crumb},
};

/// The most terms of a sum: each but the first takes a theorem of six operations, and a sine with its cosine costs as much as 22.
const MOST_TERMS: usize = 4;

/// What an angle follows from: the sum of other angles, each added or subtracted, and of what is known.
pub(super) struct Follows {
    angles: Vec<(NodeId, bool)>,
    known: Terms,
}

impl Follows {
    /// Of the longest angles that are part of it, one after the other. `None` where something is left that none of them has.
    /// Short ones are taken before long ones. `None` too where there are so many that a sine and a cosine cost less.
    pub(super) fn of_longest(sum: &Sum, taken: &[(NodeId, &Sum)]) -> Option<Self> {
        let mut rest = sum.clone();
        let mut angles = Vec::new();
        while !rest.varying.is_empty() {
            if angles.len() == MOST_TERMS {
                return None;
            }
            let (angle, is_negative, left) = without_longest(&rest, taken)?;
            angles.push((angle, is_negative));
            rest = left;
        }
        Some(Self {
            angles,
            known: rest.known,
        })
    }

    /// Of angles, each as often as that; `None` where these are many.
    pub(super) fn from_span(
        sum: &Sum,
        angles: &Terms,
        sums: &BTreeMap<NodeId, Sum>,
    ) -> Option<Self> {
        let n_angles: u64 = angles.values().map(|often| often.unsigned_abs()).sum();
        if n_angles > MOST_TERMS as u64 {
            return None;
        }
        let mut rest = sum.clone();
        let mut each = Vec::new();
        for (&angle, &often) in angles {
            rest.add(&sums[&angle], -often);
            each.extend((0..often.abs()).map(|_| (angle, often < 0)));
        }
        Some(Self {
            angles: each,
            known: rest.known,
        })
    }

    /// True where theorems cost less than a sine and a cosine.
    pub(super) fn is_short(&self) -> bool {
        self.length() <= MOST_TERMS
    }

    /// How many terms it is the sum of.
    pub(super) fn length(&self) -> usize {
        self.angles.len() + usize::from(!self.known.is_empty())
    }

    /// Its sine and cosine, of those of the others.
    pub(super) fn pair(
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
        let known = of_angle(graph, known).map(|entry| without_crumb(graph, entry));
        self.angles.iter().fold(known, |sum, (angle, is_negative)| {
            let [sine, cosine] = pairs[angle];
            of_sum(graph, sum, [sine.signed(*is_negative), cosine])
        })
    }
}

/// The longest angle that is part of a sum, or whose negative is, and what it leaves: of several that which leaves least that is known.
fn without_longest(sum: &Sum, taken: &[(NodeId, &Sum)]) -> Option<(NodeId, bool, Sum)> {
    let mut best: Option<(NodeId, bool, Sum)> = None;
    let mut longest = 0;
    for &(angle, other) in taken.iter().rev() {
        if other.varying.len() < longest {
            break;
        }
        let signs = [(1, false), (-1, true)].into_iter();
        let mut fitting = signs.filter(|(times, _)| sum.has(other, *times));
        let Some((times, is_negative)) = fitting.next() else {
            continue;
        };
        longest = other.varying.len();
        let mut left = sum.clone();
        left.add(other, -times);
        let is_shorter = |(_, _, known): &(_, _, Sum)| left.length() < known.length();
        if best.as_ref().is_none_or(is_shorter) {
            best = Some((angle, is_negative, left));
        }
    }
    best
}
