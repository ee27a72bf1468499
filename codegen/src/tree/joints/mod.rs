//! Joints as written become six motions, each free, held or following another, between two constant frames.
//!
//! In: kinds, axes, lists of coordinates, and the user's changes. Out: a [`Resolved`](resolve::Resolved) joint for every
//! body. Afterwards: no joint contradicts itself, and what follows another follows a free coordinate. Does not: number
//! anything.

pub(crate) mod mimic;
pub(crate) mod resolve;
pub(crate) mod rules;
