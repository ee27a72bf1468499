//! Motion and forces of a system on which loads act.

use super::matrices::{CORIOLIS_MATRIX, MASS_MATRIX, MASS_MATRIX_INVERSE, NOTHING_CHECKED};
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

pub(super) const LOADED_INVERSE_DYNAMICS: Function = Function {
    name: "loaded_inverse_dynamics",
    trait_name: Some("LoadedInverseDynamics"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot, Argument::Loads],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    derivatives_are: &[(Argument::UDot, &MASS_MATRIX)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::forces::loaded_inverse_dynamics,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    doc: &[
        "Inverse dynamics under loads: the `tau` that gives the accelerations `u_dot` where the loads act as well; `inverse_dynamics` less",
        "`generalized_forces` of the loads, {tau}. Also known as rnea with external forces, fext.",
        "A load is the resultant force at the mass centre and the resultant moment, body components; weight is none.",
    ],
    derivation: Derivation::EitherWay(roots::loaded::loaded_inverse_dynamics),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const LOADED_FORWARD_DYNAMICS: Function = Function {
    name: "loaded_forward_dynamics",
    trait_name: Some("LoadedForwardDynamics"),
    arguments: &[Argument::Q, Argument::U, Argument::Tau, Argument::Loads],
    outputs: &[Output::new("u_dot", Shape::SPEEDS, Unit::ACCELERATIONS)],
    mass_matrix: MassMatrixUse::Accelerations,
    derivatives_are: &[(Argument::Tau, &MASS_MATRIX_INVERSE)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::accelerations::loaded_forward_dynamics,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass, KnownMatrix::MassInverse],
    inverse_dynamics: Some(roots::loaded::loaded_inverse_dynamics),
    doc: &[
        "Forward dynamics under loads: the `u_dot` with `M u_dot + bias = tau` and the loads' generalized forces, Eq. (41), solved along the tree.",
        "Also known as aba with external forces, fext. A load is the resultant force at the mass centre and the resultant moment, body components.",
        NOTHING_CHECKED,
    ],
    derivation: Derivation::EitherWay(roots::loaded::loaded_forward_dynamics),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const JOINT_WRENCHES: Function = Function {
    name: "joint_wrenches",
    trait_name: Some("JointWrenches"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot, Argument::Loads],
    outputs: &[
        Output::of_several(
            ("force", "force_multiplier"),
            Shape::BODY_VECTORS,
            Unit::Of(&["N"]),
            "force that each joint transmits to its body, body components",
        ),
        Output::of_several(
            ("moment", "moment_multiplier"),
            Shape::BODY_VECTORS,
            Unit::Of(&["N m"]),
            "moment that each joint transmits to its body, about where it sits in the body, body components",
        ),
    ],
    doc: &[
        "All that each joint transmits to its body from the lower body, by which bearings and structures are sized: force, {force}, and moment, {moment},",
        "body components, about the point of the body where its joint sits: its origin, or its `body_attachment` where it has one.",
        "Weight and the loads on all bodies outward of the joint are in it, and so are motors, springs and dampers, which act through the joint:",
        "along the joint's motions it is their `tau` less what springs, dampers and rotors need; where others follow, the sum over all of them,",
        "each times its multiplier, is. Also known as joint reaction, constraint force.",
        "A load is the resultant force at the mass centre and the resultant moment, body components.",
    ],
    derivation: Derivation::EitherWay(roots::loaded::joint_wrenches),
    ..PLAIN
};
