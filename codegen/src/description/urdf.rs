//! URDF.

use crate::description::xml;
use crate::description::{Description, Reading};
use crate::diagnostic::Source;

/// True for a file whose root element is `robot`.
pub fn is_urdf(source: &Source) -> bool {
    xml::root_name(source.text()) == Some("robot")
}

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(_source: &Source, _reading: &Reading) -> Description {
    unimplemented!()
}
