//! Solutions for many right-hand sides, most of which are zero on most branches.

use std::collections::BTreeSet;

use super::{Carriers, Factors, inverse, reduced::Reduced};
use crate::{
    expr::{Expr, ExprGraph},
    tree::Tree,
};

impl Factors {
    /// The accelerations `x` with `A x = b` for each of several `b`. A branch on which half a solution is zero follows the body
    /// that it is on: what lies between is eliminated from its rows of L once.
    pub fn solutions(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        columns: impl IntoIterator<Item = Vec<Expr>>,
    ) -> Vec<Vec<Expr>> {
        let carriers = Carriers::default();
        let mut reduced = Reduced::new(self, &carriers);
        let columns = columns.into_iter();
        columns
            .map(|b| self.solution(graph, tree, &mut reduced, b))
            .collect()
    }

    fn solution(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        reduced: &mut Reduced<'_>,
        b: Vec<Expr>,
    ) -> Vec<Expr> {
        let half = self.eliminated(graph, b);
        let order = self.order.iter().enumerate();
        let places = order
            .clone()
            .filter(|(_, k)| !graph.is_zero(half[k.index()]));
        let places: BTreeSet<usize> = places.map(|(place, _)| place).collect();
        let mut x = vec![graph.zero(); half.len()];
        for (place, &k) in order.rev() {
            let (row, _) = reduced.row(graph, tree, place, &places);
            graph.enter(k.body);
            let inverse = inverse(graph, k, self.pivots[k.index()]);
            let mut sum = graph.mul(half[k.index()], inverse);
            for (other, factor) in row {
                let term = graph.mul(factor, x[self.order[other].index()]);
                sum = graph.add(sum, term);
            }
            x[k.index()] = sum;
        }
        x
    }
}
