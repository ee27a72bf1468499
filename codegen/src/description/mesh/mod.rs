//! Triangle meshes: what they are made of, and what they weigh.
//!
//! In: the bytes of a file, or lists of points and faces. Out: a [`Surface`], and of it a [`MeshShape`]: volume, mass centre,
//! principal axes and moments. Afterwards: coordinates are finite, every face names points that are there, and the moments
//! are those of a body. Does not: open files, or know what names a mesh.
//!
//! Numbers follow MuJoCo's algorithms step by step, its rounding of points to single precision among them, so that masses and
//! inertias are those that it simulates. What cannot be had is a [`Fault`]: what was found, and what to do.

mod effort;
mod fault;
mod format;
mod hull;
mod msh;
mod obj;
mod oriented;
mod polygon;
mod principal;
mod shape;
mod stl;
mod stl_text;
mod sums;
mod surface;
mod text;

pub(crate) use effort::Effort;
pub(crate) use fault::Fault;
pub(crate) use format::Format;
pub(crate) use obj::MOST_CORNERS;
pub(crate) use shape::{Change, Filling, MeshShape, shape};
pub(crate) use surface::Surface;
