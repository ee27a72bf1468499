//! The numbers of a description, baked in or set at run time.

pub(crate) mod mechanics;
pub(crate) mod parameters;
