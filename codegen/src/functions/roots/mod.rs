//! How functions are derived: for each file of the catalogue one that puts the root expressions together from the equations, and
//! what several of them use.
//!
//! In: a tree, and where there are two the way to associate sums over bodies. Out: the entries of all outputs, row-major, in the user's axes.

pub(super) mod center;
pub(super) mod coordinates;
pub(super) mod coriolis;
pub(super) mod dynamics;
pub(super) mod energy;
pub(super) mod frames;
pub(super) mod hybrid;
pub(super) mod jacobians;
pub(super) mod kinematics;
pub(super) mod linear;
pub(super) mod loaded;
pub(super) mod matrices;
pub(super) mod regressor;
pub(super) mod user_axes;
