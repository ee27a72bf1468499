//! What the inverse of a factorised matrix is to rows over the speeds.

use super::{Factors, SpeedMatrix, zero_matrix};
use crate::expr::{Expr, ExprGraph};

impl Factors {
    /// `J A^-1 J^T` for the rows of J: with `Y = L^-T J^T` it is `Y^T D^-1 Y`, symmetric, so that half a solution is enough.
    pub fn projected(&self, graph: &mut ExprGraph, rows: Vec<Vec<Expr>>) -> SpeedMatrix {
        let halves = rows.into_iter().map(|row| self.eliminated(graph, row));
        let halves: Vec<Vec<Expr>> = halves.collect();
        let mut projected = zero_matrix(graph, halves.len());
        for (i, half) in halves.iter().enumerate() {
            let scaled = self.scaled(graph, half);
            for (j, other) in halves[..=i].iter().enumerate() {
                let mut sum = graph.zero();
                for (&a, &b) in scaled.iter().zip(other) {
                    let term = graph.mul(a, b);
                    sum = graph.add(sum, term);
                }
                projected[i][j] = sum;
                projected[j][i] = sum;
            }
        }
        projected
    }
}
