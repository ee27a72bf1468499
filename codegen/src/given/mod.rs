//! What an equation is given, of single bodies and joints: the foundation of both formulations.
//!
//! In: a [`Tree`](crate::tree::Tree). Out: expressions of its numbers, coordinates, speeds and loads, of how one joint turns its
//! body, and of what acts in it. Afterwards: all of it is in internal axes, whatever the user's are.
//! Does not: sum over bodies; `kane` and `recursive` do, each in its way.

mod frame;
mod joint;
mod loads;
mod mass;
pub mod mechanics;
mod numbers;
pub mod orientation;

pub use frame::{
    FrameMotion, FramePose, FrameWrench, frame_force, frame_origin, frame_point, frame_rotation,
    frame_wrench,
};
pub use joint::{
    Accelerations, acceleration, attachment, coordinate, offset, shift_directions, shift_speeds,
    speed,
};
pub use loads::{Loads, force, moment, relative_angular_velocity};
pub use mass::{
    Lifted, inertia, inertial_parameters, inverse_total_mass, lifted, mass, mass_center,
    over_total_mass, part_inertia,
};
pub use numbers::{acting_gravity, constant, constant_back, fixed, gravity, value, vector};
