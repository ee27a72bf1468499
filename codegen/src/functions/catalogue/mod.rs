//! The functions, in the order in which a module holds them.

mod center;
mod coordinates;
mod dynamics;
mod energy;
mod frames;
mod hybrid;
mod kinematics;
mod linear;
mod loaded;
mod matrices;
mod regressor;

use super::function::Function;

/// Every function of the whole system that a user can ask for, in the order in which a module holds them.
pub static CATALOGUE: [Function; 58] = [
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
    matrices::MASS_MATRIX,
    matrices::MASS_MATRIX_PACKED,
    dynamics::FORCING,
    coordinates::Q_DOT,
    coordinates::NORMALIZE,
    dynamics::BIAS,
    dynamics::GRAVITY_FORCES,
    dynamics::INVERSE_DYNAMICS,
    dynamics::FORWARD_DYNAMICS,
    matrices::FORWARD_DYNAMICS_PIVOTS,
    coordinates::SINGULARITY,
    energy::KINETIC_ENERGY,
    energy::POTENTIAL_ENERGY,
    energy::LINEAR_MOMENTUM,
    energy::ANGULAR_MOMENTUM,
    matrices::MASS_MATRIX_PRODUCT,
    matrices::MASS_MATRIX_SOLVE,
    matrices::MASS_MATRIX_INVERSE,
    matrices::MASS_MATRIX_INVERSE_PACKED,
    matrices::MASS_MATRIX_FACTORS,
    matrices::CORIOLIS_MATRIX,
    matrices::MASS_MATRIX_DOT,
    loaded::LOADED_INVERSE_DYNAMICS,
    loaded::LOADED_FORWARD_DYNAMICS,
    energy::KINETIC_ENERGIES,
    energy::POTENTIAL_ENERGIES,
    loaded::JOINT_WRENCHES,
    hybrid::HYBRID_DYNAMICS,
    center::CENTER_OF_MASS,
    center::CENTER_OF_MASS_VELOCITY,
    center::CENTER_OF_MASS_JACOBIAN,
    center::CENTER_OF_MASS_JACOBIAN_DOT_U,
    center::CENTROIDAL_MOMENTUM_MATRIX,
    center::CENTROIDAL_MOMENTUM_MATRIX_DOT_U,
    regressor::INERTIAL_PARAMETERS,
    regressor::BASE_PARAMETERS,
    regressor::REGRESSOR,
    regressor::REGRESSOR_PACKED,
    regressor::BASE_REGRESSOR,
    regressor::JOINT_REGRESSOR,
];

/// Every function of a frame, in the order in which a module holds them.
pub static OF_FRAMES: [Function; 18] = [
    frames::POSE,
    linear::POSITION,
    frames::VELOCITY,
    linear::LINEAR_VELOCITY,
    frames::ACCELERATION,
    linear::LINEAR_ACCELERATION,
    frames::JACOBIAN,
    frames::JACOBIAN_PACKED,
    frames::POINT_JACOBIAN,
    linear::LINEAR_JACOBIAN,
    linear::LINEAR_JACOBIAN_PACKED,
    frames::JACOBIAN_DOT_U,
    linear::LINEAR_JACOBIAN_DOT_U,
    frames::GENERALIZED_FORCE,
    linear::LINEAR_GENERALIZED_FORCE,
    frames::IMU,
    frames::OPERATIONAL_INVERSE_INERTIA,
    linear::LINEAR_OPERATIONAL_INVERSE_INERTIA,
];

impl Function {
    /// All functions: those of the whole system, then those of frames.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        CATALOGUE.iter().chain(&OF_FRAMES)
    }

    /// Their names, in the same order.
    pub fn names() -> Vec<&'static str> {
        Self::all().map(|function| function.name).collect()
    }

    /// The names of all multipliers, some more than once.
    pub fn multipliers() -> impl Iterator<Item = &'static str> {
        let outputs = Self::all().flat_map(|function| function.outputs);
        outputs.map(|output| output.multiplier)
    }

    /// The function with this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        Self::all().find(|function| function.name == name)
    }
}
