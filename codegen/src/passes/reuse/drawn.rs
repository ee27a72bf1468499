//! The values of a body at drawn points, and how large their terms are.

use super::{
    made::{Made, Operation, Rest},
    work::Work,
};
use crate::{
    drawn::Field,
    expr::{Expr, Node, NodeId, signed},
    number::Number as _,
    random::Random,
};

/// At how many points values are known without rounding.
const EXACT_POINTS: usize = 2;

/// At how many points the sizes are known.
const POINTS: usize = 16;

/// A number at each of these.
type Numbers = [f64; POINTS];

/// By how much the sizes of equal terms may differ, by rounding.
const SAME_SIZE: f64 = 1.0 + 1e-9;

/// The exponent that the bits of 1 have.
const ZERO_EXPONENT: usize = 1023;

/// Powers of two by which inputs are scaled at all points but the first, so that no term is small beside others at all of them.
const POWERS: usize = 16;

/// What is known of a value.
#[derive(Clone, Copy)]
struct Value {
    /// Modulo a prime, for all inputs drawn from all such numbers.
    exact: [Field; EXACT_POINTS],
    /// For inputs of a size that inputs have.
    real: Numbers,
    /// The sum of the magnitudes of the terms at the same points: rounding takes that part of it.
    size: Numbers,
}

/// The values of a body's nodes.
pub(super) struct Drawn<'a> {
    /// The nodes' places among those that were drawn.
    places: &'a [usize],
    values: Vec<Value>,
    /// The reciprocals of the exact values, at the first point.
    reciprocals: Vec<Field>,
    /// Which of what is drawn each depends on, by places modulo the number of bits.
    supports: Vec<u128>,
}

impl<'a> Drawn<'a> {
    /// Those of a body, and of what they are computed from, at these places, what is needed first. What is not known is drawn.
    pub(super) fn of(
        work: &Work<'_>,
        given: &[NodeId],
        places: &'a [usize],
        is_known: impl Fn(NodeId) -> bool,
    ) -> Self {
        let mut drawn = Self {
            places,
            values: Vec::with_capacity(given.len()),
            reciprocals: Vec::with_capacity(given.len()),
            supports: Vec::with_capacity(given.len()),
        };
        let mut points = Points {
            random: Random::new(1),
            n_drawn: 0,
        };
        for (place, &id) in given.iter().enumerate() {
            let node = work.graph.node(id);
            let computed = is_known(id).then(|| drawn.computed(node)).flatten();
            let (value, support) = match (computed, node) {
                (Some(value), _) => {
                    let operands = work.operands(id);
                    let support = operands.map(|operand| drawn.supports[places[operand.index()]]);
                    (value, support.fold(0, |all, support| all | support))
                }
                (_, Node::Number(bits)) => (points.constant(f64::from_bits(bits)), 0),
                _ => (points.input(), 1 << (place % 128)),
            };
            drawn.values.push(value);
            drawn.reciprocals.push(value.exact[0].reciprocal());
            drawn.supports.push(support);
        }
        drawn
    }

    /// The place of a node.
    pub(super) fn place(&self, id: NodeId) -> usize {
        self.places[id.index()]
    }

    /// The exact value at the first point.
    pub(super) fn first(&self, id: NodeId) -> Field {
        self.values[self.place(id)].exact[0]
    }

    /// Its reciprocal.
    pub(super) fn reciprocal(&self, id: NodeId) -> Field {
        self.reciprocals[self.place(id)]
    }

    /// The exact value of the rest at the first point.
    pub(super) fn rest(&self, rest: Rest) -> Field {
        let of = |expr: Expr| signed(expr, self.first(expr.node()));
        match rest {
            Rest::Nothing => Field::ZERO,
            Rest::One(one) => of(one),
            Rest::Two(made) => made.operation.of(of(made.first), of(made.rest)),
        }
    }

    /// True if it depends on nothing that the other one does not depend on.
    pub(super) fn is_within(&self, id: NodeId, other: NodeId) -> bool {
        let [own, other] = [id, other].map(|id| self.supports[self.place(id)]);
        own & !other == 0
    }

    /// True if that is the value at all points, and has no terms that the value has not: what cancels would take digits.
    pub(super) fn holds(&self, id: NodeId, made: Made) -> bool {
        let first = self.expr(made.first);
        let with = |rest: &Value| of(made.operation, &first, rest);
        let value = match made.rest {
            Rest::Nothing => first,
            Rest::One(expr) => with(&self.expr(expr)),
            Rest::Two(made) => with(&of(
                made.operation,
                &self.expr(made.first),
                &self.expr(made.rest),
            )),
        };
        let own = &self.values[self.place(id)];
        let mut sizes = value.size.iter().zip(own.size);
        value.exact == own.exact && sizes.all(|(size, own)| *size <= SAME_SIZE * own)
    }

    fn expr(&self, expr: Expr) -> Value {
        let value = self.values[self.place(expr.node())];
        Value {
            exact: value.exact.map(|one| signed(expr, one)),
            real: value.real.map(|one| signed(expr, one)),
            ..value
        }
    }

    /// A sum, a product or a quotient. What other operations make is drawn: a magnitude would be the number or its negative by chance.
    fn computed(&self, node: Node) -> Option<Value> {
        let expr = |id: NodeId| self.expr(Expr::of(id));
        Some(match node {
            Node::Add(a, b) => of(Operation::Sum, &self.expr(a), &self.expr(b)),
            Node::Mul(a, b) => of(Operation::Product, &expr(a), &expr(b)),
            Node::Div(a, b) => of(Operation::Product, &expr(a), &reciprocal(&expr(b))),
            Node::Number(_) | Node::Input(_) | Node::Sin(_) | Node::Cos(_) | Node::Abs(_) => {
                return None;
            }
        })
    }
}

fn reciprocal(value: &Value) -> Value {
    let of_size = |point: usize| value.size[point] / (value.real[point] * value.real[point]);
    Value {
        exact: value.exact.map(Field::reciprocal),
        real: value.real.map(|value| 1.0 / value),
        size: std::array::from_fn(of_size),
    }
}

fn of(operation: Operation, a: &Value, b: &Value) -> Value {
    let both = |a: Numbers, b: Numbers| -> Numbers {
        std::array::from_fn(|point| operation.of(a[point], b[point]))
    };
    Value {
        exact: std::array::from_fn(|point| operation.of(a.exact[point], b.exact[point])),
        real: both(a.real, b.real),
        size: both(a.size, b.size),
    }
}

/// What is drawn, one after the other.
struct Points {
    random: Random,
    n_drawn: u64,
}

impl Points {
    fn input(&mut self) -> Value {
        let exact = std::array::from_fn(|_| {
            self.n_drawn += 1;
            Field::drawn(self.n_drawn)
        });
        let real: Numbers = std::array::from_fn(|point| {
            let number = self.random.number();
            if point == 0 {
                return number;
            }
            let power = self.random.below(2 * POWERS + 1);
            let exponent = ZERO_EXPONENT - POWERS + power;
            number * f64::from_bits((exponent as u64) << (f64::MANTISSA_DIGITS - 1))
        });
        Value {
            exact,
            real,
            size: real.map(f64::abs),
        }
    }

    /// Two and a half, which derivations bring, are what they are; others might be any.
    fn constant(&mut self, number: f64) -> Value {
        if [0.5, 2.0].contains(&number) {
            return Value {
                exact: [Field::constant(number); EXACT_POINTS],
                real: [number; POINTS],
                size: [number; POINTS],
            };
        }
        let value = self.input();
        Value {
            real: value.size,
            ..value
        }
    }
}
