//! What is added to one value, or multiplied with it, to make another: one value, or an operation on two.

use super::{
    index::Index,
    made::{Made, Operation, Rest},
};
use crate::{
    drawn::Field,
    expr::{Expr, ExprGraph, Input, Node, NodeId},
};

/// Up to how many places apart the second and the third of three are, unless one is an input.
const APART: usize = 32;

/// Each of these nodes, by their numbers.
pub(super) fn ones(given: &[NodeId], numbers: &[Field]) -> Index<Rest> {
    let mut index = Index::with_capacity(given.len());
    for (&id, &number) in given.iter().zip(numbers) {
        index.add(number, Rest::One(Expr::of(id)));
    }
    index
}

/// Sums, differences and products of what is near one another, and of inputs with all.
pub(super) fn pairs(graph: &ExprGraph, given: &[NodeId], numbers: &[Field]) -> Index<Rest> {
    let is_input = |id: &NodeId| match graph.node(*id) {
        Node::Input(input) => !matches!(input, Input::CallResult(_)),
        Node::Sin(_) | Node::Cos(_) => true,
        _ => false,
    };
    let is_input: Vec<bool> = given.iter().map(is_input).collect();
    let inputs: Vec<usize> = (0..given.len()).filter(|place| is_input[*place]).collect();
    let n_each = 3 * APART + inputs.len();
    let mut index = Index::with_capacity(given.len() * n_each);
    for (place, (&id, &number)) in given.iter().zip(numbers).enumerate() {
        let first = Expr::of(id);
        let rest = |operation, rest| {
            Rest::Two(Made {
                operation,
                first,
                rest,
            })
        };
        for near in place.saturating_sub(APART)..place {
            if is_input[near] {
                continue;
            }
            let (second, other) = (Expr::of(given[near]), numbers[near]);
            index.add(number + other, rest(Operation::Sum, second));
            index.add(number - other, rest(Operation::Sum, -second));
            index.add(number * other, rest(Operation::Product, second));
        }
        for &input in &inputs {
            if input != place {
                let second = Expr::of(given[input]);
                index.add(number * numbers[input], rest(Operation::Product, second));
            }
        }
    }
    index
}
