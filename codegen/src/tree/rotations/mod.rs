//! What becomes of the constant rotations and axes of a description.

pub(crate) mod snap;
pub(crate) mod snapping;
