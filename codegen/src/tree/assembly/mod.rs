//! A whole tree of a description whose bodies form one and whose joints stand.
//!
//! In: what is [`Settled`]. Out: the tree: bodies with all that is fixed to them, along axes of our choice. Afterwards:
//! nothing is missing. Does not: judge whether all coordinates move mass.

mod assemble;
mod bodies;
mod markers;
mod merging;
mod placing;
mod settled;

pub(crate) use assemble::assemble;
pub(crate) use settled::Settled;
