//! MJCF, the format of MuJoCo.
//!
//! Bodies stand depth first, in the order of the file, and their frames are those of the file; a body with several
//! joints becomes as many bodies, all but the last without mass. The coordinates are those of MuJoCo, so that `qpos` is
//! `q` but for the order within a free joint. What would change the dynamics of the tree and is not supported is an
//! error; what is left out without a change to them is a warning, or is passed over in silence where it cannot be
//! mistaken for dynamics, such as sensors and materials.
//!
//! Nothing here calls itself: however deep a file, the stack does not grow.

mod angles;
mod around;
mod attach;
mod attributes;
mod bodies;
mod budget;
mod chain;
mod contents;
mod copies;
mod defaults;
mod equalities;
mod files;
mod finite;
mod fit;
mod free_inertia;
mod geom_type;
mod geoms;
mod include;
mod inertial;
mod joint_dynamics;
mod joint_limits;
mod joint_type;
mod joints;
mod known;
mod leaving;
mod lifted;
mod mesh_asset;
mod meshes;
mod mocap;
mod model;
mod models;
mod names;
mod orientation;
mod others;
mod parse;
mod parts;
mod paths;
mod placement;
mod replicate;
mod seat;
mod segment;
mod settings;
mod sites;
mod solid;
mod spring_damper;
mod ties;
mod unknown;

pub use parse::parse;
