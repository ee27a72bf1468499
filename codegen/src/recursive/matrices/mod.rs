//! Matrices with a number for each pair of speeds, of composite bodies.
//!
//! In: links. Out: a [`SpeedMatrix`](crate::solve::SpeedMatrix). Each speed has a column, which passes inward and has its entries
//! read off at the joints.

pub(super) mod axes_below;
pub(super) mod column;
pub mod composite;
pub mod coriolis;
pub(super) mod gathered;
pub(super) mod lever;
pub mod mass_matrix_dot;
pub(super) mod moments;
pub(super) mod shortcut;
pub(super) mod speed_matrix;
pub(super) mod spreading;
