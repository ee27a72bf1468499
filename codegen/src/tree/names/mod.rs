//! Names of bodies, joints and coordinates, and the Rust identifiers that stand for them in generated code.

mod frames;
mod identifiers;
mod lookup;
mod rules;
mod shown;

pub(crate) use frames::check_frames;
pub(crate) use identifiers::{frame_identifiers, identifiers, joint_identifiers, note_joints};
pub(crate) use lookup::{joint_named, meant};
pub(crate) use rules::{check, check_coordinates, note_order};
pub(crate) use shown::{by_joints, joint_name, shown, shown_by_joint, shown_joint};
