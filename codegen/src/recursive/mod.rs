//! The same quantities with the sums over bodies re-associated along the tree.
//!
//! In: a [`Tree`](crate::tree::Tree) and a [`Plan`]. Out: expressions equal to those of `kane`, with fewer operations.
//! Afterwards: every quantity passes from body to body once, resolved in axes about an origin of the plan's choice, and
//! rotations are applied axis by axis, so that generalized forces are read off on the way.
//! Does not: define anything; `kane` says what the results mean. Nor choose the plan: that is `search`'s.

mod ahead;
mod articulated;
mod articulated_inertia;
pub mod body_energies;
mod carriers;
pub mod center;
mod column;
pub mod composite;
pub mod coriolis;
pub mod derivatives;
pub mod energy;
mod exchange;
pub mod forward_dynamics;
pub mod frame;
mod gains;
mod gathered;
pub mod gravity;
pub mod hybrid_dynamics;
mod inertia;
pub mod inverse_dynamics;
pub mod inverse_mass;
pub mod joint_wrench;
mod layout;
mod lever;
mod link;
mod link_axes;
mod link_motion;
mod link_velocity;
mod linkage;
mod loaded;
pub mod mass_matrix_dot;
mod moments;
pub mod momentum;
pub mod momentum_matrix;
mod parallel;
mod passage;
mod plan;
mod prescribed;
pub mod product;
pub mod regressor;
mod regroup;
mod root;
mod rotation;
mod rounding;
mod shortcut;
mod speed_matrix;
mod spreading;
mod turning_axis;
mod wrench;

pub use inertia::sparse_inertias;
pub use parallel::parallel_axes;
pub use plan::{Plan, Regroup, Technique};
