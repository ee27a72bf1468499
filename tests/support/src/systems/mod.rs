//! Seeded random systems, as descriptions.
//!
//! In: a seed, sizes and a style. Out: a [`RandomSystem`] that the generator accepts, the same on every machine.
//! Afterwards: free coordinates, locked values, roots, numbering, gravity, order and runtime values are all random; some
//! bodies are points, some weigh nothing, some are fixed; with [`Style::Framed`] also frames on both sides of joints, their
//! kinds, charts, speeds, mechanics and what follows what. Candidates with a coordinate that moves no mass are skipped.

mod body;
mod draw;
mod joints;
mod system;
pub mod trees;
mod variants;

pub use system::{RandomSystem, Sizes, Style, tree};
