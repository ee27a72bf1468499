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

// Each module imports only from those that stand before it.

// Indexes that cannot be mixed up, vectors and rotations as numbers, numbers with their rounding, how large things may be.
pub mod geometry;
pub mod id;
pub mod limits;
pub mod number;
mod principal;
mod random;
pub mod threads;
// What languages reserve.
mod words;
// What can be wrong, and how it is shown.
pub mod diagnostic;
// What the user wrote.
pub mod description;
// From here on the system is numbered and right.
pub mod tree;
// From here on there are expressions, simplified as they are built.
pub mod expr;
// How they change with what they are made of.
pub mod differentiate;
// Numbers for what is found or tested by numbers.
pub mod drawn;
pub mod partition;
// The solution of the linear system.
pub mod solve;
// What single bodies and joints give the equations.
pub mod given;
// The equations, as they stand.
pub mod kane;
// The equations, re-associated.
pub mod recursive;
// Which combinations of inertial parameters they depend on.
pub mod base_parameters;
// What can be asked for.
pub mod functions;
// Fewer operations, the same values; then straight-line code.
pub mod passes;
pub mod program;
// What is asked for of one system.
pub mod options;
// Why it cannot be had.
pub mod error;
// Its programs.
pub mod compile;
// Where a module comes from, in hashes and words.
pub mod origin;
// What a module says and does, before any language.
pub mod listing;
// What its functions give in some states.
mod samples;
// From here on there is text.
pub mod printers;
// The files beside a module.
pub mod companions;
// From a description's text to these.
pub mod generate;
// What is asked for of all systems of a repository: `kane.toml`.
pub mod budget;
pub mod config;
// How files of ours are known.
pub mod signs;
// Files.
pub mod input;
pub mod output;
// Cargo.
pub mod build_script;
// Rust of any depth, read or refused.
pub mod rust;
// What is known of a system, and what changed in a module, for people to read.
pub mod report;
// What is promised of a module's machine code.
#[cfg(feature = "object")]
pub mod object;
