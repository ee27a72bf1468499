//! MJCF.

use crate::description::{Description, Include, Reading};
use crate::diagnostic::Source;

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(_source: &Source, _reading: &Reading, _include: Include<'_>) -> Description {
    unimplemented!()
}
