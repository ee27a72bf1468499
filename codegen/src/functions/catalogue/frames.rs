//! Where frames are, how they move, and what moves them.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{DerivativesFn, Function, MassMatrixUse, Of, Output, PLAIN},
    roots,
    shape::Shape,
    subject::View,
    terms::Terms,
    unit::{LEVER, TURNING, Unit},
};

pub(super) const ANY_VIEW: Of = Of::Frame(&[View::Inertial, View::Local, View::Other]);
pub(super) const OWN_VIEWS: Of = Of::Frame(&[View::Inertial, View::Local]);

/// A vector of the origin, then an angular one, each with what it means.
const fn motion(
    linear: Unit,
    angular: Unit,
    meanings: [&'static str; 2],
    shape: Shape,
) -> [Output; 2] {
    [
        Output::of_several(("linear", "linear_multiplier"), shape, linear, meanings[0]),
        Output::of_several(
            ("angular", "angular_multiplier"),
            shape,
            angular,
            meanings[1],
        ),
    ]
}

/// The same for every speed of those that `shape` counts, of the origin or of another point.
const fn columns(linear: &'static str, shape: Shape) -> [Output; 2] {
    let angular = "columns of the angular velocity of {frame}, {axes}";
    motion(
        Unit::BySpeed(LEVER),
        Unit::BySpeed(TURNING),
        [linear, angular],
        shape,
    )
}

/// What Jacobians of frames mean.
const OF_ORIGIN: &str = "columns of the velocity of the origin of {frame}, {axes}";

pub(super) const POSE: Function = Function {
    of: Of::Frame(&[View::Inertial, View::Other]),
    name: "pose",
    trait_name: Some("Pose"),
    arguments: &[Argument::Q],
    outputs: &[
        Output::of_several(
            ("rotation", "rotation_multiplier"),
            Shape::MATRIX,
            Unit::ONE,
            "matrix from {base} components to components along the axes of {frame}, by rows",
        ),
        Output::of_several(
            ("position", "position_multiplier"),
            Shape::VECTOR,
            Unit::Of(&["m"]),
            "position of the origin of {frame} from {origin}, {base} components",
        ),
    ],
    doc: &[
        "Pose of the frame {frame}{from}: the matrix from {base} components to components along the frame's axes, by rows,",
        "and the position of its origin from {origin}, {base} components, {position}. Also known as frame placement, forward kinematics.",
        "The transposed matrix maps the frame's components to {base} ones.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::pose::pose,
    )),
    derivatives_like: Some(&JACOBIAN),
    derivation: Derivation::OfFrames(roots::frames::pose),
    ..PLAIN
};

pub(super) const VELOCITY: Function = Function {
    of: OWN_VIEWS,
    name: "velocity",
    trait_name: Some("Velocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &motion(
        Unit::Of(&["m/s"]),
        Unit::Of(&["rad/s"]),
        [
            "velocity of the origin of {frame}, {axes}",
            "angular velocity of {frame}, {axes}",
        ],
        Shape::VECTOR,
    ),
    doc: &[
        "Velocity of the frame {frame} in the inertial frame: of its origin, {linear}, and its angular velocity, {angular}; {axes}.",
        "Also known as frame velocity, spatial velocity at the frame's origin, twist.",
    ],
    derivatives_are: &[(Argument::U, &JACOBIAN)],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::velocity::velocity,
    )),
    derivatives_like: Some(&JACOBIAN),
    derivation: Derivation::OfFrames(roots::frames::velocity),
    ..PLAIN
};

pub(super) const ACCELERATION: Function = Function {
    of: OWN_VIEWS,
    name: "acceleration",
    trait_name: Some("Acceleration"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &motion(
        Unit::Of(&["m/s^2"]),
        Unit::Of(&["rad/s^2"]),
        [
            "acceleration of the origin of {frame}, without gravity, {axes}",
            "angular acceleration of {frame}, {axes}",
        ],
        Shape::VECTOR,
    ),
    doc: &[
        "Acceleration of the frame {frame} in the inertial frame: of its origin, {linear}, and its angular acceleration, {angular}; {axes}.",
        "It is the rate of the velocity of the origin itself, without gravity. Also known as classical acceleration.",
    ],
    derivatives_are: &[(Argument::UDot, &JACOBIAN)],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::acceleration::acceleration,
    )),
    derivatives_like: Some(&JACOBIAN),
    derivation: Derivation::OfFrames(roots::frames::acceleration),
    ..PLAIN
};

pub(super) const JACOBIAN: Function = Function {
    of: ANY_VIEW,
    name: "jacobian",
    trait_name: Some("Jacobian"),
    arguments: &[Argument::Q],
    outputs: &columns(OF_ORIGIN, Shape::VECTOR_BY_SPEEDS),
    doc: &[
        "Jacobian of the frame {frame} {seen}: times `u` the velocity of its origin, m/s, and its angular velocity, rad/s.",
        "A column for each speed, zero but for those of {speeds}. Also known as geometric Jacobian, frame Jacobian, task Jacobian.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::columns::jacobian,
    )),
    derivation: Derivation::OfFrames(roots::frames::jacobian),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const JACOBIAN_PACKED: Function = Function {
    of: ANY_VIEW,
    name: "jacobian_packed",
    trait_name: Some("JacobianPacked"),
    arguments: &[Argument::Q],
    outputs: &columns(OF_ORIGIN, Shape::VECTOR_BY_FRAME_SPEEDS),
    doc: &[
        "The columns of the Jacobian of the frame {frame} {seen}, of the speeds that move it alone: {speeds} says which.",
        "Times these speeds the velocity of the frame's origin, m/s, and its angular velocity, rad/s.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::columns::jacobian_packed,
    )),
    derivation: Derivation::OfFrames(roots::frames::jacobian_packed),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const POINT_JACOBIAN: Function = Function {
    of: ANY_VIEW,
    name: "point_jacobian",
    trait_name: Some("PointJacobian"),
    arguments: &[Argument::Q, Argument::Point],
    outputs: &columns(
        "columns of the velocity of the point in {frame}, {axes}",
        Shape::VECTOR_BY_SPEEDS,
    ),
    doc: &[
        "Jacobian of a point fixed in the frame {frame}, {seen}: times `u` the velocity of the point, m/s, and the angular velocity of the frame, rad/s.",
        "A column for each speed, zero but for those of {speeds}. The point may be another at each call, for contacts that move.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::columns::point_jacobian,
    )),
    derivation: Derivation::OfFrames(roots::frames::point_jacobian),
    terms: Terms::OfPath,
    ..PLAIN
};

pub(super) const JACOBIAN_DOT_U: Function = Function {
    of: OWN_VIEWS,
    name: "jacobian_dot_u",
    trait_name: Some("JacobianDotU"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &motion(
        Unit::Of(&["m/s^2"]),
        Unit::Of(&["rad/s^2"]),
        [
            "acceleration of the origin of {frame} for `u_dot = 0`, {axes}",
            "angular acceleration of {frame} for `u_dot = 0`, {axes}",
        ],
        Shape::VECTOR,
    ),
    doc: &[
        "The acceleration that the frame {frame} has in the inertial frame for `u_dot = 0`, of its origin, {linear}, and angular, {angular}; {axes}. Along the same axes",
        "`acceleration` is `jacobian` times `u_dot` plus this. Along inertial axes it is the rate of the Jacobian times `u`. Also known as drift, bias acceleration, `J_dot q_dot`.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::acceleration::jacobian_dot_u,
    )),
    derivatives_like: Some(&JACOBIAN),
    derivation: Derivation::OfFrames(roots::frames::jacobian_dot_u),
    ..PLAIN
};

pub(super) const GENERALIZED_FORCE: Function = Function {
    of: OWN_VIEWS,
    name: "generalized_force",
    trait_name: Some("GeneralizedForce"),
    arguments: &[Argument::Q, Argument::Force, Argument::Moment],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    doc: &[
        "Generalized forces of a wrench on the frame {frame}, its force at the frame's origin: `tau`, the transposed Jacobian times the wrench.",
        "The wrench is given by {axes}; {tau}. Also known as `J^T F`.",
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
    outputs: &[Output::new(
        "inverse_inertia",
        Shape::FRAME_MATRIX,
        Unit::Of(&["1/kg", "1/(kg m)", "1/(kg m^2)"]),
    )],
    doc: &[
        "`J M^-1 J^T` of the Jacobian of {frame}: what a unit wrench accelerates; symmetric, six rows a frame, the linear ones first; {axes}.",
        "{inverse_inertia}. Also known as inverse operational-space inertia, task-space mobility, Delassus matrix of several contacts.",
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
        Output::of_several(
            ("specific_force", "specific_force_multiplier"),
            Shape::VECTOR,
            Unit::Of(&["m/s^2"]),
            "acceleration of the origin of {frame} less gravity, along the frame's own axes",
        ),
        Output::of_several(
            ("angular_velocity", "angular_velocity_multiplier"),
            Shape::VECTOR,
            Unit::Of(&["rad/s"]),
            "angular velocity of {frame}, along the frame's own axes",
        ),
    ],
    doc: &[
        "What an inertial measurement unit at the frame {frame} reads: the acceleration of its origin less gravity, {specific_force}, and its angular velocity, {angular_velocity};",
        "components along the frame's own axes. At rest the specific force points up. Also known as accelerometer and gyroscope.",
    ],
    derivatives: Some(DerivativesFn::OfFrames(
        roots::derivatives::frames::imu::imu,
    )),
    derivatives_like: Some(&JACOBIAN),
    derivation: Derivation::OfFrames(roots::frames::imu),
    ..PLAIN
};
