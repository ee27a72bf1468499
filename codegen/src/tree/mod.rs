//! The checked, numbered tree of bodies.
//!
//! In: a [`Description`](crate::description::Description), as the user wrote it. Out: a [`Tree`].
//! Afterwards: every lower body (parent) has a smaller id than its bodies, every name is unique and
//! maps to a unique Rust identifier, every number is finite where the description is as readers leave it, no mass is negative, inertias are as given (a warning tells of
//! those that no real body has), and every free coordinate moves mass; later stages do not fail on a user's mistake.
//! Does not: derive anything.
//!
//! What a file says is `Written`: [`WrittenBody`](crate::description::WrittenBody),
//! [`WrittenJoint`](crate::description::WrittenJoint). What the tree holds has the short name: [`Body`], [`Joint`]. The
//! choice of a [`Chart`](crate::description::Chart) becomes [`ChartCoordinates`] with places in `q`.

// What a tree is.
mod base_parameter;
mod body;
mod drawn;
mod frames;
mod inertial;
mod joint;
mod mechanics;
mod offset;
mod system;
mod value;

// How a description becomes one: `build` is the order, the others are its stages.
mod assembly;
mod build;
mod changes;
mod friction;
mod inertia;
mod joints;
mod lifted;
mod massless;
mod mobility;
mod names;
mod negligible;
mod nonzeros;
mod numbering;
mod rotations;
mod units;
mod values;

// What is read off a tree, or marked in it.
mod angles;
mod canonical;
mod joint_kind;
mod named;
mod prescribed;
mod regressor_places;
mod seen;
mod user_parts;

pub use crate::description::Order;
pub use crate::principal::principal;
pub use angles::Angle;
pub use base_parameter::{BaseParameter, BaseParameters};
pub use body::{Body, Inertia, Pose, RigidPart};
pub use build::{Checked, build, build_with};
pub use canonical::{canonical, canonical_frame};
pub use changes::Changes;
pub use frames::Frame;
pub use inertial::{InertialParameter, N_INERTIAL};
pub use joint::{
    Attitude, ChartCoordinates, Coordinate, CoordinateKind, Joint, Motion, Orientation,
};
pub use mechanics::Mechanics;
pub(crate) use mobility::Units;
pub use mobility::idle_motions;
pub use named::NamedFrame;
pub use offset::{Offset, Step};
pub use prescribed::{PrescribedFault, prescribe};
pub use regressor_places::{regressor_place, regressor_places};
pub use rotations::{Alignment, NearlyExact, nearly_exact, orthonormal, snapped, snapped_sin_cos};
pub use system::Tree;
pub use user_parts::user_parts;
pub use value::{Parameter, Value};
