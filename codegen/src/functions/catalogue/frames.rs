//! Where frames are, how they move, and what moves them.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{Function, MassMatrixUse, Of, Output, PLAIN},
    roots,
    shape::Shape,
    subject::View,
    terms::Terms,
};

const ANY_VIEW: Of = Of::Frame(&[View::Inertial, View::Local, View::Other]);
const OWN_VIEWS: Of = Of::Frame(&[View::Inertial, View::Local]);

/// A vector of the origin, then an angular one.
const MOTION: &[Output] = &[
    Output::of_several("linear", "linear_multiplier", Shape::VECTOR),
    Output::of_several("angular", "angular_multiplier", Shape::VECTOR),
];

/// The same for every speed.
const COLUMNS: &[Output] = &[
    Output::of_several("linear", "linear_multiplier", Shape::VECTOR_BY_SPEEDS),
    Output::of_several("angular", "angular_multiplier", Shape::VECTOR_BY_SPEEDS),
];

pub(super) const POSE: Function = Function {
    of: Of::Frame(&[View::Inertial, View::Other]),
    name: "pose",
    trait_name: Some("Pose"),
    arguments: &[Argument::Q],
    outputs: &[
        Output::of_several("rotation", "rotation_multiplier", Shape::MATRIX),
        Output::of_several("position", "position_multiplier", Shape::VECTOR),
    ],
    doc: &[
        "Pose of the frame {frame}{from}: the matrix from {base} components to components along the frame's axes, by rows,",
        "and the position of its origin from {origin}, {base} components, m. Also known as frame placement, forward kinematics.",
        "The transposed matrix maps the frame's components to {base} ones.",
    ],
    derivation: Derivation::OfFrames(roots::frames::pose),
    ..PLAIN
};

pub(super) const VELOCITY: Function = Function {
    of: OWN_VIEWS,
    name: "velocity",
    trait_name: Some("Velocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: MOTION,
    doc: &[
        "Velocity of the frame {frame} in the inertial frame: of its origin, m/s, and its angular velocity, rad/s; {axes}.",
        "Also known as frame velocity, spatial velocity at the frame's origin, twist.",
    ],
    derivation: Derivation::OfFrames(roots::frames::velocity),
    ..PLAIN
};

pub(super) const ACCELERATION: Function = Function {
    of: OWN_VIEWS,
    name: "acceleration",
    trait_name: Some("Acceleration"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: MOTION,
    doc: &[
        "Acceleration of the frame {frame} in the inertial frame: of its origin, m/s^2, and its angular acceleration, rad/s^2; {axes}.",
        "It is the rate of the velocity of the origin itself, without gravity. Also known as classical acceleration.",
    ],
    derivation: Derivation::OfFrames(roots::frames::acceleration),
    ..PLAIN
};

pub(super) const JACOBIAN: Function = Function {
    of: ANY_VIEW,
    name: "jacobian",
    trait_name: Some("Jacobian"),
    arguments: &[Argument::Q],
    outputs: COLUMNS,
    doc: &[
        "Jacobian of the frame {frame} {seen}: times `u` the velocity of its origin, m/s, and its angular velocity, rad/s.",
        "A column for each speed, zero but for those of {speeds}. Also known as geometric Jacobian, frame Jacobian, task Jacobian.",
    ],
    derivation: Derivation::OfFrames(roots::frames::jacobian),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const JACOBIAN_PACKED: Function = Function {
    of: ANY_VIEW,
    name: "jacobian_packed",
    trait_name: Some("JacobianPacked"),
    arguments: &[Argument::Q],
    outputs: &[
        Output::of_several("linear", "linear_multiplier", Shape::VECTOR_BY_FRAME_SPEEDS),
        Output::of_several(
            "angular",
            "angular_multiplier",
            Shape::VECTOR_BY_FRAME_SPEEDS,
        ),
    ],
    doc: &[
        "The columns of the Jacobian of the frame {frame} {seen}, of the speeds that move it alone: {speeds} says which.",
        "Times these speeds the velocity of the frame's origin, m/s, and its angular velocity, rad/s.",
    ],
    derivation: Derivation::OfFrames(roots::frames::jacobian_packed),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const POINT_JACOBIAN: Function = Function {
    of: ANY_VIEW,
    name: "point_jacobian",
    trait_name: Some("PointJacobian"),
    arguments: &[Argument::Q, Argument::Point],
    outputs: COLUMNS,
    doc: &[
        "Jacobian of a point fixed in the frame {frame}, {seen}: times `u` the velocity of the point, m/s, and the angular velocity of the frame, rad/s.",
        "A column for each speed, zero but for those of {speeds}. The point may be another at each call, for contacts that move.",
    ],
    derivation: Derivation::OfFrames(roots::frames::point_jacobian),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const JACOBIAN_DOT_U: Function = Function {
    of: OWN_VIEWS,
    name: "jacobian_dot_u",
    trait_name: Some("JacobianDotU"),
    arguments: &[Argument::Q, Argument::U],
    outputs: MOTION,
    doc: &[
        "The rate of the Jacobian of the frame {frame} times `u`: the acceleration that the frame has in the inertial frame for `u_dot = 0`,",
        "of its origin, m/s^2, and angular, rad/s^2; {axes}. Also known as drift, bias acceleration, `J_dot q_dot`.",
    ],
    derivation: Derivation::OfFrames(roots::frames::jacobian_dot_u),
    ..PLAIN
};

pub(super) const GENERALIZED_FORCE: Function = Function {
    of: OWN_VIEWS,
    name: "generalized_force",
    trait_name: Some("GeneralizedForce"),
    arguments: &[Argument::Q, Argument::Force, Argument::Moment],
    outputs: &[Output::new("tau", Shape::SPEEDS)],
    doc: &[
        "Generalized forces of a wrench on the frame {frame}, its force at the frame's origin: `tau`, the transposed Jacobian times the wrench.",
        "The wrench is given by {axes}; N m for an angle's speed, N for a translation's. Also known as `J^T F`.",
    ],
    derivation: Derivation::OfFrames(roots::frames::generalized_force),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const OPERATIONAL_INVERSE_INERTIA: Function = Function {
    of: Of::Frames(&[View::Inertial, View::Local]),
    name: "operational_inverse_inertia",
    trait_name: Some("OperationalInverseInertia"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("inverse_inertia", Shape::FRAME_MATRIX)],
    doc: &[
        "`J M^-1 J^T` of the Jacobian of {frame}: what a unit wrench accelerates; symmetric, six rows a frame, the linear ones first; {axes}.",
        "1/kg, 1/(kg m), 1/(kg m^2). Also known as inverse operational-space inertia, task-space mobility, Delassus matrix of several contacts.",
    ],
    derivation: Derivation::OfFrames(roots::frames::operational_inverse_inertia),
    terms: Terms::OfMatrix,
    mass_matrix: MassMatrixUse::Factors,
    ..PLAIN
};

pub(super) const IMU: Function = Function {
    of: Of::Frame(&[View::Inertial]),
    name: "imu",
    trait_name: Some("Imu"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[
        Output::of_several("specific_force", "specific_force_multiplier", Shape::VECTOR),
        Output::of_several(
            "angular_velocity",
            "angular_velocity_multiplier",
            Shape::VECTOR,
        ),
    ],
    doc: &[
        "What an inertial measurement unit at the frame {frame} reads: the acceleration of its origin less gravity, m/s^2, and its angular velocity, rad/s;",
        "components along the frame's own axes. At rest the specific force points up. Also known as accelerometer and gyroscope.",
    ],
    derivation: Derivation::OfFrames(roots::frames::imu),
    ..PLAIN
};
