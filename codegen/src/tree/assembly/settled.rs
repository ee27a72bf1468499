//! What is settled before a tree is put together.

use crate::description::Description;
use crate::tree::joints::ResolvedJoint;
use crate::tree::numbering::Outward;
use crate::tree::rotations::ConstantRotations;

/// A description whose bodies form a tree and whose joints stand.
#[derive(Clone, Copy)]
pub(crate) struct Settled<'a> {
    pub(crate) description: &'a Description,
    pub(crate) outward: &'a Outward,
    /// Of each body, by its place in the user's list.
    pub(crate) joints: &'a [ResolvedJoint],
    /// Of each body, by its place in the user's list.
    pub(crate) rotations: &'a [ConstantRotations],
    /// How near to 0, 1 or -1 entries of constant rotations are made exact.
    pub(crate) snap: f64,
}
