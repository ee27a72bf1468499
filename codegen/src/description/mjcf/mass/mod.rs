//! What bodies weigh: masses and inertias, given or those of shapes.

pub(in crate::description::mjcf) mod fit;
pub(in crate::description::mjcf) mod geom_type;
pub(in crate::description::mjcf) mod geoms;
pub(in crate::description::mjcf) mod inertial;
pub(in crate::description::mjcf) mod segment;
pub(in crate::description::mjcf) mod solid;
pub(in crate::description::mjcf) mod weight;
