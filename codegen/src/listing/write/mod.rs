//! From programs to functions: which statements, in what order, under which names.

use std::collections::BTreeMap;

use super::Step;
use crate::expr::Input;

mod given_names;
mod group;
mod headings;
mod helper;
mod input_names;
mod loops;
mod name;
mod plain;
mod scratch;
mod signatures;
mod stages;
mod statements;
mod stores;
mod writer;

pub use name::RESERVED;
pub(super) use plain::{nominal, sin_cos};
pub(super) use writer::FunctionWriter;

/// Where inputs of a program stand: the argument, by its name, and the place in it.
type InputPlaces = BTreeMap<Input, (&'static str, Vec<Step>)>;
