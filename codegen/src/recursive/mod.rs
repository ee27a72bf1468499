//! The same quantities with the sums over bodies re-associated along the tree.
//!
//! In: a [`Tree`](crate::tree::Tree) and a [`Plan`]. Out: expressions equal to those of `kane`, with fewer operations.
//! Afterwards: every quantity passes from body to body once, resolved in axes about an origin of the plan's choice, and
//! rotations are applied axis by axis, so that generalized forces are read off on the way.
//! Does not: define anything; `kane` says what the results mean. Nor choose the plan: that is `search`'s.

pub mod accelerations;
pub mod derivatives;
pub mod forces;
pub mod frame;
mod links;
pub mod matrices;
mod plan;
pub mod regressor;
mod technique;
pub mod totals;

pub use links::{inertia::sparse_inertias, parallel::parallel_axes};
pub use plan::{Plan, Regroup};
pub use technique::Technique;
