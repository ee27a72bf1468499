//! What the columns of calls share, gathered while their helpers are written.

use std::collections::BTreeMap;

use super::{Expr, ExprGraph, Input, NodeId};

/// Numbers of a graph that helpers are given, each once.
#[derive(Debug, Default)]
pub struct Shared {
    numbers: Vec<Expr>,
    places: BTreeMap<NodeId, usize>,
}

impl Shared {
    /// A number that all columns share, in a helper; what is known is written into it.
    pub fn share(&mut self, graph: &ExprGraph, helper: &mut ExprGraph, own: Expr) -> Expr {
        if let Some(number) = graph.as_number(own) {
            return helper.number(number);
        }
        let place = *self.places.entry(own.node()).or_insert_with(|| {
            self.numbers.push(own.abs_sign());
            self.numbers.len() - 1
        });
        helper.input(Input::Shared(place)).signed(own.is_negative())
    }

    /// How many there are.
    pub fn n_numbers(&self) -> usize {
        self.numbers.len()
    }

    /// All of them, by place.
    pub fn numbers(&self) -> Vec<Expr> {
        self.numbers.clone()
    }
}
