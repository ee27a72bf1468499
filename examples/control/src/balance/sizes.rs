//! What there is of the robot, and what is computed with it.

use crate::solo12::NU;

/// What the controller computes in.
pub type Scalar = f64;

pub(super) const FEET: usize = 4;
/// The number of components of the feet's forces.
pub(super) const FORCES: usize = 3 * FEET;
/// The number of the base's speeds, which come first.
pub(super) const ROOT: usize = 6;
pub(super) const MOTORS: usize = NU - ROOT;
