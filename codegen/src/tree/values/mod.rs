//! The numbers of a description become values: baked in, or parameters that the user sets at run time.
//!
//! In: numbers as written, and the body of the tree to which each belongs. Out: [`Values`], of which none is missing.
//! Afterwards: every parameter has a name of its own. Does not: move anything into other axes.

mod bodies;
mod frames;
mod mechanics;
mod parameters;

pub(crate) use bodies::{BodyValues, HostedBody, Values, values};
pub(crate) use frames::{FrameValues, KnownFrame};
