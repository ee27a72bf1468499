//! What a value can be made of: others, by no operation, one or two.

use std::ops::{Add, Mul};

use crate::expr::{Expr, ExprGraph, NodeId};

/// An operation on two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Operation {
    Sum,
    Product,
}

/// An operation on a value and the rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Made<R = Rest> {
    pub(super) operation: Operation,
    pub(super) first: Expr,
    pub(super) rest: R,
}

/// Nothing to add, one value, or an operation on two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rest {
    Nothing,
    One(Expr),
    Two(Made<Expr>),
}

/// What a value can be made of, and how many operations fall away with its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) id: NodeId,
    pub(super) made: Made,
    pub(super) gain: usize,
}

impl Operation {
    pub(super) fn of<T: Add<Output = T> + Mul<Output = T>>(self, a: T, b: T) -> T {
        match self {
            Self::Sum => a + b,
            Self::Product => a * b,
        }
    }

    fn build(self, graph: &mut ExprGraph, a: Expr, b: Expr) -> Expr {
        match self {
            Self::Sum => graph.add(a, b),
            Self::Product => graph.mul(a, b),
        }
    }
}

impl Rest {
    /// The same, with the sign flipped where `negative`.
    pub(super) fn signed(self, negative: bool) -> Self {
        match self {
            Self::Nothing => Self::Nothing,
            Self::One(expr) => Self::One(expr.signed(negative)),
            Self::Two(made) => Self::Two(Made {
                first: made.first.signed(negative),
                rest: match made.operation {
                    Operation::Sum => made.rest.signed(negative),
                    Operation::Product => made.rest,
                },
                ..made
            }),
        }
    }
}

impl Made {
    /// Another value as it is.
    pub(super) fn same(first: Expr) -> Self {
        Self {
            operation: Operation::Sum,
            first,
            rest: Rest::Nothing,
        }
    }

    /// True for another value as it is.
    pub(super) fn is_same(self) -> bool {
        self.rest == Rest::Nothing
    }

    /// True if there is a product.
    pub(super) fn multiplies(self) -> bool {
        let rest = match self.rest {
            Rest::Two(made) => made.operation,
            Rest::Nothing | Rest::One(_) => self.operation,
        };
        [self.operation, rest].contains(&Operation::Product)
    }

    /// How many operations that takes.
    pub(super) fn cost(self) -> usize {
        match self.rest {
            Rest::Nothing => 0,
            Rest::One(_) => 1,
            Rest::Two(_) => 2,
        }
    }

    pub(super) fn operands(self) -> impl Iterator<Item = NodeId> {
        let (second, third) = match self.rest {
            Rest::Nothing => (None, None),
            Rest::One(second) => (Some(second), None),
            Rest::Two(made) => (Some(made.first), Some(made.rest)),
        };
        let all = [Some(self.first), second, third];
        all.into_iter().flatten().map(Expr::node)
    }

    /// The value, of operands as they are now.
    pub(super) fn build(self, graph: &mut ExprGraph, of: impl Fn(Expr) -> Expr) -> Expr {
        let rest = match self.rest {
            Rest::Nothing => return of(self.first),
            Rest::One(expr) => of(expr),
            Rest::Two(made) => made.operation.build(graph, of(made.first), of(made.rest)),
        };
        self.operation.build(graph, of(self.first), rest)
    }
}
