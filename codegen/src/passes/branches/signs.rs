//! With which sign each branch goes through what all go through: where one adds, another may subtract.
//!
//! What a branch is given may be negated for it, so each such number has a sign that is free. A product has the sign of its factors.
//! Terms of a sum must have one sign, which is a condition on those that are free: linear equations modulo 2, solved as they
//! come.

use std::collections::BTreeMap;

/// A sign that is free, by number.
pub(super) type Free = usize;

/// A sign: the product of free ones, or its negative.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Sign {
    /// The free signs that are factors, in order.
    free: Vec<Free>,
    is_negative: bool,
}

impl Sign {
    /// A free sign, or its negative.
    pub(super) fn free(own: Free, is_negative: bool) -> Self {
        Self {
            free: vec![own],
            is_negative,
        }
    }

    /// The same, or its negative.
    #[must_use]
    pub(super) fn signed(mut self, is_negative: bool) -> Self {
        self.is_negative ^= is_negative;
        self
    }

    /// The product of two.
    #[must_use]
    pub(super) fn times(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.free.iter().peekable(), other.free.iter().peekable());
        let mut free = Vec::with_capacity(self.free.len() + other.free.len());
        loop {
            let (next, from_both) = match (a.peek(), b.peek()) {
                (None, None) => break,
                (Some(&&one), Some(&&two)) => (one.min(two), one == two),
                (Some(&&one), None) | (None, Some(&&one)) => (one, false),
            };
            a.next_if(|own| **own == next);
            b.next_if(|own| **own == next);
            if !from_both {
                free.push(next);
            }
        }
        Self {
            free,
            is_negative: self.is_negative ^ other.is_negative,
        }
    }
}

/// What a free sign costs where it is negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Price {
    /// Numbers that differ from branch to branch: nothing.
    Number,
    /// What differs from branch to branch: a sign where it is stored.
    Side,
    /// One number for all: each branch then gets its own.
    Equal,
    /// What all share: each branch then gets its own.
    Shared,
}

/// The free signs of a team's branches, and what is known of them.
#[derive(Debug)]
pub(super) struct Signs {
    prices: Vec<Price>,
    /// For each branch but the first.
    known: Vec<Known>,
}

/// What is known of the signs of a branch.
#[derive(Clone, Debug, Default)]
struct Known {
    /// The signs that follow from others, which do not.
    follow: BTreeMap<Free, Sign>,
    /// For each sign, those that follow from it, and some that once did.
    followers: BTreeMap<Free, Vec<Free>>,
}

impl Known {
    /// A sign, by those that follow from no others.
    fn of(&self, sign: &Sign) -> Sign {
        let start = Sign::default().signed(sign.is_negative);
        sign.free
            .iter()
            .fold(start, |known, own| match self.follow.get(own) {
                Some(followed) => known.times(followed),
                None => known.times(&Sign::free(*own, false)),
            })
    }

    /// From now on a sign that followed from no others follows from these.
    fn set(&mut self, own: Free, sign: Sign) {
        for other in self.followers.remove(&own).unwrap_or_default() {
            let Some(follows) = self.follow.get_mut(&other) else {
                continue;
            };
            if let Ok(place) = follows.free.binary_search(&own) {
                follows.free.remove(place);
                *follows = follows.times(&sign);
                for from in &sign.free {
                    self.followers.entry(*from).or_default().push(other);
                }
            }
        }
        for from in &sign.free {
            self.followers.entry(*from).or_default().push(own);
        }
        self.follow.insert(own, sign);
    }
}

impl Signs {
    /// Of so many branches; the first has no signs of its own.
    pub(super) fn new(lanes: usize) -> Self {
        Self {
            prices: Vec::new(),
            known: vec![Known::default(); lanes - 1],
        }
    }

    /// One that is free.
    pub(super) fn add(&mut self, price: Price) -> Free {
        self.prices.push(price);
        self.prices.len() - 1
    }

    /// What a free sign costs where it is negative.
    pub(super) fn price(&self, own: Free) -> Price {
        self.prices[own]
    }

    /// Makes these signs positive, one for each branch but the first. False, and nothing changes, if they cannot all be.
    pub(super) fn require_positive(&mut self, signs: &[Sign]) -> bool {
        let signs = self.known.iter().zip(signs);
        let signs: Vec<Sign> = signs.map(|(known, sign)| known.of(sign)).collect();
        let is_not = |sign: &Sign| sign.free.is_empty() && sign.is_negative;
        if signs.iter().any(is_not) {
            return false;
        }
        for (known, mut sign) in self.known.iter_mut().zip(signs) {
            let price = |own: &Free| (self.prices[*own], *own);
            if let Some(cheapest) = sign.free.iter().copied().min_by_key(price) {
                sign.free.retain(|own| *own != cheapest);
                known.set(cheapest, sign);
            }
        }
        true
    }

    /// Whether a sign of a branch is negative, where those that are still free are positive.
    pub(super) fn is_negative(&self, lane: usize, sign: &Sign) -> bool {
        lane > 0 && self.known[lane - 1].of(sign).is_negative
    }
}
