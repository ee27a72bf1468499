//! What forces make of the system.
//!
//! In: links, and forces or right-hand sides. Out: accelerations, or the inverse of the mass matrix: motions are eliminated one by
//! one, of articulated bodies or of the mass matrix.

pub(super) mod articulated;
pub(super) mod articulated_inertia;
pub(super) mod carriers;
pub(super) mod exchange;
pub mod forward_dynamics;
pub(super) mod gains;
pub mod hybrid_dynamics;
pub mod inverse_mass;
pub(super) mod prescribed;
