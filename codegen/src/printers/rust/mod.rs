//! Rust: the only place that builds its syntax and prints its numbers.
//!
//! In: a listing. Out: the text of one Rust module. Afterwards: the text holds no inner attribute and names only `kane`, `core` and
//! itself, so it compiles as a file, in a module and through `include!`, in editions 2021 and 2024; no `unsafe`, no branch, and
//! no loop and no indexing by a variable but over the columns of a helper (`lockstep`). What is `unsafe` for callers in C stands in a text of its own (`interface`).

mod constants;
mod declarations;
mod derivatives;
mod expression;
mod frames;
mod function;
mod interface;
mod lockstep;
mod module;
mod self_test;
mod signature;
mod stages;
mod statements;
mod steps;
mod structures;
mod syntax;
mod system;
mod text;

pub(crate) use interface::source as interface;
pub(crate) use module::source;
pub(crate) use self_test::self_tests;
