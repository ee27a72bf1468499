//! Compiler from models of robots and other multibody systems to plain Rust functions for their dynamics.
//!
//! Most users run the command `kane` of this package. A build script uses [`build_script::Build`]. A program that generates text
//! itself calls [`generate`](generate::generate):
//!
//! ```
//! use kane_codegen::{description::no_includes, diagnostic::Source, generate::generate, options::Options};
//!
//! let model = r#"
//!     name = "pendulum"
//!     gravity = [0.0, 0.0, -9.81]
//!     lower_bodies = [0]
//!
//!     [[body]]
//!     name = "rod"
//!     mass = 2.0
//!     mass_center = [0.0, 0.0, -0.5]
//!     inertia = { xx = 0.2, yy = 0.2, zz = 0.01, xy = 0.0, xz = 0.0, yz = 0.0 }
//!     attachment = [0.0, 0.0, 0.0]
//!     joint = ["theta1"]
//! "#;
//! let source = Source::new("pendulum.toml", model);
//! let generated = generate(&source, "pendulum.toml", &Options::default(), &no_includes)?;
//! assert!(generated.source.contains("pub fn forward_dynamics<R: kane::Real>("));
//! # Ok::<(), kane_codegen::error::Error>(())
//! ```
//!
//! # The stages
//!
//! ```text
//! description ──> tree ──> expressions on partitions ──> passes ──> program ──> listing ──> source
//! ```
//!
//! | stage | modules |
//! | --- | --- |
//! | Read a model, and collect every fault with its place. | [`description`], [`diagnostic`] |
//! | Check all rules; number bodies, coordinates and parameters. | [`tree`] |
//! | Turn equations into expressions: literally, and again with sums over bodies re-associated along the tree. | [`kane`], [`recursive`] |
//! | Pick the form that costs less for each requested function. | [`functions`], [`compile`] |
//! | Turn expressions into straight-line code. | [`passes`], [`program`] |
//! | Name the values, and print the code as Rust, C and JSON. | [`listing`], [`printers`] |
//!
//! Three rules hold everywhere. A [`Tree`](tree::Tree) obeys every rule that a description can break, so no later stage fails because of
//! a user's mistake. Nothing that decides the text reads a clock, the environment or a hash order, so the same description gives the same bytes everywhere.
//! Only the command line, [`input`], [`output`], [`build_script`] and `object` touch files; `object` reads what rustc makes of a module.

// Each module imports only from those that stand before it.

// Names of choices, indexes that cannot be mixed up, vectors and rotations as numbers, numbers with their rounding, how large things
// may be.
pub mod choices;
pub mod geometry;
pub mod id;
pub mod limits;
pub mod number;
mod principal;
mod random;
pub mod threads;
// Steps of the runtime that C has; what languages reserve, and which names are taken.
mod steps;
mod taken;
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
// What could be saved.
pub mod rounded_angles;
// What is asked for of all systems of a repository: `kane.toml`.
pub mod budget;
pub mod config;
// How files of ours are known.
pub mod ownership;
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
