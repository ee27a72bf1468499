//! The order of bodies, and the places of coordinates in `q` and of speeds in `u`.

mod bodies;
mod coordinates;

pub(crate) use bodies::{Outward, note_moved, outward};
pub(crate) use coordinates::{JointCoordinates, Numbered, number};
