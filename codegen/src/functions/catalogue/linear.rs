//! Where the origins of frames are, how they move, and what moves them: functions of frames without what is angular, for feet and
//! other points.

use super::frames::{ANY_VIEW, OWN_VIEWS};
use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{DerivativesFn, Function, MassMatrixUse, Of, Output, PLAIN},
    roots,
    shape::Shape,
    subject::View,
    terms::Terms,
    unit::{LEVER, Unit},
};

pub(super) const POSITION: Function = Function {
    of: Of::Frame(&[View::Inertial, View::Other]),
    name: "position",
    trait_name: Some("Position"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("position", Shape::VECTOR, Unit::Of(&["m"]))],
    doc: &[
        "Position of the origin of the frame {frame}{from}, from {origin}, {base} components, {position}.",
        "Also known as forward kinematics of a point.",
    ],
    derivatives_are: &[(Argument::Q, &LINEAR_JACOBIAN)],
    derivation: Derivation::OfFrames(roots::linear::position),
    ..PLAIN
};

pub(super) const LINEAR_VELOCITY: Function = Function {
    of: OWN_VIEWS,
    name: "linear_velocity",
    trait_name: Some("LinearVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("linear", Shape::VECTOR, Unit::Of(&["m/s"]))],
    doc: &[
        "Velocity of the origin of the frame {frame} in the inertial frame, {linear}; {axes}.",
        "Also known as translational velocity.",
    ],
    derivatives_are: &[(Argument::U, &LINEAR_JACOBIAN)],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::linear::velocity,
    )),
    derivatives_like: Some(&LINEAR_JACOBIAN),
    derivation: Derivation::OfFrames(roots::linear::velocity),
    ..PLAIN
};

pub(super) const LINEAR_ACCELERATION: Function = Function {
    of: OWN_VIEWS,
    name: "linear_acceleration",
    trait_name: Some("LinearAcceleration"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new("linear", Shape::VECTOR, Unit::Of(&["m/s^2"]))],
    doc: &[
        "Acceleration of the origin of the frame {frame} in the inertial frame, without gravity, {linear}; {axes}.",
        "Also known as translational acceleration.",
    ],
    derivatives_are: &[(Argument::UDot, &LINEAR_JACOBIAN)],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::linear::acceleration,
    )),
    derivatives_like: Some(&LINEAR_JACOBIAN),
    derivation: Derivation::OfFrames(roots::linear::acceleration),
    ..PLAIN
};

pub(super) const LINEAR_JACOBIAN: Function = Function {
    of: ANY_VIEW,
    name: "linear_jacobian",
    trait_name: Some("LinearJacobian"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "linear",
        Shape::VECTOR_BY_SPEEDS,
        Unit::BySpeed(LEVER),
    )],
    doc: &[
        "Jacobian of the origin of the frame {frame} {seen}: times `u` its velocity, m/s.",
        "A column for each speed, zero but for those of {speeds}. Also known as translational Jacobian, position Jacobian, Jacobian of a point contact.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::linear::jacobian,
    )),
    derivation: Derivation::OfFrames(roots::linear::jacobian),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const LINEAR_JACOBIAN_PACKED: Function = Function {
    of: ANY_VIEW,
    name: "linear_jacobian_packed",
    trait_name: Some("LinearJacobianPacked"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "linear",
        Shape::VECTOR_BY_FRAME_SPEEDS,
        Unit::BySpeed(LEVER),
    )],
    doc: &[
        "The columns of the Jacobian of the origin of the frame {frame} {seen}, of the speeds that move the frame alone: {speeds} says which.",
        "Times these speeds the velocity of the origin, m/s.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::linear::jacobian_packed,
    )),
    derivation: Derivation::OfFrames(roots::linear::jacobian_packed),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const LINEAR_JACOBIAN_DOT_U: Function = Function {
    of: OWN_VIEWS,
    name: "linear_jacobian_dot_u",
    trait_name: Some("LinearJacobianDotU"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("linear", Shape::VECTOR, Unit::Of(&["m/s^2"]))],
    doc: &[
        "The acceleration that the origin of the frame {frame} has in the inertial frame for `u_dot = 0`, {linear}; {axes}. Along the same axes `linear_acceleration` is",
        "`linear_jacobian` times `u_dot` plus this. Along inertial axes it is the rate of that Jacobian times `u`.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::linear::jacobian_dot_u,
    )),
    derivatives_like: Some(&LINEAR_JACOBIAN),
    derivation: Derivation::OfFrames(roots::linear::jacobian_dot_u),
    ..PLAIN
};

pub(super) const LINEAR_GENERALIZED_FORCE: Function = Function {
    of: OWN_VIEWS,
    name: "linear_generalized_force",
    trait_name: Some("LinearGeneralizedForce"),
    arguments: &[Argument::Q, Argument::Force],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    doc: &[
        "Generalized forces of a force at the origin of the frame {frame}: `tau`, the transposed Jacobian of the origin times the force.",
        "The force is given by {axes}; {tau}. Also known as `J^T f`.",
    ],
    derivation: Derivation::OfFrames(roots::linear::generalized_force),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const LINEAR_OPERATIONAL_INVERSE_INERTIA: Function = Function {
    of: Of::Frames(&[View::Inertial, View::Local]),
    name: "linear_operational_inverse_inertia",
    trait_name: Some("LinearOperationalInverseInertia"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "inverse_inertia",
        Shape::POINT_MATRIX,
        Unit::Of(&["1/kg"]),
    )],
    doc: &[
        "`J M^-1 J^T` of the Jacobian of the origin of {frame}: what a unit force there accelerates; symmetric, three rows a frame; {axes}.",
        "{inverse_inertia}. Also known as Delassus matrix of several point contacts.",
    ],
    derivation: Derivation::OfFrames(roots::linear::operational_inverse_inertia),
    terms: Terms::OfMatrix,
    mass_matrix: MassMatrixUse::Factors,
    ..PLAIN
};
