//! What joints feel: wrenches that pass inward, of motion, weight and loads.
//!
//! In: links. Out: a number for each speed, or all that a joint transmits.

pub mod gravity;
pub mod inverse_dynamics;
pub mod joint_wrench;
pub(super) mod loaded;
pub mod product;
pub(super) mod weight;
