//! The inverse of a mass matrix, from its factors.
//!
//! With `A = L^T D L` is `L A^-1 = D^-1 L^-T`, whose right-hand side is zero unless the row's speed is the column's or farther
//! in on its branch. So `H_ij = [1 / D_i where i = j] - sum_a L_ia H_aj` follows from rows farther in, and one triangle is the
//! mirror image of the other. What lies between a speed and a body farther in is
//! eliminated from its row of L once, and serves the columns of that body and of all other branches on it.

use super::{BodySpeed, Carriers, Factors, SpeedMatrix, felt::Felt, inverse, reduced::Reduced};
use crate::{
    expr::{Expr, ExprGraph, Purpose},
    id::SpeedId,
    tree::Tree,
};

impl Factors {
    /// `A^-1`; what is structurally zero is the number zero. What branches feel passes through the carriers that
    /// [`factorise_on_carriers`](super::factorise_on_carriers) was given.
    pub fn inverse(&self, graph: &mut ExprGraph, tree: &Tree, carriers: &Carriers) -> SpeedMatrix {
        self.inverse_but(graph, tree, carriers, &[])
    }

    /// The same without the rows and columns of some speeds, which stay zero. Nothing else may be eliminated before these.
    pub fn inverse_but(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        carriers: &Carriers,
        left_out: &[SpeedId],
    ) -> SpeedMatrix {
        graph.begin(Purpose::Inverse);
        let n = self.order.len();
        let is_left_out = |place: usize| left_out.contains(&self.order[place].speed);
        let mut reduced = Reduced::new(self, carriers);
        let mut felt = Felt::new(tree, carriers);
        let mut h = vec![vec![graph.zero(); n]; n];
        for i in (0..n).rev() {
            for j in (i..n).rev() {
                if is_left_out(i) || is_left_out(j) {
                    continue;
                }
                let (own, other) = (self.order[i], self.order[j]);
                graph.enter(own.body);
                let (row, foot) = reduced.row(graph, tree, i, &reduced.path(j));
                let row = row.into_iter().map(|(a, factor)| (self.order[a], factor));
                let row: Vec<(BodySpeed, Expr)> = row.collect();
                graph.enter(own.body);
                let mut sum = graph.zero();
                if i == j {
                    sum = inverse(graph, own, self.pivots[own.index()]);
                }
                let carrier = felt.carrier(own.body, foot).filter(|_| !row.is_empty());
                for &(a, factor) in &row {
                    if carrier.is_none() || !carriers.contains(a.body) {
                        let term = graph.mul(factor, h[a.index()][other.index()]);
                        sum = graph.add(sum, term);
                    }
                }
                if let Some(carrier) = carrier {
                    let share = felt.share(graph, &h, (own, &row), carrier, other.index());
                    sum = graph.add(sum, share);
                }
                let at = &tree.body(other.body).identifier;
                let place = format!("h_{}_{at}_{}", own.coordinate, other.coordinate);
                graph.name(sum, place);
                h[own.index()][other.index()] = sum;
                h[other.index()][own.index()] = sum;
            }
        }
        h
    }
}
