//! The same quantities with the sums over bodies re-associated along the tree.
//!
//! In: a [`Tree`](crate::tree::Tree) and a [`Plan`]. Out: expressions equal to those of `kane`, with fewer operations.
//! Afterwards: every quantity passes from body to body once, resolved in axes about an origin of the plan's choice, and
//! rotations are applied axis by axis, so that generalized forces are read off on the way.
//! Does not: define anything; `kane` says what the results mean. Nor choose the plan: that is `search`'s.

mod articulated;
mod articulated_inertia;
mod column;
pub mod composite;
mod exchange;
pub mod forward_dynamics;
pub mod frame;
pub mod gravity;
mod inertia;
pub mod inverse_dynamics;
mod layout;
mod link;
mod link_axes;
mod link_motion;
mod linkage;
mod parallel;
mod passage;
mod plan;
mod regroup;
mod rotation;
mod rounding;
mod shortcut;
mod turning_axis;
mod wrench;

pub use inertia::sparse_inertias;
pub use parallel::parallel_axes;
pub use plan::{Plan, Regroup, Technique};
