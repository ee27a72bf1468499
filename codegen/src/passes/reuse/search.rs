//! Values that equal others, or sums, differences or products of others.

use std::{cell::OnceCell, collections::BTreeSet};

use super::{
    index::Index,
    known::{Bodies, Reach},
    made::{Found, Made, Operation, Rest},
    points::Values,
    rests,
    work::{Dependents, Work},
};
use crate::{
    drawn::Field,
    expr::{Expr, NodeId},
    id::BodyId,
    tree::Tree,
};

/// Of more values of a body none is made of others: it would take seconds, and change little.
const MOST: usize = 1_500;

/// Nor where there are more pairs of such a value and one to choose from: in a body with a thousand siblings that know all of one path.
const MOST_PAIRS: usize = 8_000_000;

/// Nor of three others where there are more than this to choose from.
const MOST_OF_THREE: usize = 800;

/// Nor of a body that has more bodies on its path than any robot: what is known there grows with each.
const DEEPEST: usize = 64;

/// Of how many others a value may be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Others {
    OneOrTwo,
    Three,
}

/// All that can be made of others, by the nearest of these: what bodies do that are neither on the path to the value's body nor farther
/// out, and where, is of no account.
pub(super) fn all(
    tree: &Tree,
    work: &Work<'_>,
    others: Others,
    reach: Reach,
    among: Option<&BTreeSet<Option<BodyId>>>,
) -> Vec<Found> {
    let bodies = Bodies::new(tree, work);
    let mut places = vec![NOWHERE; work.graph.len()];
    let mut found = Vec::new();
    let is_searched = |body| among.is_none_or(|among| among.contains(&body));
    for (body, own) in bodies.all() {
        let depth = body.map_or(0, |body| tree.path(body).take(DEEPEST + 1).count());
        if own.len() > MOST || depth > DEEPEST || !is_searched(body) {
            continue;
        }
        let Some(known) = bodies.known(body, reach) else {
            continue;
        };
        let given = bodies.given(&known);
        let is_too_much = own.len() * given.len() > MOST_PAIRS;
        if is_too_much || others == Others::Three && given.len() > MOST_OF_THREE {
            continue;
        }
        for (place, id) in given.iter().enumerate() {
            places[id.index()] = place;
        }
        let is_known: Vec<bool> = given.iter().map(|id| known.contains(id)).collect();
        let values = Values::of(work, &given, &places, &is_known);
        let search = Search::new(work, values, &given, others);
        found.extend(own.iter().filter_map(|id| search.of(*id)));
    }
    found
}

/// The place of what a body's values are not made of.
const NOWHERE: usize = usize::MAX;

/// The search among the values of a body.
struct Search<'a> {
    work: &'a Work<'a>,
    values: Values<'a>,
    /// What values can be made of, in order.
    given: &'a [NodeId],
    rests: Index<Rest>,
    others: Others,
}

impl<'a> Search<'a> {
    fn new(work: &'a Work<'a>, values: Values<'a>, given: &'a [NodeId], others: Others) -> Self {
        let rests = match others {
            Others::OneOrTwo => rests::ones(given, values.firsts()),
            Others::Three => rests::pairs(work.graph, given, values.firsts()),
        };
        Self {
            work,
            values,
            given,
            rests,
            others,
        }
    }

    /// What a value can be made of by fewer operations.
    fn of(&self, id: NodeId) -> Option<Found> {
        let (alone, cost) = self.work.alone(id);
        let mut best = Best {
            search: self,
            id,
            alone,
            dependents: OnceCell::new(),
            nearest: None,
        };
        if cost > 0 && self.others == Others::OneOrTwo {
            self.same(&mut best);
        }
        let least = match self.others {
            Others::OneOrTwo => 2,
            Others::Three => 3,
        };
        if best.nearest.is_none() && cost >= least {
            self.made(&mut best);
        }
        let (_, made) = best.nearest?;
        Some(Found {
            id,
            made,
            gain: cost - made.cost(),
        })
    }

    /// Takes the values that are the same.
    fn same(&self, best: &mut Best<'_>) {
        let (own, supports) = (self.values.place(best.id), self.values.supports());
        for (rest, is_negative) in self.rests.like(self.values.firsts()[own]) {
            if let Rest::One(other) = rest
                && is_within(supports[self.values.place(other.node())], supports[own])
            {
                best.take(Made::same(other.signed(is_negative)));
            }
        }
    }

    /// Takes what the value can be made of by operations.
    fn made(&self, best: &mut Best<'_>) {
        let own = self.values.place(best.id);
        let (supports, numbers) = (self.values.supports(), self.values.firsts());
        let (support, value) = (supports[own], numbers[own]);
        let reciprocals = self.values.reciprocals();
        for (place, &other) in self.given.iter().enumerate() {
            if !is_within(supports[place], support) {
                continue;
            }
            let (number, other) = (numbers[place], Expr::of(other));
            let quotient = value * reciprocals[place];
            self.with(best, Operation::Sum, other, value - number);
            self.with(best, Operation::Sum, -other, value + number);
            self.with(best, Operation::Product, other, quotient);
        }
    }

    /// Takes what the first and what is left make.
    fn with(&self, best: &mut Best<'_>, operation: Operation, first: Expr, left: Field) {
        if !self.rests.may_have(left) {
            return;
        }
        for (rest, is_negative) in self.rests.like(left) {
            best.take(Made {
                operation,
                first,
                rest: rest.signed(is_negative),
            });
        }
    }
}

/// True if what has the one support depends on nothing that what has the other does not depend on.
fn is_within(own: u128, other: u128) -> bool {
    own & !other == 0
}

/// The nearest of what a value can be made of.
struct Best<'a> {
    search: &'a Search<'a>,
    id: NodeId,
    /// What falls away with the value.
    alone: Vec<NodeId>,
    /// What depends on it, once that was asked.
    dependents: OnceCell<Dependents>,
    nearest: Option<(usize, Made)>,
}

impl Best<'_> {
    fn take(&mut self, made: Made) {
        let Search { work, values, .. } = self.search;
        let own = values.place(self.id);
        let away = |other: NodeId| values.place(other).abs_diff(own);
        let distance = made.operands().map(away).sum();
        let is_nearer = self.nearest.is_none_or(|(least, _)| distance < least);
        if !is_nearer || work.is_lost(made, self.id, &self.alone) {
            return;
        }
        let dependents = || self.dependents.get_or_init(|| work.dependents(self.id));
        if values.holds(self.id, made)
            && (work.is_early(made, self.id) || !dependents().has(work, made))
        {
            self.nearest = Some((distance, made));
        }
    }
}
