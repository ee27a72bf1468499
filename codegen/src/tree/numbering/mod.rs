//! The numbers of bodies, and the places of coordinates in `q` and of speeds in `u`.

pub(crate) mod bodies;
pub(crate) mod coordinates;
