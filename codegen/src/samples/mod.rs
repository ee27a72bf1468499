//! States in which functions are tested, and what the equations give there.
//!
//! In: a tree, its programs, its listing. Out: [`Sample`]s and [`Sampled`] values, the same on every machine. Afterwards: every number
//! is finite, with how far a function may be from it. Does not: write tests; printers do.

mod draw;
mod sample;
mod values;

pub(crate) use sample::{Sample, Sampled};
pub(crate) use values::of;
