//! The catalogue of functions a user can ask for.
//!
//! In: a text, and the tree of a model. Out: a [`Request`], which says what it is given, what it writes, what that means,
//! and how it is derived. Afterwards: every request derives its outputs in a graph of its own, so its text depends on the
//! model and the options, never on what else is asked for. Does not: emit.

mod argument;
mod arrangement;
mod catalogue;
mod derivation;
mod derivatives;
mod derive_request;
mod derived;
mod entries;
mod formulation;
mod function;
mod multiplier;
mod names;
mod packed;
pub mod parse;
mod part;
mod request;
mod roots;
mod shape;
mod signature;
mod subject;
mod terms;
mod told;
mod unit;
mod variable;

pub use argument::Argument;
pub use arrangement::Arrangement;
pub use catalogue::{CATALOGUE, OF_FRAMES};
pub use derivatives::{
    coloring::colors,
    derivative::{Derivative, DerivativeKind},
    derivative_trait::{DerivativeTrait, TRAITS},
    sparsity::Sparsity,
};
pub use derived::{CompactBlock, Derived, pattern};
pub use formulation::Formulation;
pub use function::{Function, Of, Output, PRESCRIBED};
pub use multiplier::Multiplier;
pub use names::{
    ALL, DEFAULT,
    dictionary::{advice, elsewhere, variable_elsewhere},
    is_set,
};
pub use packed::{ELIMINATION, Packed};
pub(crate) use parse::syntax::split_at;
pub use parse::{
    parsed::{Parsed, Place},
    request_error::RequestError,
    syntax::split,
};
pub use part::{Part, Rows};
pub use request::Request;
pub use shape::{
    Dimension, Element, Length, N_BASE_PARAMETERS, N_BODIES, N_COORDINATES, N_PARAMETERS, N_SPEEDS,
    Shape,
};
pub use signature::{
    Access, Declared, HELPER_INFIX, NOMINAL, PREPARE, PREPARED, PREPARED_NEW, SIN_COS, STAGE_INFIX,
    Signature,
};
pub use subject::{Subject, SubjectFrame, View};
pub use unit::{BySpeed, FORCE, SPEED, Unit};
pub use variable::{PARAMETER_NAMES, PARAMETERS, Variable};
