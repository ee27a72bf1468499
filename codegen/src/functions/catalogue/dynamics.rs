//! Forces, and what they accelerate.

use super::matrices::{CORIOLIS_MATRIX, MASS_MATRIX, MASS_MATRIX_INVERSE, NOTHING_CHECKED};
use crate::{
    functions::{
        argument::Argument,
        derivation::{Derivation, either},
        function::{DerivativesFn, Function, MassMatrixUse, Output, PLAIN},
        roots,
        shape::Shape,
        terms::Terms,
        told::{KnownMatrix, ReadOff},
        unit::Unit,
    },
    kane,
    recursive::{self, Technique},
};

pub(super) const GENERALIZED_FORCES: Function = Function {
    name: "generalized_forces",
    trait_name: Some("GeneralizedForces"),
    arguments: &[Argument::Q, Argument::Loads],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    doc: &[
        "Generalized forces of the loads, Eq. (36): `tau`, without gravity; {tau}.",
        "A load is the resultant force at the mass centre and the resultant moment, body components.",
    ],
    derivation: either!(
        kane::dynamics::generalized_forces,
        recursive::forces::inverse_dynamics::generalized_forces
    ),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const FORCING: Function = Function {
    name: "forcing",
    trait_name: Some("Forcing"),
    arguments: &[Argument::Q, Argument::U, Argument::Loads],
    outputs: &[Output::new("f", Shape::SPEEDS, Unit::FORCES)],
    derivatives: Some(DerivativesFn::OfSystem(roots::derivatives::forces::forcing)),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    doc: &[
        "Right-hand side `f` of Eqs. (41), (43): `M u_dot = f`; the loads' generalized forces less the bias.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::forcing),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const BIAS: Function = Function {
    name: "bias",
    trait_name: Some("Bias"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("bias", Shape::SPEEDS, Unit::FORCES)],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::Coriolis,
        entries: roots::coriolis::bias_of_coriolis,
    }),
    is_default: true,
    derivatives: Some(DerivativesFn::OfSystem(roots::derivatives::forces::bias)),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    doc: &[
        "Bias, with `M u_dot + bias = tau`: centrifugal, Coriolis and gyroscopic terms, weight, springs and dampers; the `-f` of Eq. (43) without loads.",
        "Also known as nonlinear effects, nle, `C q_dot + g`.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::bias),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const GRAVITY_FORCES: Function = Function {
    name: "gravity_forces",
    trait_name: Some("GravityForces"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::forces::gravity_forces,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    doc: &[
        "The `tau` that holds the system at rest against gravity alone: the part of `bias` that gravity has, without springs.",
        "{tau}. Also known as gravity torque, generalized gravity, `g(q)`.",
    ],
    techniques: &[Technique::Weights],
    derivation: either!(
        kane::dynamics::gravity_forces,
        recursive::forces::gravity::gravity_forces
    ),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const INVERSE_DYNAMICS: Function = Function {
    name: "inverse_dynamics",
    trait_name: Some("InverseDynamics"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    is_default: true,
    derivatives_are: &[(Argument::UDot, &MASS_MATRIX)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::forces::inverse_dynamics,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    doc: &[
        "Inverse dynamics: the `tau = M u_dot + bias` that gives the accelerations `u_dot`. Also known as rnea, computed torque.",
        "{tau}.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::inverse_dynamics),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const FORWARD_DYNAMICS: Function = Function {
    name: "forward_dynamics",
    trait_name: Some("ForwardDynamics"),
    arguments: &[Argument::Q, Argument::U, Argument::Tau],
    outputs: &[Output::new("u_dot", Shape::SPEEDS, Unit::ACCELERATIONS)],
    is_default: true,
    mass_matrix: MassMatrixUse::Accelerations,
    derivatives_are: &[(Argument::Tau, &MASS_MATRIX_INVERSE)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::accelerations::forward_dynamics,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass, KnownMatrix::MassInverse],
    inverse_dynamics: Some(roots::dynamics::inverse_dynamics),
    doc: &[
        "Forward dynamics: the `u_dot` with `M u_dot + bias = tau`, Eq. (41), solved along the tree, by `L^T D L` or by articulated bodies. Also known as aba.",
        NOTHING_CHECKED,
    ],
    derivation: Derivation::EitherWay(roots::dynamics::forward_dynamics),
    terms: Terms::OfMatrix,
    ..PLAIN
};
