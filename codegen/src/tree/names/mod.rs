//! Names of bodies, joints and coordinates, and the Rust identifiers that stand for them in generated code.

mod identifiers;
mod rules;
mod shown;

pub(crate) use identifiers::{identifiers, joint_identifiers};
pub(crate) use rules::{check, check_coordinates, note_order};
pub(crate) use shown::{joint_name, shown};
