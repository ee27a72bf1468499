//! What is found: the matrices of derivatives.

use crate::{
    expr::ExprGraph,
    solve::{SpeedMatrix, zero_matrix},
    tree::Tree,
};

/// How generalized forces change: rows are forces, columns speeds.
#[derive(Clone, Debug)]
pub struct Derivatives {
    /// With the coordinates, along the motions of the speeds.
    pub by_q: SpeedMatrix,
    /// With the speeds.
    pub by_u: SpeedMatrix,
    /// With the accelerations: the mass matrix.
    pub by_u_dot: SpeedMatrix,
}

impl Derivatives {
    pub(super) fn zero(graph: &mut ExprGraph, tree: &Tree) -> Self {
        let zero = zero_matrix(graph, tree.n_speeds);
        Self {
            by_q: zero.clone(),
            by_u: zero.clone(),
            by_u_dot: zero,
        }
    }

    pub(super) fn matrices_mut(&mut self) -> [&mut SpeedMatrix; 3] {
        [&mut self.by_q, &mut self.by_u, &mut self.by_u_dot]
    }
}
