//! Names of elements and attributes: those that are read, and those without influence on the dynamics of the tree.
//!
//! As in MuJoCo 4.0, with some of earlier versions. Of other names there is a warning.

mod assets;
mod beside_bodies;
mod bodies;
mod sections;
mod settings;

pub(super) use assets::MESH;
pub(super) use beside_bodies::{ACTUATOR, EQUALITY, TENDON};
pub(super) use bodies::{ATTACH, BODY, FRAME, FREE_JOINT, GEOM, INERTIAL, JOINT, REPLICATE, SITE};
pub(super) use sections::{
    ACTUATORS, EQUALITIES, IGNORED_IN_BODY, IGNORED_SECTIONS, IN_BODY, SECTIONS,
    UNSUPPORTED_IN_BODY,
};
pub(super) use settings::{COMPILER, DEFAULT, FLAG, OPTION};
