//! Accelerations of some joints and forces of the others.

use super::matrices::CORIOLIS_MATRIX;
use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{DerivativesFn, Function, MassMatrixUse, Output, PLAIN},
    roots,
    shape::Shape,
    terms::Terms,
    told::KnownMatrix,
    unit::Unit,
};

pub(super) const HYBRID_DYNAMICS: Function = Function {
    name: "hybrid_dynamics",
    trait_name: Some("HybridDynamics"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot, Argument::Tau],
    outputs: &[
        Output::of_several(
            ("whole_u_dot", "whole_u_dot_multiplier"),
            Shape::SPEEDS,
            Unit::ACCELERATIONS,
            "rates of all speeds, those that are given copied",
        ),
        Output::of_several(
            ("whole_tau", "whole_tau_multiplier"),
            Shape::SPEEDS,
            Unit::FORCES,
            "generalized forces of all speeds, those that are given copied",
        ),
    ],
    mass_matrix: MassMatrixUse::Accelerations,
    prescribes: true,
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::hybrid::hybrid_dynamics,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    inverse_dynamics: Some(roots::dynamics::inverse_dynamics),
    doc: &[
        "Hybrid dynamics: of the speeds that `PRESCRIBED` marks, those of the joints that the option `prescribed` names, the accelerations are",
        "given and the forces found; of the others the reverse: `M u_dot + bias = tau` holds of the whole `u_dot` and `tau`, which are written.",
        "What is given is copied; entries of `u_dot` and `tau` that are found are not read. With all prescribed it is `inverse_dynamics`, with",
        "none `forward_dynamics`. Forces in {whole_tau}; accelerations in {whole_u_dot}. Also known as mixed dynamics, hybrid aba.",
        "Nothing is checked: where the mass matrix of the others is not positive definite the result is whatever IEEE arithmetic gives.",
    ],
    derivation: Derivation::EitherWay(roots::hybrid::hybrid_dynamics),
    terms: Terms::OfMatrix,
    ..PLAIN
};
