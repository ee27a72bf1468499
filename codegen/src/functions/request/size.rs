//! How large a request is: what it writes, and what deriving it takes.

use std::collections::BTreeSet;

use super::Request;
use crate::{
    functions::{
        function::{Function, MassMatrixUse},
        part::Rows,
        terms,
    },
    solve,
    tree::Tree,
};

impl Request {
    /// About how many operations a factorisation for it and a solution need.
    pub fn factorising(&self, tree: &Tree) -> usize {
        let takes_more = |function: &&Function| function.mass_matrix != MassMatrixUse::None;
        let mut solving = self.functions().filter(takes_more);
        if solving.all(|function| function.prescribes) {
            // The matrix is made of all speeds, also of those that are prescribed.
            solve::operations(tree, &tree.prescribed) + terms::pairs(tree)
        } else {
            solve::operations(tree, &BTreeSet::new())
        }
    }

    /// How many terms the notes' sums have at least: where another formulation needs fewer operations than that, the notes'
    /// need not be derived to know which is cheaper. Parts may have all theirs in common.
    pub fn literal_terms(&self, tree: &Tree) -> usize {
        let terms = self.parts.iter().map(|part| part.literal_terms(tree));
        terms.max().unwrap_or(0)
    }

    /// How many numbers it writes at most: what takes a while to find is bounded.
    pub fn n_numbers(&self, tree: &Tree) -> usize {
        self.parts.iter().map(|part| part.n_numbers(tree)).sum()
    }

    /// As [`Self::n_numbers`], of the parts that solve.
    pub fn n_solved(&self, tree: &Tree) -> usize {
        let parts = self.parts.iter().filter(|part| part.function.solves());
        parts.map(|part| part.n_numbers(tree)).sum()
    }

    /// How many variables second derivatives have, all together.
    pub fn n_second(&self, tree: &Tree) -> usize {
        let parts = self.parts.iter().filter(|part| part.is_second_derivative());
        parts.map(|part| part.n_variables(tree)).sum()
    }

    /// How many operations second derivatives build, about, before what is zero or alike falls away. `is_direct`: accelerations are
    /// differentiated without sweeps through the solver.
    pub fn n_second_operations(&self, tree: &Tree, is_direct: bool) -> usize {
        let parts = self.parts.iter().filter(|part| part.is_second_derivative());
        parts
            .map(|part| part.n_second_operations(tree, is_direct))
            .sum()
    }

    /// As [`Self::n_numbers`], of the parts that are derivatives.
    pub fn n_differentiated(&self, tree: &Tree) -> usize {
        let parts = self.parts.iter().filter(|part| part.derivative.is_some());
        parts.map(|part| part.n_numbers(tree)).sum()
    }

    /// How many rows each way to sweep for its derivatives carries along.
    pub fn swept_rows(&self, tree: &Tree) -> Rows {
        let parts = self.parts.iter().map(|part| part.swept_rows(tree));
        parts.fold(Rows::default(), |sum, rows| Rows {
            forward: sum.forward + rows.forward,
            reverse: sum.reverse + rows.reverse,
        })
    }
}
