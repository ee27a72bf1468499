//! The mass matrix as an operator: what it makes of accelerations and of forces, its inverse, its factors.

use crate::{
    functions::{
        argument::Argument,
        derivation::{Derivation, either},
        function::{DerivativesFn, Function, MassMatrixUse, Output, PLAIN},
        roots,
        shape::Shape,
        terms::Terms,
        told::{Beside, KnownMatrix, ReadOff},
        unit::Unit,
    },
    kane,
    recursive::{self, Technique},
};

/// Of functions that divide by pivots.
pub(super) const NOTHING_CHECKED: &str = "Nothing is checked: where the mass matrix is not positive definite the result is whatever IEEE arithmetic gives. The request `forward_dynamics_pivots` finds that out.";

pub(super) const MASS_MATRIX: Function = Function {
    name: "mass_matrix",
    trait_name: Some("MassMatrix"),
    arguments: &[Argument::Q],
    outputs: &[Output::new("m", Shape::SPEED_MATRIX, Unit::MASS_MATRIX)],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::Mass,
        entries: roots::matrices::whole,
    }),
    is_default: true,
    doc: &[
        "Mass matrix, `A` of Eq. (42), with `M u_dot + bias = tau`: symmetric, every entry written. Also known as joint-space inertia, crba.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::mass_matrix),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_PACKED: Function = Function {
    name: "mass_matrix_packed",
    trait_name: Some("MassMatrixPacked"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "entries",
        Shape::MASS_MATRIX_PACKED,
        Unit::MASS_MATRIX,
    )],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::Mass,
        entries: roots::dynamics::packed_of_mass,
    }),
    doc: &[
        "The entries of the mass matrix, Eq. (42), on and below the diagonal that the tree does not make zero.",
        "`MASS_MATRIX_PACKED_PLACES` says in which row and column each stands, row after row.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::mass_matrix_packed),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_PRODUCT: Function = Function {
    name: "mass_matrix_product",
    trait_name: Some("MassMatrixProduct"),
    arguments: &[Argument::Q, Argument::UDot],
    outputs: &[Output::new("tau", Shape::SPEEDS, Unit::FORCES)],
    derivatives_are: &[(Argument::UDot, &MASS_MATRIX)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::forces::mass_matrix_product,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::Mass],
    doc: &[
        "The mass matrix of Eq. (42) times accelerations, `tau = M u_dot`, rotors included: inverse dynamics without bias. No matrix is formed.",
        "{tau}. Also known as mass-matrix-vector product; with speeds in place of `u_dot`, generalized momentum.",
    ],
    derivation: Derivation::EitherWay(roots::matrices::product),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const MASS_MATRIX_SOLVE: Function = Function {
    name: "mass_matrix_solve",
    trait_name: Some("MassMatrixSolve"),
    arguments: &[Argument::Q, Argument::Tau],
    outputs: &[Output::new("u_dot", Shape::SPEEDS, Unit::ACCELERATIONS)],
    mass_matrix: MassMatrixUse::Accelerations,
    derivatives_are: &[(Argument::Tau, &MASS_MATRIX_INVERSE)],
    derivatives: Some(DerivativesFn::OfSystem(
        roots::derivatives::accelerations::mass_matrix_solve,
    )),
    derivatives_like: Some(&CORIOLIS_MATRIX),
    derivatives_tell: &[KnownMatrix::MassInverse],
    inverse_dynamics: Some(roots::matrices::product),
    doc: &[
        "The accelerations `u_dot = M^-1 tau` of forces alone: forward dynamics without bias, solved along the tree. No inverse is formed.",
        "For several right-hand sides at once `R` holds several numbers: lanes, one right-hand side each. Also known as solve-M, computeMinverse times a vector.",
        NOTHING_CHECKED,
    ],
    derivation: Derivation::EitherWay(roots::matrices::solution),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_INVERSE: Function = Function {
    name: "mass_matrix_inverse",
    trait_name: Some("MassMatrixInverse"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "inverse",
        Shape::SPEED_MATRIX,
        Unit::MASS_MATRIX_INVERSE,
    )],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::MassInverse,
        entries: roots::matrices::whole,
    }),
    mass_matrix: MassMatrixUse::Inverse,
    doc: &[
        "The inverse of the mass matrix of Eq. (42): `u_dot = M^-1 (tau - bias)`, symmetric, every entry written.",
        "From `M = L^T D L` along the tree, or from articulated bodies. Also known as inverse joint-space inertia, Minv, computeMinverse.",
        NOTHING_CHECKED,
    ],
    derivation: Derivation::EitherWay(roots::matrices::inverse),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_INVERSE_PACKED: Function = Function {
    name: "mass_matrix_inverse_packed",
    trait_name: Some("MassMatrixInversePacked"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "entries",
        Shape::INVERSE_PACKED,
        Unit::MASS_MATRIX_INVERSE,
    )],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::MassInverse,
        entries: roots::matrices::packed_of_inverse,
    }),
    mass_matrix: MassMatrixUse::Inverse,
    doc: &[
        "The entries of the inverse of the mass matrix, Eq. (42), on and below the diagonal that the tree does not make zero: those of two speeds of one tree at the root.",
        "`MASS_MATRIX_INVERSE_PACKED_PLACES` says in which row and column each stands, row after row.",
    ],
    derivation: Derivation::EitherWay(roots::matrices::inverse_packed),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_FACTORS: Function = Function {
    name: "mass_matrix_factors",
    trait_name: Some("MassMatrixFactors"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "entries",
        Shape::FACTORS,
        Unit::MASS_MATRIX_FACTORS,
    )],
    doc: &[
        "The factors `L` and `D` of the mass matrix of Eq. (42), `M = L^T D L` along the tree, without fill but where joints follow others on several branches:",
        "D on the diagonal, beside it L, whose diagonal is one.",
        "`MASS_MATRIX_FACTORS_PLACES` says at which two speeds each stands, row after row: as a packed mass matrix, with more only where there is fill.",
        "`MASS_MATRIX_FACTORS_ORDER` says in which order speeds are eliminated: an entry of L is in the row of that of its two speeds which comes first there. Also known as LTDL, sparse Cholesky.",
    ],
    derivation: Derivation::EitherWay(roots::matrices::mass_matrix_factors),
    terms: Terms::OfMatrix,
    mass_matrix: MassMatrixUse::Factors,
    ..PLAIN
};

pub(super) const CORIOLIS_MATRIX: Function = Function {
    name: "coriolis_matrix",
    trait_name: Some("CoriolisMatrix"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new("c", Shape::SPEED_MATRIX, Unit::MASS_MATRIX_DOT)],
    beside: Some(Beside {
        matrices: &[
            KnownMatrix::Mass,
            KnownMatrix::MassDot,
            KnownMatrix::Coriolis,
        ],
        derive: roots::coriolis::coriolis_matrix_beside,
    }),
    doc: &[
        "Coriolis matrix `C`, every entry written: `C u` is the bias less weight, springs and dampers, `M_dot = C + C^T`, and `M_dot - 2 C` is skew.",
        "Of every particle `m V^T V_dot`, from Eqs. (15), (20), (32), (33): where all speeds are rates of coordinates it is that of the Christoffel symbols of the first kind,",
        "with angular velocities as speeds that which bodies have. Also known as centrifugal and Coriolis matrix, computeCoriolisMatrix, `C(q, q_dot)`.",
    ],
    derivation: either!(
        kane::coriolis::coriolis_matrix,
        recursive::matrices::coriolis::coriolis_matrix
    ),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const MASS_MATRIX_DOT: Function = Function {
    name: "mass_matrix_dot",
    trait_name: Some("MassMatrixDot"),
    arguments: &[Argument::Q, Argument::U],
    outputs: &[Output::new(
        "m_dot",
        Shape::SPEED_MATRIX,
        Unit::MASS_MATRIX_DOT,
    )],
    read_off: Some(ReadOff {
        matrix: KnownMatrix::MassDot,
        entries: roots::matrices::whole,
    }),
    doc: &[
        "Rate of the mass matrix of Eq. (42) for the motion `u`, `M_dot = C + C^T`: symmetric, every entry written. Also known as time derivative of the joint-space inertia.",
    ],
    beside: Some(Beside {
        matrices: &[KnownMatrix::Mass],
        derive: roots::coriolis::mass_matrix_dot_beside,
    }),
    techniques: &[Technique::Rates],
    derivation: Derivation::EitherWay(roots::coriolis::mass_matrix_dot),
    terms: Terms::OfMatrix,
    ..PLAIN
};

pub(super) const FORWARD_DYNAMICS_PIVOTS: Function = Function {
    name: "forward_dynamics_pivots",
    trait_name: Some("ForwardDynamicsPivots"),
    arguments: &[Argument::Q],
    outputs: &[Output::new(
        "pivots",
        Shape::SPEEDS,
        Unit::BySpeed(["kg m^2", "kg"]),
    )],
    doc: &[
        "The pivots `D` of the mass matrix, `L^T D L` along the tree, by speed: all positive where it is positive definite.",
    ],
    derivation: Derivation::EitherWay(roots::dynamics::pivots),
    terms: Terms::OfMatrix,
    mass_matrix: MassMatrixUse::Factors,
    ..PLAIN
};
