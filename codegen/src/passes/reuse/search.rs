//! Values that equal others, or sums, differences or products of others.

use std::{cell::OnceCell, collections::BTreeSet};

use super::{
    drawn::Drawn,
    index::Index,
    known::Bodies,
    made::{Found, Made, Operation, Rest},
    work::{Dependents, Work},
};
use crate::{
    expr::{Expr, ExprGraph, Input, Node, NodeId},
    id::BodyId,
    tree::Tree,
};

/// Up to how many places apart the second and the third of three are, unless one is an input.
const APART: usize = 32;

/// Of more values of a body none is made of others: it would take seconds, and change little.
const MOST: usize = 1_500;

/// Nor of three others where there are more than this to choose from.
const MOST_OF_THREE: usize = 800;

/// Of how many others a value may be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Others {
    OneOrTwo,
    Three,
}

/// All that can be made of others, by the nearest of these: what bodies do that are not on the path to the value's body, and where, is
/// of no account.
pub(super) fn all(
    tree: &Tree,
    work: &Work<'_>,
    others: Others,
    among: Option<&BTreeSet<Option<BodyId>>>,
) -> Vec<Found> {
    let bodies = Bodies::new(tree, work);
    let mut places = vec![NOWHERE; work.graph.len()];
    let mut found = Vec::new();
    let is_searched = |body| among.is_none_or(|among| among.contains(&body));
    for (body, own) in bodies.all() {
        if own.len() > MOST || !is_searched(body) {
            continue;
        }
        let known = bodies.known(body);
        let given = bodies.given(&known);
        for (place, id) in given.iter().enumerate() {
            places[id.index()] = place;
        }
        let drawn = Drawn::of(work, &given, &places, |id| known.contains(&id));
        let search = Search::new(work, drawn, &given, others);
        if search.rests.is_empty() {
            continue;
        }
        found.extend(own.iter().filter_map(|id| search.of(*id)));
    }
    found
}

/// The place of what a body's values are not made of.
const NOWHERE: usize = usize::MAX;

/// The search among the values of a body.
struct Search<'a> {
    work: &'a Work<'a>,
    drawn: Drawn<'a>,
    /// What values can be made of, in order.
    given: &'a [NodeId],
    rests: Index<Rest>,
    others: Others,
}

impl<'a> Search<'a> {
    fn new(work: &'a Work<'a>, drawn: Drawn<'a>, given: &'a [NodeId], others: Others) -> Self {
        let first = |rest: Rest| (drawn.rest(rest), rest);
        let rests = match others {
            Others::OneOrTwo => {
                Index::of(given.iter().map(|&id| Rest::One(Expr::of(id))).map(first))
            }
            Others::Three if given.len() > MOST_OF_THREE => Index::of(std::iter::empty()),
            Others::Three => Index::of(pairs(work.graph, given).map(first)),
        };
        Self {
            work,
            drawn,
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
        for (rest, is_negative) in self.rests.like(self.drawn.first(best.id)) {
            if let Rest::One(other) = rest
                && self.drawn.is_within(other.node(), best.id)
            {
                best.take(Made::same(other.signed(is_negative)));
            }
        }
    }

    /// Takes what the value can be made of by operations.
    fn made(&self, best: &mut Best<'_>) {
        let value = self.drawn.first(best.id);
        for &other in self.given {
            if !self.drawn.is_within(other, best.id) {
                continue;
            }
            let number = self.drawn.first(other);
            let own = Expr::of(other);
            let quotient = value * self.drawn.reciprocal(other);
            let ways = [
                (Operation::Sum, own, value + -number),
                (Operation::Sum, -own, value + number),
                (Operation::Product, own, quotient),
            ];
            for (operation, first, left) in ways {
                for (rest, is_negative) in self.rests.like(left) {
                    best.take(Made {
                        operation,
                        first,
                        rest: rest.signed(is_negative),
                    });
                }
            }
        }
    }
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
        let Search { work, drawn, .. } = self.search;
        let own = drawn.place(self.id);
        let away = |other: NodeId| drawn.place(other).abs_diff(own);
        let distance = made.operands().map(away).sum();
        let is_nearer = self.nearest.is_none_or(|(least, _)| distance < least);
        if !is_nearer || work.is_lost(made, self.id, &self.alone) {
            return;
        }
        let dependents = || self.dependents.get_or_init(|| work.dependents(self.id));
        if drawn.holds(self.id, made)
            && (work.is_early(made, self.id) || !dependents().has(work, made))
        {
            self.nearest = Some((distance, made));
        }
    }
}

/// Sums, differences and products of what is near one another, and of inputs with all.
fn pairs<'a>(graph: &'a ExprGraph, given: &'a [NodeId]) -> impl Iterator<Item = Rest> + use<'a> {
    let is_input = move |id: &NodeId| match graph.node(*id) {
        Node::Input(input) => !matches!(input, Input::CallResult(_)),
        Node::Sin(_) | Node::Cos(_) => true,
        _ => false,
    };
    let inputs: Vec<NodeId> = given.iter().copied().filter(is_input).collect();
    let of = move |place: usize| {
        let first = given[place];
        let near = given[place.saturating_sub(APART)..place].iter();
        let near = near.filter(|id| !is_input(id));
        let made = move |operation, rest| {
            Rest::Two(Made {
                operation,
                first: Expr::of(first),
                rest,
            })
        };
        let of_two = near.flat_map(move |id| {
            let second = Expr::of(*id);
            [
                made(Operation::Sum, second),
                made(Operation::Sum, -second),
                made(Operation::Product, second),
            ]
        });
        let of_inputs = inputs.iter().filter(|id| **id != first);
        let of_inputs = of_inputs.map(|id| made(Operation::Product, Expr::of(*id)));
        of_two.chain(of_inputs).collect::<Vec<_>>()
    };
    (0..given.len()).flat_map(of)
}
