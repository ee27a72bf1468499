//! The values of a body at drawn points.

use std::cell::OnceCell;

use super::{
    made::{Made, Operation, Rest},
    value::{Evaluated, Exact, Sized},
    work::Work,
};
use crate::{
    drawn::Field,
    expr::{Expr, Node, NodeId},
};

/// The values of a body's nodes, by their places.
pub(super) struct Values<'a> {
    nodes: Nodes<'a>,
    exact: Vec<Exact>,
    /// Those at the first point.
    firsts: Vec<Field>,
    /// Their reciprocals; zero for zero.
    reciprocals: Vec<Field>,
    /// Which of what is drawn each depends on, by places modulo the number of bits.
    supports: Vec<u128>,
    /// How large the terms are, once that was asked: in most bodies nothing is found.
    sized: OnceCell<Vec<Sized>>,
}

/// A body's nodes, and what they are computed from, what is needed first.
#[derive(Clone, Copy)]
struct Nodes<'a> {
    work: &'a Work<'a>,
    given: &'a [NodeId],
    /// Their places.
    places: &'a [usize],
    /// Which are computed; others are drawn.
    is_known: &'a [bool],
}

impl<'a> Values<'a> {
    /// Those of a body, and of what they are computed from, at these places, what is needed first. What is not known is drawn.
    pub(super) fn of(
        work: &'a Work<'a>,
        given: &'a [NodeId],
        places: &'a [usize],
        is_known: &'a [bool],
    ) -> Self {
        let nodes = Nodes {
            work,
            given,
            places,
            is_known,
        };
        let exact: Vec<Exact> = nodes.evaluated();
        let firsts: Vec<Field> = exact.iter().map(|value| value.first()).collect();
        Self {
            reciprocals: Field::reciprocals(&firsts),
            supports: nodes.supports(),
            sized: OnceCell::new(),
            nodes,
            exact,
            firsts,
        }
    }

    /// The place of a node.
    pub(super) fn place(&self, id: NodeId) -> usize {
        self.nodes.places[id.index()]
    }

    /// The exact values at the first point, by places.
    pub(super) fn firsts(&self) -> &[Field] {
        &self.firsts
    }

    /// Their reciprocals.
    pub(super) fn reciprocals(&self) -> &[Field] {
        &self.reciprocals
    }

    /// For each place, what tells on what it depends: all bits are among those of another if it depends on nothing else.
    pub(super) fn supports(&self) -> &[u128] {
        &self.supports
    }

    /// True if that is the value at all points, and has no terms that the value has not: what cancels would take digits.
    pub(super) fn holds(&self, id: NodeId, made: Made) -> bool {
        let place = self.place(id);
        if self.nodes.value(&self.exact, made) != self.exact[place] {
            return false;
        }
        let sized = self.sized.get_or_init(|| self.nodes.evaluated());
        self.nodes.value(sized, made).is_within(&sized[place])
    }
}

impl Nodes<'_> {
    fn evaluated<V: Evaluated>(self) -> Vec<V> {
        let mut source = V::source();
        let mut all: Vec<V> = Vec::with_capacity(self.given.len());
        for (place, &id) in self.given.iter().enumerate() {
            let node = self.work.graph.node(id);
            let value = match node {
                _ if self.is_known[place] => self.computed(&all, node),
                // Derivations bring these; others might be any.
                Node::Number(bits) if [0.5, 2.0].contains(&f64::from_bits(bits)) => {
                    Some(V::number(f64::from_bits(bits)))
                }
                Node::Number(_) => Some(V::drawn_number(&mut source)),
                _ => None,
            };
            all.push(value.unwrap_or_else(|| V::drawn(&mut source)));
        }
        all
    }

    /// What an operation makes, but for a magnitude, which would be the number or its negative by chance.
    fn computed<V: Evaluated>(self, all: &[V], node: Node) -> Option<V> {
        let of = |id: NodeId| &all[self.places[id.index()]];
        let expr = |expr: Expr| of(expr.node()).signed(expr);
        Some(match node {
            Node::Add(a, b) => V::of(Operation::Sum, &expr(a), &expr(b)),
            Node::Mul(a, b) => V::of(Operation::Product, of(a), of(b)),
            Node::Div(a, b) => V::of(Operation::Product, of(a), &of(b).reciprocal()),
            Node::Sin(angle) => of(angle).on_circle()[0],
            Node::Cos(angle) => of(angle).on_circle()[1],
            Node::Number(_) | Node::Input(_) | Node::Abs(_) => return None,
        })
    }

    fn supports(self) -> Vec<u128> {
        let mut all: Vec<u128> = Vec::with_capacity(self.given.len());
        for (place, &id) in self.given.iter().enumerate() {
            let node = self.work.graph.node(id);
            let support = match node {
                Node::Number(_) => 0,
                Node::Abs(_) | Node::Input(_) => 1 << (place % 128),
                _ if !self.is_known[place] => 1 << (place % 128),
                _ => {
                    let operands = self.work.operands(id);
                    operands.fold(0, |all_of, operand| {
                        all_of | all[self.places[operand.index()]]
                    })
                }
            };
            all.push(support);
        }
        all
    }

    /// What is made of others.
    fn value<V: Evaluated>(self, all: &[V], made: Made) -> V {
        let expr = |expr: Expr| all[self.places[expr.node().index()]].signed(expr);
        let first = expr(made.first);
        let rest = match made.rest {
            Rest::Nothing => return first,
            Rest::One(second) => expr(second),
            Rest::Two(made) => V::of(made.operation, &expr(made.first), &expr(made.rest)),
        };
        V::of(made.operation, &first, &rest)
    }
}
