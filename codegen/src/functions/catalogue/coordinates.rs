//! Coordinates: their rates, their charts.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{Function, Output, PLAIN},
    roots,
    shape::Shape,
    unit::Unit,
};

pub(super) const ANGLE_RATES: Function = Function {
    name: "angle_rates",
    trait_name: Some("AngleRates"),
    arguments: &[Argument::Q, Argument::RelativeAngularVelocity],
    outputs: &[Output::new(
        "rates",
        Shape::BODY_VECTORS,
        Unit::Of(&["rad/s"]),
    )],
    doc: &[
        "Rates of the three angles from the relative angular velocities `w_rel` (body components, rad/s), Eq. (9): {rates}.",
        "For bodies whose three angles are free, zero for the others; not finite where `cos(theta_2) = 0`.",
    ],
    derivation: Derivation::Notes(roots::coordinates::angle_rates),
    ..PLAIN
};

pub(super) const Q_DOT: Function = Function {
    name: "q_dot",
    trait_name: None,
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "q_dot",
        Shape::COORDINATES,
        Unit::ByCoordinate(["rad/s", "m/s", "1/s"]),
    )],
    is_default: true,
    doc: &[
        "Rates of the coordinates: speeds that are rates, Eq. (44); from angular velocities those of angles, Eq. (9), or half of Hamilton's product `e (0, w)`.",
    ],
    derivation: Derivation::Notes(roots::coordinates::q_dot),
    ..PLAIN
};

pub(super) const NORMALIZE: Function = Function {
    name: "normalize",
    trait_name: None,
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "normalized",
        Shape::COORDINATES,
        Unit::COORDINATES,
    )],
    doc: &[
        "The coordinates with every quaternion `e` brought back to length 1 by `e (3 - e.e)/2`, twice: for integrators, whose steps leave it slightly.",
        "A length that is off by d comes out off by about 3.4 d^4. All other coordinates are copied.",
    ],
    derivation: Derivation::Notes(roots::coordinates::normalize),
    ..PLAIN
};

pub(super) const SINGULARITY: Function = Function {
    name: "singularity",
    trait_name: Some("Singularity"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("distances", Shape::BODY_SCALARS, Unit::ONE)],
    doc: &[
        "Distance of each body's angles from the singularity of their chart: `|cos(theta_2)|` where `theta_1` and `theta_3` are both free, 1 elsewhere.",
    ],
    derivation: Derivation::Notes(roots::coordinates::singularity),
    ..PLAIN
};
