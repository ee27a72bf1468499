//! Energies and momenta of the whole system, and energies by body.

use super::{
    center::CENTROIDAL_MOMENTUM_MATRIX, dynamics::GRAVITY_FORCES, matrices::MASS_MATRIX_PRODUCT,
};
use crate::{
    functions::{
        argument::Argument,
        derivation::either,
        function::{DerivativesFn, Function, Output, PLAIN},
        roots,
        shape::Shape,
        unit::Unit,
    },
    kane,
    recursive::{Technique, totals},
};

pub(super) const KINETIC_ENERGY: Function = Function {
    name: "kinetic_energy",
    trait_name: Some("KineticEnergy"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("energy", Shape::SCALAR, Unit::Of(&["J"]))],
    is_default: true,
    doc: &["Kinetic energy in the inertial frame, {energy}."],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::kinetic_energy,
    )),
    derivatives_like: Some(&MASS_MATRIX_PRODUCT),
    derivation: either!(kane::energy::kinetic, totals::energy::kinetic),
    ..PLAIN
};

pub(super) const POTENTIAL_ENERGY: Function = Function {
    name: "potential_energy",
    trait_name: Some("PotentialEnergy"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("energy", Shape::SCALAR, Unit::Of(&["J"]))],
    is_default: true,
    doc: &[
        "Potential energy, {energy}: of weight, zero for a mass at the inertial origin, and of springs, zero at rest.",
    ],
    techniques: &[Technique::Weights],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::potential_energy,
    )),
    derivatives_like: Some(&GRAVITY_FORCES),
    derivation: either!(kane::energy::potential, totals::energy::potential),
    ..PLAIN
};

pub(super) const LINEAR_MOMENTUM: Function = Function {
    name: "linear_momentum",
    trait_name: Some("LinearMomentum"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "momentum",
        Shape::VECTOR,
        Unit::Of(&["kg m/s"]),
    )],
    doc: &["Linear momentum of all bodies: inertial components, {momentum}."],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::linear_momentum,
    )),
    derivatives_like: Some(&CENTROIDAL_MOMENTUM_MATRIX),
    derivation: either!(kane::energy::linear_momentum, totals::momentum::linear),
    ..PLAIN
};

pub(super) const ANGULAR_MOMENTUM: Function = Function {
    name: "angular_momentum",
    trait_name: Some("AngularMomentum"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "momentum",
        Shape::VECTOR,
        Unit::Of(&["kg m^2/s"]),
    )],
    doc: &[
        "Angular momentum of all bodies about the inertial origin: inertial components, {momentum}.",
    ],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::totals::angular_momentum,
    )),
    derivatives_like: Some(&CENTROIDAL_MOMENTUM_MATRIX),
    derivatives_are: &[(Argument::U, &ANGULAR_MOMENTUM_MATRIX)],
    derivation: either!(kane::energy::angular_momentum, totals::momentum::angular),
    ..PLAIN
};

/// The derivatives of angular momentum by speeds alone; not in the catalogue.
const ANGULAR_MOMENTUM_MATRIX: Function = Function {
    name: "angular_momentum_matrix",
    arguments: &[Argument::Q],
    derivation: either!(
        kane::center::angular_about_origin,
        totals::momentum_matrix::angular_about_origin
    ),
    ..PLAIN
};

pub(super) const KINETIC_ENERGIES: Function = Function {
    name: "kinetic_energies",
    trait_name: Some("KineticEnergies"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "energies",
        Shape::BODY_SCALARS,
        Unit::Of(&["J"]),
    )],
    doc: &[
        "Kinetic energy of each body in the inertial frame, with that of the rotors of its joint, {energies}: `kinetic_energy` by bodies.",
    ],
    derivation: either!(
        kane::energy::kinetic_by_body,
        totals::body_energies::kinetic_by_body
    ),
    ..PLAIN
};

pub(super) const POTENTIAL_ENERGIES: Function = Function {
    name: "potential_energies",
    trait_name: Some("PotentialEnergies"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "energies",
        Shape::BODY_SCALARS,
        Unit::Of(&["J"]),
    )],
    doc: &[
        "Potential energy of each body, with that of the springs of its joint, {energies}: `potential_energy` by bodies. That of weight is zero for a",
        "mass at the inertial origin, that of a spring at rest.",
    ],
    derivation: either!(
        kane::energy::potential_by_body,
        totals::body_energies::potential_by_body
    ),
    ..PLAIN
};
