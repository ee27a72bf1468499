//! How the entries of functions are derived that are not just what equations give: by the files of the catalogue, with what several of
//! them use.
//!
//! In: a tree, and where there are two the way to associate sums over bodies. Out: the entries of all outputs, row-major, in the user's axes.

pub(super) mod coordinates;
pub(super) mod coriolis;
pub(super) mod derivatives;
pub(super) mod dynamics;
pub(super) mod frames;
pub(super) mod hybrid;
pub(super) mod kinematics;
pub(super) mod linear;
pub(super) mod loaded;
pub(super) mod matrices;
pub(super) mod regressor;
pub(super) mod user_axes;
