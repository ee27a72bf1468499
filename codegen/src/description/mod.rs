//! What the user wrote, as plain data.
//!
//! In: a file in one of the formats. Out: a [`Description`], every value with its place in the file.
//! Afterwards: values have the right types and lengths; a value that has not, or is missing where it must
//! not be, is `None` and stands in [`Description::faults`]. Does not: check what the values mean; that is
//! [`tree::build`](crate::tree::build), which reports its own findings together with these.
//!
//! Reading never fails: a file that is no description at all is an empty description with faults.

mod body;
mod coordinate_name;
mod format;
mod frame;
mod joint;
mod reading;
mod size;
mod system;
mod value;

pub mod mjcf;
pub mod toml;
pub mod urdf;

pub(crate) mod cycles;
mod elsewhere;
pub(crate) mod lfs;
mod mesh;
pub(crate) mod toml_reader;
pub(crate) mod xml;

pub use body::{INERTIA_COMPONENTS, WrittenBody};
pub use coordinate_name::CoordinateName;
pub use format::{left_open, read};
pub use frame::{Carrier, FrameRotation, WrittenFrame};
pub(crate) use joint::on_angular_velocity;
pub use joint::{Chart, JointKind, Mimic, Speeds, WrittenJoint};
pub(crate) use reading::utf8;
pub use reading::{Base, Include, LeftOut, Reading, no_includes};
pub(crate) use size::{too_large, too_many};
pub use system::{Description, Order};
pub use value::{Given, Limits, Optional, PerCoordinate, Scalar};

pub use crate::geometry::Rotation;
