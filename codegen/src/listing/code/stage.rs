//! Parts of what is too long for one function, or for one loop.

use super::{Code, Expression};
use crate::functions::Signature;

/// A part of a long function, or of a long loop.
#[derive(Clone, Debug)]
pub struct Stage {
    /// How it is declared: it is given those of the function's arguments that it needs.
    pub signature: Signature,
    /// Which those are, by their places.
    pub given: Vec<usize>,
    /// The earlier stages, by their places, of which it needs what they keep.
    pub earlier: Vec<usize>,
    /// What it does.
    pub code: Code,
    /// What the function calls what it returns.
    pub keeps: String,
    /// What it returns for later stages.
    pub kept: Vec<Kept>,
}

/// A number that passes from stage to stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// Its name.
    pub name: String,
    /// A local, or an element of a local array.
    pub value: Expression,
}
