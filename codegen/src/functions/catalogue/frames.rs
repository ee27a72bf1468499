//! Where frames are and how they move.

use crate::functions::{
    argument::Argument,
    candidate::Candidate,
    derive_frame,
    function::{FrameFunction, Output},
    shape::Shape,
};

pub(super) const POSE: FrameFunction = FrameFunction {
    name: "pose",
    trait_name: Some("Pose"),
    arguments: &[Argument::Q],
    outputs: &[
        Output::new("rotation", Shape::MATRIX),
        Output::new("position", Shape::VECTOR),
    ],
    is_default: false,
    solves: false,
    has_local: false,
    doc: &[
        "Pose of the frame {frame}: the matrix from inertial components to components along the frame's axes, by rows,",
        "and the position of its origin from the inertial origin, inertial components, m. Also known as frame placement, forward kinematics.",
        "The transposed matrix maps the frame's components to inertial ones.",
    ],
    candidates: &[
        Candidate::plain_of_frame(derive_frame::pose),
        Candidate::planned_of_frame(derive_frame::pose_recursive),
    ],
};

pub(super) const VELOCITY: FrameFunction = FrameFunction {
    name: "velocity",
    trait_name: Some("Velocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[
        Output::new("linear", Shape::VECTOR),
        Output::new("angular", Shape::VECTOR),
    ],
    is_default: false,
    solves: false,
    has_local: true,
    doc: &[
        "Velocity of the frame {frame} in the inertial frame: of its origin, m/s, and its angular velocity, rad/s; {axes}.",
        "Also known as frame velocity, spatial velocity at the frame's origin, twist.",
    ],
    candidates: &[
        Candidate::plain_of_frame(derive_frame::velocity),
        Candidate::planned_of_frame(derive_frame::velocity_recursive),
    ],
};
