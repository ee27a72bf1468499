//! Generated modules with one token changed, each with the tests beside it.

#![allow(
    clippy::all,
    clippy::pedantic,
    clippy::restriction,
    missing_docs,
    unused_parens,
    unused_variables,
    dead_code,
    reason = "generated, and made wrong on purpose"
)]

include!(concat!(env!("OUT_DIR"), "/mutants.rs"));
