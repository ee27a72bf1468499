//! Every free coordinate must move mass, or the mass matrix is singular in every state.
//!
//! In: a tree whose masses and joints are right. Out: an error for each coordinate, or combination of coordinates,
//! that moves none. Does not: judge single states; a chart that is singular in some is no fault here.
//!
//! Kinetic energy is ½|K V|² with a few rows K over the twist V of each body. From the tips inward, the rows of
//! a body are those of its own mass and of its bodies beyond; what its joint's columns B = K S can take up of them
//! is projected out, B = Q R by Gram and Schmidt with pivots, and the rest is passed on to the lower body. A column
//! without pivot moves no mass when the others move with it as they like. Square roots of energies are compared, not
//! energies, and each with what it could be at most, so that a part in 1e10 in the one is safe from rounding. All
//! this happens at a few seeded states, and the state with the fewest such columns counts.

mod definite;
mod following;
mod idle;
mod kinematics;
mod masses;
mod oversized;
mod report;
mod response;
mod rows;
mod sweep;
mod units;

pub(crate) use idle::holdable;
pub use idle::idle_motions;
pub(crate) use report::{check, is_massless};
pub(crate) use units::Units;
