//! The tree of a description in which nothing is missing: bodies with all that is fixed to them, in axes of our choice.

mod assemble;

pub(crate) use assemble::assemble;
