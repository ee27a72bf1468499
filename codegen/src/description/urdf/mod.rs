//! URDF.
//!
//! Links are bodies; the root link hangs from the inertial frame by a joint of our own, fixed or free. The bodies
//! stand depth first from the root, those on one link in the order of their joints' names: the order of urdfdom and
//! of all that is built on it. A URDF has no gravity: it is that of the earth, against z.

mod joint;
mod left_out;
mod link;
mod named;
mod origin;
mod parse;
mod structure;
mod unexpanded;

pub use parse::{is_urdf, parse};
