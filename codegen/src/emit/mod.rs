//! Functions whose programs are ready.

use crate::{
    functions::{Block, Formulation, Request},
    program::{Operations, Program},
};

/// A function ready to be emitted.
#[derive(Clone, Debug)]
pub struct Emittable {
    /// What was asked for.
    pub function: Request,
    /// How the sums over bodies are associated.
    pub formulation: Formulation,
    /// The program; its inputs may be prepared values.
    pub program: Program,
    /// Its operations.
    pub operations: Operations,
    /// For compact outputs: the non-zero partitions.
    pub blocks: Vec<Block>,
}
