//! What the recursion is free to choose: a [`Plan`]. Every plan gives the same values; which is cheapest is counted.

use std::collections::BTreeSet;

use crate::{id::BodyId, tree::Tree};

/// A way to fewer operations, which can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Technique {
    /// Links have their origins where their joints' axes are nearest to the lower link's origin, so that offsets have no part
    /// along the axis; a link that only translates has its lower link's.
    Slide,
    /// Links are turned about their joints' axes until the constant rotations between them are sparse (modified
    /// Denavit-Hartenberg frames where that is possible), and those that carry none until their first moment is.
    Turn,
    /// Of a link's inertia its lower link is given what the joint does not move: base inertial parameters.
    Regroup,
    /// Of the mass given to a lower link so much is kept on the axis that the lower link's first moment has no part along the
    /// way to it.
    Balance,
    /// Links on which all axes are parallel to their own do not turn.
    Parallel,
    /// Moments of inertia forces are `U S - S U^T` where second moments are zero.
    SecondMoments,
    /// What the inertial frame feels of a joint's motion is taken there at once, past joints at the same point, or left out where
    /// it feels nothing of it.
    Shortcut,
    /// Where a frame is, and its Jacobian's columns, pass inward from it, and not outward from the inertial frame.
    Inward,
    /// Where they do not, levers pass inward beside axes that pass outward, and are not added up from steps along these axes. With
    /// `Shortcut`, two columns of all bodies' momentum leave a link for inertial axes at once, and not three alone.
    Levers,
    /// Where nothing but weight counts and gravity is constant along an axis, weights pass inward, and not masses.
    Weights,
    /// How fast the mass matrix changes passes inward beside what becomes its entries, and is not differentiated from these.
    Rates,
    /// Accelerations are solved for by articulated bodies.
    Articulated,
    /// Accelerations of joints that move freely about or along all axes are solved for along the link's axes.
    LinkAxes,
    /// The inverse of the mass matrix comes row by row from its factors, those of articulated bodies too, and what branches of a
    /// floating tree feel of one another passes through the acceleration of the body that carries them.
    Carriers,
    /// Where accelerations are solved for, bodies that nothing holds are taken to fall, and gravity is added to the result.
    Fall,
    /// Derivatives come in ways of their own: those of dynamics from composite bodies, products with those of accelerations from forces and
    /// one more solution, those of frames from the columns of their Jacobians; and not from the values' own operations.
    DirectDerivatives,
    /// Derivatives are carried from the outputs to what they depend on, and not outward from that.
    Reverse,
    /// Columns of long derivatives of dynamics, and of long inverses, go four at a time, by helpers that are called. Beside any plan,
    /// branches that are alike go side by side in every long function.
    Lockstep,
    /// Common factors are taken out of sums.
    Factor,
    /// Beside any plan: values that are sums, differences or products of others are made of these.
    Reuse,
}

impl Technique {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 20] = [
        ("slide", Self::Slide),
        ("turn", Self::Turn),
        ("regroup", Self::Regroup),
        ("balance", Self::Balance),
        ("parallel", Self::Parallel),
        ("second_moments", Self::SecondMoments),
        ("shortcut", Self::Shortcut),
        ("inward", Self::Inward),
        ("levers", Self::Levers),
        ("weights", Self::Weights),
        ("rates", Self::Rates),
        ("articulated", Self::Articulated),
        ("link_axes", Self::LinkAxes),
        ("carriers", Self::Carriers),
        ("fall", Self::Fall),
        ("composite", Self::DirectDerivatives),
        ("reverse", Self::Reverse),
        ("lockstep", Self::Lockstep),
        ("factor", Self::Factor),
        ("reuse", Self::Reuse),
    ];

    /// False where one speed moves several joints, of what takes a speed's motion for the one of its own joint: that could
    /// not be eliminated where it enters, nor taken along other axes, nor fall.
    pub fn is_possible(self, tree: &Tree) -> bool {
        let is_by_joint = matches!(
            self,
            Self::Articulated | Self::LinkAxes | Self::Carriers | Self::Fall
        );
        !is_by_joint || !tree.has_followers()
    }
}

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
