//! The catalogue of functions a user can ask for.
//!
//! In: a text, and the tree of a model. Out: a [`Request`], which says what it is given, what it writes, what that means,
//! and how it is derived. Afterwards: every request derives its outputs in a graph of its own, so its text depends on the
//! model and the options, never on what else is asked for. Does not: emit.

mod argument;
mod candidate;
mod catalogue;
mod derive;
mod derive_frame;
mod derived;
mod function;
mod parsed;
mod part;
mod request;
mod request_error;
mod shape;
mod signature;
mod subject;
mod syntax;
mod terms;
mod user_axes;

pub use argument::Argument;
pub use candidate::{Candidate, Formulation};
pub use catalogue::{CATALOGUE, OF_FRAMES};
pub use derived::{Block, Derived, pattern};
pub use function::{FrameFunction, Function, Output};
pub use parsed::{Parsed, Place};
pub use part::Part;
pub use request::Request;
pub use request_error::RequestError;
pub use shape::{Axis, Element, Length, PACKED_LEN, PACKED_PLACES, Shape};
pub use signature::{Access, Declared, Signature};
pub use subject::{Axes, Subject};
pub use syntax::split;
