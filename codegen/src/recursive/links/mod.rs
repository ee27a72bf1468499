//! Bodies as the recursion sees them, how they move, and the way through their joints.
//!
//! In: a tree and a plan. Out: links, each with its inertia about an origin, along axes, of the plan's choice; their velocities and
//! accelerations. Afterwards: `passage` is the one place that walks through a joint; whatever passes it, a wrench too, is a passenger.

pub(super) mod inertia;
pub(super) mod layout;
pub(super) mod link;
pub(super) mod link_axes;
pub(super) mod link_motion;
pub(super) mod link_velocity;
pub(super) mod linkage;
pub(super) mod parallel;
pub(super) mod passage;
pub(super) mod regroup;
pub(super) mod root;
pub(super) mod rotation;
pub(super) mod rounding;
pub(super) mod totalled;
pub(super) mod turning_axis;
pub(super) mod wrench;
