//! The catalogue of functions a user can ask for.
//!
//! In: a text, and the tree of a model. Out: a [`Request`], which says what it is given, what it writes, what that means,
//! and how it is derived. Afterwards: every request derives its outputs in a graph of its own, so its text depends on the
//! model and the options, never on what else is asked for. Does not: emit.

mod argument;
mod candidate;
mod catalogue;
mod coloring;
mod derivative;
mod derivative_trait;
mod derive;
mod derive_accelerations;
mod derive_center;
mod derive_coriolis;
mod derive_derivatives;
mod derive_energy;
mod derive_frame;
mod derive_hybrid;
mod derive_loaded;
mod derive_matrices;
mod derive_regressor;
mod derived;
mod dictionary;
mod function;
mod generated_name;
mod jacobians;
mod multiplier;
mod names_elsewhere;
mod packed;
mod parsed;
mod parsed_subject;
mod part;
mod request;
mod request_error;
mod shape;
mod signature;
mod solved;
mod sparsity;
mod subject;
pub mod syntax;
mod terms;
mod user_axes;
mod variable;

pub use argument::Argument;
pub use candidate::{Candidate, Formulation};
pub use catalogue::{CATALOGUE, OF_FRAMES};
pub use coloring::colors;
pub use derivative::{Derivative, DerivativeKind};
pub use derivative_trait::TRAITS;
pub use derived::{CompactBlock, Derived, pattern};
pub use dictionary::{advice, elsewhere, variable_elsewhere};
pub use function::{Function, Of, Output, PRESCRIBED};
pub use multiplier::Multiplier;
pub use packed::{ELIMINATION, Packed};
pub use parsed::{Parsed, Place};
pub use part::{Part, Rows};
pub use request::Request;
pub use request_error::RequestError;
pub use shape::{
    Dimension, Element, Length, N_BASE_PARAMETERS, N_BODIES, N_COORDINATES, N_PARAMETERS, N_SPEEDS,
    Shape,
};
pub use signature::{Access, Declared, Signature};
pub use sparsity::Sparsity;
pub use subject::{Subject, SubjectFrame, View};
pub use syntax::split;
pub use variable::{PARAMETER_NAMES, Variable};
