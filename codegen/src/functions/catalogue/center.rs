//! The mass centre of all bodies, and momentum about it.

use crate::{
    functions::{
        argument::Argument,
        derivation::either,
        function::{DerivativesFn, Function, Output, PLAIN},
        roots,
        shape::Shape,
        terms::Terms,
        unit::{LEVER, Unit},
    },
    kane,
    recursive::totals,
};

pub(super) const CENTER_OF_MASS: Function = Function {
    name: "center_of_mass",
    trait_name: Some("CenterOfMass"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("position", Shape::VECTOR, Unit::Of(&["m"]))],
    doc: &[
        "Mass centre of all bodies, from the inertial origin: inertial components, {position}. Also known as centre of mass, com.",
        "Mass that is fixed to the inertial frame does not count. Where no body has mass it is the inertial origin; masses that are zero at run time alone give NaN.",
    ],
    derivatives_are: &[(Argument::Q, &CENTER_OF_MASS_JACOBIAN)],
    derivation: either!(kane::center::position, totals::center::position),
    ..PLAIN
};

pub(super) const CENTER_OF_MASS_VELOCITY: Function = Function {
    name: "center_of_mass_velocity",
    trait_name: Some("CenterOfMassVelocity"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("velocity", Shape::VECTOR, Unit::Of(&["m/s"]))],
    doc: &[
        "Velocity of the mass centre of all bodies in the inertial frame: inertial components, {velocity}; zero where no body has mass.",
        "Masses that are zero at run time alone give NaN.",
    ],
    derivatives_are: &[(Argument::U, &CENTER_OF_MASS_JACOBIAN)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::center_velocity,
    )),
    derivatives_like: Some(&CENTER_OF_MASS_JACOBIAN),
    derivation: either!(kane::center::velocity, totals::center::velocity),
    ..PLAIN
};

pub(super) const CENTER_OF_MASS_JACOBIAN: Function = Function {
    name: "center_of_mass_jacobian",
    trait_name: Some("CenterOfMassJacobian"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "jacobian",
        Shape::VECTOR_BY_SPEEDS,
        Unit::BySpeed(LEVER),
    )],
    doc: &[
        "Partial velocities of the mass centre of all bodies, a column for each speed: its velocity is this matrix times `u`, inertial components.",
        "Also known as com Jacobian. Zero where no body has mass; masses that are zero at run time alone give NaN.",
    ],
    derivation: either!(
        kane::center::jacobian,
        totals::momentum_matrix::center_jacobian
    ),
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::center::jacobian,
    )),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const CENTER_OF_MASS_JACOBIAN_DOT_U: Function = Function {
    name: "center_of_mass_jacobian_dot_u",
    trait_name: Some("CenterOfMassJacobianDotU"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "acceleration",
        Shape::VECTOR,
        Unit::Of(&["m/s^2"]),
    )],
    doc: &[
        "Acceleration of the mass centre of all bodies for `u_dot = 0`: inertial components, {acceleration}. With `center_of_mass_jacobian`, `J`, its",
        "acceleration is `J u_dot` and this, without gravity. Also known as com drift. Zero where no body has mass; masses that are zero at run",
        "time alone give NaN.",
    ],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::center_jacobian_dot_u,
    )),
    derivatives_like: Some(&CENTER_OF_MASS_JACOBIAN),
    derivation: either!(kane::center::jacobian_dot_u, totals::center::jacobian_dot_u),
    ..PLAIN
};

pub(super) const CENTROIDAL_MOMENTUM_MATRIX: Function = Function {
    name: "centroidal_momentum_matrix",
    trait_name: Some("CentroidalMomentumMatrix"),
    arguments: &[Argument::Q],
    outputs: &[
        Output::of_several(
            ("linear", "linear_multiplier"),
            Shape::VECTOR_BY_SPEEDS,
            Unit::BySpeed(["kg m", "kg"]),
            "columns of the linear momentum, inertial components",
        ),
        Output::of_several(
            ("angular", "angular_multiplier"),
            Shape::VECTOR_BY_SPEEDS,
            Unit::BySpeed(["kg m^2", "kg m"]),
            "columns of the angular momentum about the mass centre, inertial components",
        ),
    ],
    doc: &[
        "Momentum of all bodies about their mass centre for a unit of each speed, a column for each: linear, kg m/s, and angular, kg m^2/s, are these",
        "matrices times `u`, inertial components. Also known as centroidal momentum matrix, cmm, `A_G`, ccrba. Rotors have none.",
        "Where no body has mass, `linear` is zero; masses that are zero at run time alone give NaN.",
    ],
    derivation: either!(
        kane::center::momentum_matrix,
        totals::momentum_matrix::momentum_matrix
    ),
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::momentum::momentum_matrix,
    )),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const CENTROIDAL_MOMENTUM_MATRIX_DOT_U: Function = Function {
    name: "centroidal_momentum_matrix_dot_u",
    trait_name: Some("CentroidalMomentumMatrixDotU"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[
        Output::of_several(
            ("linear", "linear_multiplier"),
            Shape::VECTOR,
            Unit::Of(&["N"]),
            "rate of linear momentum for `u_dot = 0`, inertial components",
        ),
        Output::of_several(
            ("angular", "angular_multiplier"),
            Shape::VECTOR,
            Unit::Of(&["N m"]),
            "rate of angular momentum about the mass centre for `u_dot = 0`, inertial components",
        ),
    ],
    doc: &[
        "Rates of linear momentum, {linear}, and of angular momentum about the mass centre, {angular}, of all bodies for `u_dot = 0`: inertial components.",
        "With the centroidal momentum matrix `A_G`, their rates are `A_G u_dot` and this. Also known as `A_G_dot u`, centroidal bias, hdot drift.",
    ],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::momentum_rate,
    )),
    derivatives_like: Some(&CENTROIDAL_MOMENTUM_MATRIX),
    derivation: either!(
        kane::center::momentum_matrix_dot_u,
        totals::center::momentum_matrix_dot_u
    ),
    ..PLAIN
};
