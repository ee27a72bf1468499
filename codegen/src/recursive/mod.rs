//! The same quantities with the sums over bodies re-associated along the tree.
//!
//! In: a [`Tree`](crate::tree::Tree). Out: expressions equal to those of `kane`, with fewer operations.
//! Afterwards: every quantity passes from body to body once, resolved in body axes about body origins, and
//! rotations are applied axis by axis, so that generalized forces are read off on the way.
//! Does not: define anything; `kane` says what the results mean.

pub mod composite;
pub mod frames;
pub mod gravity;
pub mod inertia;
pub mod inverse_dynamics;
