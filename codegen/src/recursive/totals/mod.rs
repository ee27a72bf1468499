//! Sums over all bodies: their mass centre, momentum and energies.
//!
//! In: links. Out: vectors along the inertial axes; energies, of all or body by body.

mod axes;
pub mod body_energies;
pub mod center;
pub mod changes;
pub mod energy;
pub mod momentum;
pub mod momentum_matrix;
pub(in crate::recursive) mod stands;
