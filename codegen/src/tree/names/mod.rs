//! Names of bodies, joints and coordinates, and the Rust identifiers that stand for them in generated code.

mod identifiers;

pub(crate) use identifiers::{
    check, check_coordinates, identifiers, is_keyword, joint_identifiers, note_order,
    of_coordinate, shown,
};
