//! What the recursion is free to choose: a [`Plan`]. Every plan gives the same values; which is cheapest is counted.

use std::collections::BTreeSet;

use super::technique::Technique;
use crate::{id::BodyId, tree::Tree};

/// Which techniques are used, and how, link by link. A technique that is not [possible](Technique::is_possible) is never used.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Plan {
    possible: BTreeSet<Technique>,
    used: BTreeSet<Technique>,
    regroup: Vec<Regroup>,
    parallel: Vec<bool>,
    calls_twice: bool,
}

/// How much second moment along its axis a link gives its lower link, with all mass and first moment along it: so much that
/// one of its own numbers becomes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Regroup {
    /// It gives nothing at all.
    None,
    /// The second moment along the axis.
    Second,
    /// The moment of inertia about the first axis after the joint's, in cyclic order.
    First,
    /// The same about the second.
    Last,
}

impl Regroup {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Second, Self::First, Self::Last, Self::None];
}

impl Plan {
    /// Every technique left out.
    pub fn plain(tree: &Tree) -> Self {
        let all = Technique::ALL.into_iter().map(|(_, technique)| technique);
        Self {
            possible: all
                .filter(|technique| technique.is_possible(tree))
                .collect(),
            used: BTreeSet::new(),
            regroup: vec![Regroup::Second; tree.bodies.len()],
            parallel: vec![true; tree.bodies.len()],
            calls_twice: false,
        }
    }

    /// Every technique used wherever it can be.
    pub fn full(tree: &Tree) -> Self {
        let plain = Self::plain(tree);
        Self {
            used: plain.possible.clone(),
            ..plain
        }
    }

    /// Uses a technique, if it is possible, or leaves it out.
    pub fn set(&mut self, technique: Technique, used: bool) {
        if used && self.possible.contains(&technique) {
            self.used.insert(technique);
        } else {
            self.used.remove(&technique);
        }
    }

    /// The same with a technique used, if it is possible, or left out.
    #[must_use]
    pub fn with(&self, technique: Technique, used: bool) -> Self {
        let mut other = self.clone();
        other.set(technique, used);
        other
    }

    /// True where the technique is used.
    pub fn uses(&self, technique: Technique) -> bool {
        self.used.contains(&technique)
    }

    /// True where columns of accelerations that go in lockstep pass inward in lockstep too: once for the accelerations, and
    /// once more at these. What both times have in common is then computed twice.
    pub fn calls_twice(&self) -> bool {
        self.calls_twice
    }

    /// The same with columns that pass in lockstep, or one by one.
    #[must_use]
    pub fn with_calls_twice(&self, calls_twice: bool) -> Self {
        Self {
            calls_twice,
            ..self.clone()
        }
    }

    /// What a link gives its lower link.
    pub fn regroup(&self, body: BodyId) -> Regroup {
        if self.uses(Technique::Regroup) {
            self.regroup[body.index()]
        } else {
            Regroup::None
        }
    }

    /// The same with another choice for one link, or for all.
    #[must_use]
    pub fn with_regroup(&self, body: Option<BodyId>, choice: Regroup) -> Self {
        let mut other = self.clone();
        match body {
            Some(body) => other.regroup[body.index()] = choice,
            None => other.regroup.fill(choice),
        }
        other
    }

    /// True for a link that shall not turn, where it can.
    pub fn parallel(&self, body: BodyId) -> bool {
        self.uses(Technique::Parallel) && self.parallel[body.index()]
    }

    /// The same with another choice for one link, or for all.
    #[must_use]
    pub fn with_parallel(&self, body: Option<BodyId>, choice: bool) -> Self {
        let mut other = self.clone();
        match body {
            Some(body) => other.parallel[body.index()] = choice,
            None => other.parallel.fill(choice),
        }
        other
    }
}
