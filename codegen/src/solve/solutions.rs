//! Solutions for many right-hand sides, most of which are zero on most branches.

use std::collections::BTreeSet;

use super::{BodySpeed, Carriers, Factors, inverse, reduced::Reduced};
use crate::{
    expr::{Expr, ExprGraph},
    tree::Tree,
};

/// How many columns are solved side by side, so that a compiler makes vectors of them.
const BESIDE: usize = 8;

impl Factors {
    /// The accelerations `x` with `A x = b` for each of several `b`. A branch on which half a solution is zero follows the body
    /// that it is on: what lies between is eliminated from its rows of L once.
    pub fn solutions(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        columns: &[Vec<Expr>],
    ) -> Vec<Vec<Expr>> {
        let carriers = Carriers::default();
        let mut reduced = Reduced::new(self, &carriers);
        let pattern = |graph: &ExprGraph, b: &[Expr]| -> Vec<bool> {
            b.iter().map(|entry| graph.is_zero(*entry)).collect()
        };
        let mut solved = Vec::with_capacity(columns.len());
        let mut rest = columns;
        while let Some(first) = rest.first() {
            let own = pattern(graph, first);
            let alike = rest.iter().take_while(|b| pattern(graph, b) == own);
            let (beside, others) = rest.split_at(alike.take(BESIDE).count());
            solved.extend(self.beside(graph, tree, &mut reduced, beside.to_vec()));
            rest = others;
        }
        solved
    }

    /// The solutions for columns that are zero in the same places, row by row.
    fn beside(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        reduced: &mut Reduced<'_>,
        mut columns: Vec<Vec<Expr>>,
    ) -> Vec<Vec<Expr>> {
        self.eliminate(graph, &mut columns);
        let order = self.order.iter().enumerate();
        let is_half = |k: BodySpeed| {
            let mut halves = columns.iter().map(|half| half[k.index()]);
            halves.any(|half| !graph.is_zero(half))
        };
        let places = order.clone().filter(|(_, k)| is_half(**k));
        let places: BTreeSet<usize> = places.map(|(place, _)| place).collect();
        for (place, &k) in order.rev() {
            let (row, _) = reduced.row(graph, tree, place, &places);
            graph.enter(k.body);
            let inverse = inverse(graph, k, self.pivots[k.index()]);
            for x in &mut columns {
                let mut sum = graph.mul(x[k.index()], inverse);
                for &(other, factor) in &row {
                    let term = graph.mul(factor, x[self.order[other].index()]);
                    sum = graph.add(sum, term);
                }
                x[k.index()] = sum;
            }
        }
        columns
    }
}
