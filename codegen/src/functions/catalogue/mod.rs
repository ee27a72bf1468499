//! The functions, in the order in which a module holds them.

mod coordinates;
mod dynamics;
mod energy;
mod frames;
mod kinematics;

use super::function::{FrameFunction, Function};

/// Every function of the whole system that a user can ask for, in the order in which a module holds them.
pub static CATALOGUE: [Function; 33] = [
    kinematics::RELATIVE_ROTATION,
    kinematics::ROTATION,
    kinematics::RELATIVE_ANGULAR_VELOCITY,
    kinematics::ANGULAR_VELOCITY,
    coordinates::ANGLE_RATES,
    kinematics::ANGULAR_ACCELERATION,
    kinematics::PARTIAL_ANGULAR_VELOCITY,
    kinematics::PARTIAL_ANGULAR_VELOCITY_DOT,
    kinematics::ORIGIN_POSITION,
    kinematics::MASS_CENTER_POSITION,
    kinematics::ORIGIN_VELOCITY,
    kinematics::MASS_CENTER_VELOCITY,
    kinematics::PARTIAL_VELOCITY_ORIGIN,
    kinematics::PARTIAL_VELOCITY_ORIGIN_DOT,
    kinematics::PARTIAL_VELOCITY,
    kinematics::PARTIAL_VELOCITY_DOT,
    kinematics::MASS_CENTER_ACCELERATION,
    dynamics::GENERALIZED_FORCES,
    dynamics::MASS_MATRIX,
    dynamics::MASS_MATRIX_PACKED,
    dynamics::FORCING,
    coordinates::Q_DOT,
    coordinates::NORMALIZE,
    dynamics::BIAS,
    dynamics::GRAVITY_FORCES,
    dynamics::INVERSE_DYNAMICS,
    dynamics::FORWARD_DYNAMICS,
    dynamics::FORWARD_DYNAMICS_PIVOTS,
    coordinates::SINGULARITY,
    energy::KINETIC_ENERGY,
    energy::POTENTIAL_ENERGY,
    energy::LINEAR_MOMENTUM,
    energy::ANGULAR_MOMENTUM,
];

/// Every function of a frame, in the order in which a module holds them.
pub static OF_FRAMES: [FrameFunction; 2] = [frames::POSE, frames::VELOCITY];

impl Function {
    /// The function of the catalogue with this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        CATALOGUE.iter().find(|function| function.name == name)
    }
}

impl FrameFunction {
    /// The function of a frame with this name.
    pub fn of_frame(name: &str) -> Option<&'static Self> {
        OF_FRAMES.iter().find(|function| function.name == name)
    }
}
