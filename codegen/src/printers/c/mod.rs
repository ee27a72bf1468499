//! C: headers that declare functions, whatever they are written in.
//!
//! In: a listing, and the name of the module. Out: the text of a header for C99 and C++; what a header declares. Does not: define a function.

mod data;
mod declared;
mod header;
mod identifiers;
mod names;
pub(super) mod rules;
pub(super) mod runtime;
mod steps;
mod text;

pub use header::text as header;
pub use identifiers::identifiers;
