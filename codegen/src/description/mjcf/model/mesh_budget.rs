//! What the meshes of a model, and of all that are attached, may take.

use std::cell::Cell;

use crate::description::mesh::Effort;

/// What the meshes of all models may take together.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Budget {
    /// Bytes of the files that were read.
    pub(in crate::description::mjcf) bytes: Cell<usize>,
    /// The work that is left.
    pub(in crate::description::mjcf) effort: Cell<Effort>,
}

impl Budget {
    /// All of it.
    pub(in crate::description::mjcf) fn new() -> Self {
        Self {
            bytes: Cell::new(0),
            effort: Cell::new(Effort::new()),
        }
    }
}
