//! What several columns go through alike: a graph `G` of its own, which is run on several of them side by side.
//!
//! A helper computes from numbers that all columns share and from those of one column. A call runs it on as many columns as it has
//! lanes, each by itself. Columns may be those of a matrix, or branches of the tree that are alike.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::node::{CallId, Expr};

/// How many columns of a matrix a call takes: vectors of AVX2 have as many, and fewer than that of a last call are wasted.
pub const LANES: usize = 4;

/// What a column goes through.
#[derive(Clone, Debug)]
pub struct Helper<G> {
    /// On how many columns a call runs it.
    pub lanes: usize,
    /// Its graph, which is given what is shared, and what is of one column.
    pub graph: G,
    /// What it computes.
    pub roots: Vec<Expr>,
}

/// A helper run on columns.
#[derive(Clone, Debug)]
pub struct Call {
    /// The helper, by its place in the lockstep.
    pub helper: usize,
    /// For each number that the helper is given of a column, that of each lane.
    pub sides: Vec<Vec<Expr>>,
}

/// Helpers that share numbers, and their calls.
#[derive(Clone, Debug)]
pub struct Lockstep<G> {
    /// What all columns share.
    pub shared: Vec<Expr>,
    /// The helpers.
    pub helpers: Vec<Arc<Helper<G>>>,
    /// Their calls, by number.
    pub calls: BTreeMap<u16, Call>,
}

impl Call {
    /// All that it reads beside what is shared.
    pub fn operands(&self) -> impl Iterator<Item = Expr> + '_ {
        self.sides.iter().flatten().copied()
    }
}

/// Which locksteps and calls were met while going over a graph.
#[derive(Debug, Default)]
pub(super) struct Met {
    pub(super) locksteps: BTreeSet<u16>,
    pub(super) calls: BTreeSet<CallId>,
}
