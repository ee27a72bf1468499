//! Sums over all bodies: their mass centre, momentum and energies.
//!
//! In: links. Out: components along the inertial axes; of energies, also one number a body.

pub mod body_energies;
pub mod center;
pub mod energy;
pub mod momentum;
pub mod momentum_matrix;
