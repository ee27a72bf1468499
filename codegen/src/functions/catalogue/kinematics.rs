//! Where bodies are and how they move.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{Function, Output, PLAIN},
    roots,
    shape::Shape,
    unit::{LEVER, LEVER_DOT, Unit},
};

pub(super) const RELATIVE_ROTATION: Function = Function {
    name: "relative_rotation",
    trait_name: Some("RelativeRotation"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("rotations", Shape::BODY_MATRICES, Unit::ONE)],
    doc: &[
        "Relative transformation matrices `JR_K`, Eq. (4): components in the lower body's axes to components in the body's, by rows.",
    ],
    derivation: Derivation::Notes(roots::kinematics::relative_rotation),
    ..PLAIN
};

pub(super) const ROTATION: Function = Function {
    name: "rotation",
    trait_name: Some("Rotation"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("rotations", Shape::BODY_MATRICES, Unit::ONE)],
    is_default: true,
    doc: &[
        "Transformation matrices `R_K`, Eqs. (2)-(5): inertial components to components in the body's axes, by rows.",
        "The transposed matrix maps body components to inertial ones.",
    ],
    derivation: Derivation::Notes(roots::kinematics::rotation),
    ..PLAIN
};

pub(super) const RELATIVE_ANGULAR_VELOCITY: Function = Function {
    name: "relative_angular_velocity",
    trait_name: Some("RelativeAngularVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "w_rel",
        Shape::BODY_VECTORS,
        Unit::Of(&["rad/s"]),
    )],
    doc: &[
        "Angular velocity of each body relative to its lower body, Eq. (8): body components, {w_rel}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::relative_angular_velocity),
    ..PLAIN
};

pub(super) const ANGULAR_VELOCITY: Function = Function {
    name: "angular_velocity",
    trait_name: Some("AngularVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("w", Shape::BODY_VECTORS, Unit::Of(&["rad/s"]))],
    doc: &["Angular velocity of each body in the inertial frame, Eq. (11): body components, {w}."],
    derivation: Derivation::Notes(roots::kinematics::angular_velocity),
    ..PLAIN
};

pub(super) const ANGULAR_ACCELERATION: Function = Function {
    name: "angular_acceleration",
    trait_name: Some("AngularAcceleration"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "alpha",
        Shape::BODY_VECTORS,
        Unit::Of(&["rad/s^2"]),
    )],
    doc: &[
        "Angular acceleration of each body in the inertial frame, below Eq. (19): body components, {alpha}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::angular_acceleration),
    ..PLAIN
};

pub(super) const PARTIAL_ANGULAR_VELOCITY: Function = Function {
    name: "partial_angular_velocity",
    trait_name: Some("PartialAngularVelocity"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("columns", Shape::COLUMNS, Unit::ONE)],
    doc: &[
        "Partial angular velocities `W_K`, Eqs. (15)-(17): body components, the columns of the non-zero partitions alone.",
        "`PARTIAL_ANGULAR_VELOCITY_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_angular_velocity),
    ..PLAIN
};

pub(super) const PARTIAL_ANGULAR_VELOCITY_DOT: Function = Function {
    name: "partial_angular_velocity_dot",
    trait_name: Some("PartialAngularVelocityDot"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("columns", Shape::COLUMNS, Unit::Of(&["1/s"]))],
    doc: &[
        "Time derivatives of the partial angular velocities, Eq. (20): of the body components, {columns}, compact.",
        "`PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_angular_velocity_dot),
    ..PLAIN
};

pub(super) const ORIGIN_POSITION: Function = Function {
    name: "origin_position",
    trait_name: Some("OriginPosition"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "positions",
        Shape::BODY_VECTORS,
        Unit::Of(&["m"]),
    )],
    doc: &[
        "Position of each body's origin `O_K` from the inertial origin, Eq. (22): body components, {positions}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::origin_position),
    ..PLAIN
};

pub(super) const MASS_CENTER_POSITION: Function = Function {
    name: "mass_center_position",
    trait_name: Some("MassCenterPosition"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "positions",
        Shape::BODY_VECTORS,
        Unit::Of(&["m"]),
    )],
    is_default: true,
    doc: &[
        "Position of each body's mass centre `G_K` from the inertial origin, Eq. (23): body components, {positions}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::mass_center_position),
    ..PLAIN
};

pub(super) const ORIGIN_VELOCITY: Function = Function {
    name: "origin_velocity",
    trait_name: Some("OriginVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "velocities",
        Shape::BODY_VECTORS,
        Unit::Of(&["m/s"]),
    )],
    doc: &[
        "Velocity of each body's origin in the inertial frame, Eq. (25): lower-body components, {velocities}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::origin_velocity),
    ..PLAIN
};

pub(super) const MASS_CENTER_VELOCITY: Function = Function {
    name: "mass_center_velocity",
    trait_name: Some("MassCenterVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "velocities",
        Shape::BODY_VECTORS,
        Unit::Of(&["m/s"]),
    )],
    doc: &[
        "Velocity of each body's mass centre in the inertial frame, Eq. (27): body components, {velocities}.",
    ],
    derivation: Derivation::Notes(roots::kinematics::mass_center_velocity),
    ..PLAIN
};

pub(super) const PARTIAL_VELOCITY_ORIGIN: Function = Function {
    name: "partial_velocity_origin",
    trait_name: Some("PartialVelocityOrigin"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("columns", Shape::COLUMNS, Unit::BySpeed(LEVER))],
    doc: &[
        "Partial velocities of the origins `V_O_K`, Eqs. (28)-(30): lower-body components, compact; {columns}.",
        "`PARTIAL_VELOCITY_ORIGIN_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_velocity_origin),
    ..PLAIN
};

pub(super) const PARTIAL_VELOCITY_ORIGIN_DOT: Function = Function {
    name: "partial_velocity_origin_dot",
    trait_name: Some("PartialVelocityOriginDot"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "columns",
        Shape::COLUMNS,
        Unit::BySpeed(LEVER_DOT),
    )],
    doc: &[
        "Time derivatives of the partial velocities of the origins, Eq. (34): of the lower-body components, compact.",
        "`PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_velocity_origin_dot),
    ..PLAIN
};

pub(super) const PARTIAL_VELOCITY: Function = Function {
    name: "partial_velocity",
    trait_name: Some("PartialVelocity"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("columns", Shape::COLUMNS, Unit::BySpeed(LEVER))],
    doc: &[
        "Partial velocities of the mass centres `V_G_K`, Eq. (32): body components, compact; {columns}.",
        "`PARTIAL_VELOCITY_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_velocity),
    ..PLAIN
};

pub(super) const PARTIAL_VELOCITY_DOT: Function = Function {
    name: "partial_velocity_dot",
    trait_name: Some("PartialVelocityDot"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "columns",
        Shape::COLUMNS,
        Unit::BySpeed(LEVER_DOT),
    )],
    doc: &[
        "Time derivatives of the partial velocities of the mass centres, Eq. (33): of the body components, compact.",
        "`PARTIAL_VELOCITY_DOT_BLOCKS` says which body and speeds each column belongs to.",
    ],
    derivation: Derivation::Columns(roots::kinematics::partial_velocity_dot),
    ..PLAIN
};

pub(super) const MASS_CENTER_ACCELERATION: Function = Function {
    name: "mass_center_acceleration",
    trait_name: Some("MassCenterAcceleration"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "accelerations",
        Shape::BODY_VECTORS,
        Unit::Of(&["m/s^2"]),
    )],
    doc: &[
        "Acceleration of each body's mass centre in the inertial frame, before Eq. (33): body components, {accelerations}; gravity is no part of it.",
    ],
    derivation: Derivation::Notes(roots::kinematics::mass_center_acceleration),
    ..PLAIN
};
