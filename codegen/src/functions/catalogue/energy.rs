//! Energies and momenta of the whole system, and energies by body.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{Function, Output, PLAIN},
    roots,
    shape::Shape,
    unit::Unit,
};

pub(super) const KINETIC_ENERGY: Function = Function {
    name: "kinetic_energy",
    trait_name: Some("KineticEnergy"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("energy", Shape::SCALAR, Unit::Of(&["J"]))],
    is_default: true,
    doc: &["Kinetic energy in the inertial frame, {energy}."],
    derivation: Derivation::EitherWay(roots::energy::kinetic_energy),
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
    derivation: Derivation::EitherWay(roots::energy::potential_energy),
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
    derivation: Derivation::EitherWay(roots::energy::linear_momentum),
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
    derivation: Derivation::EitherWay(roots::energy::angular_momentum),
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
    derivation: Derivation::EitherWay(roots::energy::kinetic_energies),
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
    derivation: Derivation::EitherWay(roots::energy::potential_energies),
    ..PLAIN
};
