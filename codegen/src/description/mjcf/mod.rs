//! MJCF, the format of MuJoCo.
//!
//! Bodies stand depth first, in the order of the file, and their frames are those of the file; a body with several
//! joints becomes as many bodies, all but the last without mass. The coordinates are those of MuJoCo, so that `qpos` is
//! `q` but for the order within a free joint. What would change the dynamics of the tree and is not supported is an
//! error; what is left out without a change to them is a warning, or is passed over in silence where it cannot be
//! mistaken for dynamics, such as sensors and materials.
//!
//! Nothing here calls itself: however deep a file, the stack does not grow.

mod beside_bodies;
mod bodies;
mod chain;
mod contents;
mod degrees;
mod equalities;
mod files;
mod finite;
mod fused;
mod joints;
mod known;
mod left_out;
mod lifted;
mod mass;
mod model;
mod names;
mod orientation;
mod parse;
mod placement;
mod sites;
mod unknown;

pub(crate) use joints::ties::holding;
pub use parse::parse;
