//! The same quantities with the sums over bodies re-associated along the tree.
//!
//! In: a [`Tree`](crate::tree::Tree) and a [`Plan`]. Out: expressions equal to those of `kane`, with fewer operations.
//! Afterwards: every quantity passes from body to body once, resolved in axes about an origin of the plan's choice, and
//! rotations are applied axis by axis, so that generalized forces are read off on the way.
//! Does not: define anything; `kane` says what the results mean. Nor choose the plan: that is `search`'s.

pub mod articulated;
pub mod axes;
mod blocks;
pub mod composite;
pub mod forward_dynamics;
pub mod frame;
pub mod gravity;
pub mod inertia;
pub mod inverse_dynamics;
mod joint;
pub mod layout;
pub mod link;
mod linkage;
pub mod motion;
mod parallel;
pub mod plan;
mod regroup;
pub mod rotation;
mod rounding;
mod shortcut;

pub use axes::has_followers;
pub use link::{parallel_axes, sparse_inertias};
pub use plan::{Plan, Regroup, Technique};
