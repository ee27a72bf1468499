//! States, and what functions give there, as numbers.

use std::collections::BTreeMap;

use crate::functions::Argument;

/// A state, and what else functions are given there.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// Values of the parameters.
    pub(crate) parameters: Vec<f64>,
    /// The numbers of every argument, one after the other.
    pub(super) arguments: BTreeMap<Argument, Vec<f64>>,
}

impl Sample {
    /// The numbers of an argument, one after the other.
    pub(crate) fn of(&self, argument: Argument) -> &[f64] {
        &self.arguments[&argument]
    }
}

/// What a function writes.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    /// For every state the numbers of every output, each with how far from it a function may be.
    pub(crate) values: Vec<Vec<Vec<(f64, f64)>>>,
    /// The lengths of every output's nested arrays.
    pub(crate) lengths: Vec<Vec<usize>>,
    /// How many entries of an output are summed to one number.
    pub(crate) entries: Vec<usize>,
}
