//! What parts of a derivation are for, in the words of the comments between the lines that come of them.

/// What a part of a derivation is for. A node remembers that of the part in which it was built, or named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Purpose {
    /// None that is named.
    #[default]
    None,
    /// How a body stands on its lower body, its mass and inertia.
    Joint,
    /// Rotations, Eqs. (2) to (5).
    Rotation,
    /// Positions, Eqs. (22), (23).
    Position,
    /// Angular velocities, Eqs. (8), (11).
    AngularVelocity,
    /// Rates of coordinates, Eqs. (9), (44).
    Rates,
    /// Velocities of points, Eqs. (25), (27).
    Velocity,
    /// Rotations, positions and velocities, body after body outward.
    Outward,
    /// Accelerations, from the rates of partial velocities.
    Acceleration,
    /// Partial velocities, Eqs. (15), (28), (32).
    PartialVelocity,
    /// How these change, Eqs. (20), (33), (34).
    PartialVelocityDot,
    /// Velocity and acceleration, body after body outward.
    Motion,
    /// What a body needs to move so.
    Needed,
    /// What loads and forces of joints do at the body.
    Loads,
    /// Sums over bodies along partial velocities, Eqs. (36), (42), (43).
    Sums,
    /// Forces and moments, body after body inward, and what they do along the joint's motions.
    Forces,
    /// What acts in a joint: springs, dampers, rotors.
    Mechanics,
    /// Mass and inertia of a body and all that it carries, and what its motions make of these: columns of a matrix, inward.
    Composite,
    /// The inertia that a body shows where joints further out are free, inward.
    Articulated,
    /// Accelerations, outward.
    Accelerations,
    /// Factors of the mass matrix.
    Factors,
    /// Solution with these.
    Solution,
    /// The inverse of the mass matrix.
    Inverse,
    /// Weight.
    Weight,
    /// Energy.
    Energy,
    /// Mass centre of all bodies, and momentum about it.
    Momentum,
    /// What a unit of each inertial parameter needs, inward.
    Regressor,
    /// Along the bodies that carry the frame.
    Frame,
    /// The same of what acts at the frame.
    FrameForce,
    /// How functions change with their arguments.
    Derivative,
}

impl Purpose {
    /// The words, behind the body's name.
    pub fn words(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Joint => "joint, mass and inertia",
            Self::Rotation => "rotation, Eqs. (2) to (5)",
            Self::Position => "position, Eqs. (22), (23)",
            Self::AngularVelocity => "angular velocity, Eqs. (8), (11)",
            Self::Rates => "rates of coordinates, Eqs. (9), (44)",
            Self::Velocity => "velocity, Eqs. (25), (27)",
            Self::Outward => "position and velocity, outward",
            Self::Acceleration => "acceleration",
            Self::PartialVelocity => "partial velocities, Eqs. (15), (28), (32)",
            Self::PartialVelocityDot => "rates of partial velocities, Eqs. (20), (33), (34)",
            Self::Motion => "velocity and acceleration, outward",
            Self::Needed => "force and moment that its motion needs",
            Self::Loads => "given forces",
            Self::Sums => "along partial velocities, Eqs. (36), (42), (43)",
            Self::Forces => "forces, inward",
            Self::Mechanics => "springs, dampers and rotors",
            Self::Composite => "composite body and columns, inward",
            Self::Articulated => "articulated inertia, inward",
            Self::Accelerations => "accelerations, outward",
            Self::Factors => "factors of the mass matrix, inward",
            Self::Solution => "solution with the factors",
            Self::Inverse => "inverse of the mass matrix",
            Self::Weight => "weight, inward",
            Self::Energy => "energy",
            Self::Momentum => "mass centre and momentum, inward",
            Self::Regressor => "forces of inertial parameters, inward",
            Self::Frame => "pose and motion along the path to the frame",
            Self::FrameForce => "force at the frame",
            Self::Derivative => "derivatives",
        }
    }
}
