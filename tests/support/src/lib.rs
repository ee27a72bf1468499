//! What the tests of several packages share.
//!
//! Without features: comparisons, seeded numbers, plain linear algebra, and mutants of modules. With `json` the numbers of
//! reference files. With `generator` random systems and the identities that their functions must obey. With `promises` what
//! holds of any text. Nothing here says what a particular test expects.

#![allow(
    missing_docs,
    reason = "fields and methods of tests, named for what they are"
)]

pub mod compare;
#[cfg(feature = "generator")]
pub mod dynamics;
pub mod errors;
#[cfg(feature = "json")]
pub mod json;
pub mod mjcf;
#[cfg(feature = "generator")]
pub mod models;
pub mod mutant;
pub mod numeric;
#[cfg(feature = "promises")]
pub mod promises;
pub mod random;
pub mod rotation;
pub mod shown;
#[cfg(feature = "generator")]
pub mod systems;
pub mod tool;
