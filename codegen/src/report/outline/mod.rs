//! What a comparison sees of a system, whether it is a model or a generated module.
//!
//! In: a description with its tree, or a module. Out: an [`Outline`]: names and texts. The values are the user's own,
//! in their frames, not those of the equations.

mod model;
mod module;
mod motions;
mod system;

pub(super) use module::{coordinates, outline};
pub(super) use system::{AXIS, LOWER, Motion, Motions};
pub use system::{Body, Layout, Outline, Values};
