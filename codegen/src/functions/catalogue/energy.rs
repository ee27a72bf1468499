//! Energies and momenta of the whole system.

use crate::functions::{
    argument::Argument,
    candidate::Candidate,
    derive,
    function::{Function, Output},
    shape::Shape,
};

pub(super) const KINETIC_ENERGY: Function = Function {
    name: "kinetic_energy",
    trait_name: Some("KineticEnergy"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("energy", Shape::SCALAR)],
    is_default: true,
    solves: false,
    has_local: false,
    doc: &["Kinetic energy in the inertial frame, J."],
    candidates: &[Candidate::plain(derive::kinetic_energy)],
};

pub(super) const POTENTIAL_ENERGY: Function = Function {
    name: "potential_energy",
    trait_name: Some("PotentialEnergy"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("energy", Shape::SCALAR)],
    is_default: true,
    solves: false,
    has_local: false,
    doc: &["Potential energy of weight, J: zero for a mass at the inertial origin."],
    candidates: &[Candidate::plain(derive::potential_energy)],
};

pub(super) const LINEAR_MOMENTUM: Function = Function {
    name: "linear_momentum",
    trait_name: Some("LinearMomentum"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("momentum", Shape::VECTOR)],
    is_default: false,
    solves: false,
    has_local: false,
    doc: &["Linear momentum of all bodies: inertial components, kg m/s."],
    candidates: &[Candidate::plain(derive::linear_momentum)],
};

pub(super) const ANGULAR_MOMENTUM: Function = Function {
    name: "angular_momentum",
    trait_name: Some("AngularMomentum"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("momentum", Shape::VECTOR)],
    is_default: false,
    solves: false,
    has_local: false,
    doc: &[
        "Angular momentum of all bodies about the inertial origin: inertial components, kg m^2/s.",
    ],
    candidates: &[Candidate::plain(derive::angular_momentum)],
};
