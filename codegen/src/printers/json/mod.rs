//! JSON: the facts of a module, and how its functions are called, for programs that read no other language.

mod arguments;
mod constants;
mod geometry;
mod interface;
mod manifest;
mod pattern;
mod syntax;

pub(crate) use manifest::text as manifest;
