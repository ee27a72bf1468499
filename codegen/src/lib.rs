//! Compiler from multibody systems to flat, allocation-free Rust.
//!
//! ```text
//! description ──> tree ──> expressions on partitions ──> passes ──> program ──> listing ──> source
//! ```
//!
//! [`generate`](generate::generate) is that line in one screen. `kane` (the command) and
//! [`build_script`] call it; nothing else does. Follow one quantity: [`functions`] names it and says how it
//! is derived, [`kane`] and [`recursive`] hold its equations, [`passes`] and [`program`] make them flat, [`listing`] says
//! statement by statement what is done, and [`printers`] write it down.
//!
//! Invariants: a [`Tree`](tree::Tree) obeys every rule a description can break, so nothing after it fails on a
//! user's mistake; nothing here reads a clock, the environment or a hash order, so the same description gives the
//! same bytes everywhere; files are touched only by the command line, [`input`], [`output`], [`build_script`] and `object`,
//! which reads what rustc makes of a module.

// Indexes that cannot be mixed up.
pub mod id;
// Vectors and rotations as numbers.
pub mod geometry;
// Numbers, and numbers with their rounding.
pub mod number;
mod random;
// What can be wrong, and how it is said.
pub mod diagnostic;
pub mod error;
pub mod limits;
// What the user wrote; `kane.toml`.
pub mod budget;
pub mod config;
pub mod description;
// From here on the system is numbered and right.
pub mod tree;
// From here on there are expressions, simplified as they are built.
pub mod expr;
pub mod partition;
// The equations, as they stand and re-associated, and the solution of the linear system.
pub mod kane;
pub mod recursive;
pub mod solve;
// What a user can ask for.
pub mod functions;
// Fewer operations, the same values; then straight-line code.
pub mod compile;
pub mod passes;
pub mod program;
pub mod search;
pub mod size;
mod threads;
// What a module says and does, before any language.
pub mod listing;
mod words;
// From here on there is text.
pub mod build_script;
pub mod companions;
pub mod emit;
pub mod generate;
pub mod input;
pub mod origin;
pub mod output;
pub mod printers;
mod rust;
mod samples;
// What is known of a system, and what changed in a module, for people to read.
pub mod report;
// What is promised of a module's machine code.
#[cfg(feature = "object")]
pub mod object;
