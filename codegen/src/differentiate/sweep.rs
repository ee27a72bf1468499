//! The two ways through a graph, where a plan chooses.

use super::{
    forward::forward,
    reverse::reverse,
    row::{Row, Seeds},
};
use crate::expr::{Expr, ExprGraph};

/// Which way derivatives are swept for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sweep {
    /// From inputs to roots.
    Forward,
    /// From each root back to inputs.
    Reverse,
}

impl Sweep {
    /// For each root how it changes.
    pub fn rows(self, graph: &mut ExprGraph, roots: &[Expr], seeds: &Seeds) -> Vec<Row> {
        match self {
            Self::Forward => forward(graph, roots, seeds),
            Self::Reverse => reverse(graph, roots, seeds),
        }
    }
}
