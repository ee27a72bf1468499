//! Joints as written become six motions, each free, held or following another, between two constant frames.
//!
//! In: kinds, exact axes, lists of coordinates, and the user's changes. Out: a [`ResolvedJoint`] for every body.
//! Afterwards: no joint contradicts itself, and what follows another follows a free coordinate. Does not: number anything.

mod change;
mod mechanics_rules;
mod mimic;
mod resolve;
mod resolved;
mod rules;

pub(crate) use change::{change, hold};
pub(crate) use mimic::follow;
pub(crate) use resolve::{joints, kind_of};
pub(crate) use resolved::{Freedom, ResolvedJoint};
pub(crate) use rules::{check, check_motions};
