//! Forces as they are linear in the parameters of bodies and joints, by which these are identified.

use crate::functions::{
    argument::Argument,
    derivation::Derivation,
    function::{Function, Output, PLAIN},
    roots,
    shape::Shape,
    terms::Terms,
    unit::Unit,
};

pub(super) const INERTIAL_PARAMETERS: Function = Function {
    name: "inertial_parameters",
    trait_name: Some("InertialParameters"),
    outputs: &[Output::new(
        "pi",
        Shape::INERTIAL_PARAMETERS,
        Unit::Of(&["kg", "kg m", "kg m^2"]),
    )],
    doc: &[
        "The inertial parameters `pi` of the bodies, as `regressor` counts them: each body's ten, with all that is fixed to it,",
        "`m`, `m c_x`, `m c_y`, `m c_z`, `I_xx`, `I_xy`, `I_yy`, `I_xz`, `I_yz`, `I_zz`, about the body's origin, body components, {pi};",
        "`I_xy` is the tensor's component. Also known as standard parameters, dynamic parameters.",
    ],
    derivation: Derivation::Notes(roots::regressor::inertial_parameters),
    ..PLAIN
};

pub(super) const BASE_PARAMETERS: Function = Function {
    name: "base_parameters",
    trait_name: Some("BaseParameters"),
    outputs: &[Output::new(
        "pi",
        Shape::BASE_PARAMETERS,
        Unit::Of(&["kg", "kg m", "kg m^2"]),
    )],
    doc: &[
        "The base parameters, as `base_regressor` counts them: sums of inertial parameters, which `BASE_PARAMETERS` names, each times its",
        "factor in `BASE_PARAMETER_TERMS`. Where values are set at run time, the inertial parameters follow them; the factors stay those of the",
        "nominal values. Also known as minimal parameters.",
    ],
    derivation: Derivation::Notes(roots::regressor::base_parameters),
    ..PLAIN
};

pub(super) const REGRESSOR: Function = Function {
    name: "regressor",
    trait_name: Some("Regressor"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "y",
        Shape::REGRESSOR,
        Unit::Of(&["m^2/s^2", "m/s^2", "1/s^2"]),
    )],
    doc: &[
        "Inertia forces and weight as they are linear in the inertial parameters `pi` of the bodies: `inverse_dynamics` is the sum of `y pi` over",
        "all bodies and parameters, and what springs, dampers and rotors need, less the forces of `gravity_compensation`. Ten parameters a body, with all that is fixed to it:",
        "`m`, `m c_x`, `m c_y`, `m c_z`, `I_xx`, `I_xy`, `I_yy`, `I_xz`, `I_yz`, `I_zz`, about the body's origin, body components, kg, kg m, kg m^2;",
        "`I_xy` is the tensor's component. The model's own values do not matter. Also known as joint torque regressor, identification matrix.",
    ],
    derivation: Derivation::EitherWay(roots::regressor::regressor),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const REGRESSOR_PACKED: Function = Function {
    name: "regressor_packed",
    trait_name: Some("RegressorPacked"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "y",
        Shape::REGRESSOR_PACKED,
        Unit::Of(&["m^2/s^2", "m/s^2", "1/s^2"]),
    )],
    doc: &[
        "The entries of `regressor` that the tree does not make zero: a body has those of the speeds that move it, and of a speed that",
        "translates it without turning, those of its mass and first moment.",
        "`REGRESSOR_PACKED_PLACES` says in which row, which is a speed, and in which column, ten times the body and the parameter, each stands; columns come one after the other.",
    ],
    derivation: Derivation::EitherWay(roots::regressor::regressor_packed),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const BASE_REGRESSOR: Function = Function {
    name: "base_regressor",
    trait_name: Some("BaseRegressor"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "y",
        Shape::BASE_REGRESSOR,
        Unit::Of(&["m^2/s^2", "m/s^2", "1/s^2"]),
    )],
    doc: &[
        "Inertia forces and weight as they are linear in the base parameters, the fewest combinations of inertial parameters on which they",
        "depend: those columns of `regressor` that are independent, so that least squares have one solution. `BASE_PARAMETERS` names the",
        "combinations, `BASE_PARAMETER_TERMS` holds their factors, those of the nominal values where parameters are set at run time.",
        "`inverse_dynamics` is `y` times the base parameters, and what springs, dampers and rotors need, less the forces of `gravity_compensation`. Lengths that are set at",
        "run time have to be nominal for that: the factors hold for these. The model's own masses are not read.",
        "Also known as minimal or reduced regressor, minimal inertial parameters.",
    ],
    derivation: Derivation::EitherWay(roots::regressor::base_regressor),
    terms: Terms::OfVector,
    ..PLAIN
};

pub(super) const JOINT_REGRESSOR: Function = Function {
    name: "joint_regressor",
    trait_name: Some("JointRegressor"),
    arguments: &[Argument::Q, Argument::U, Argument::UDot],
    outputs: &[Output::new(
        "y",
        Shape::SPEED_VECTORS,
        Unit::Of(&["rad/s", "m/s", "1", "rad/s^2", "m/s^2"]),
    )],
    doc: &[
        "Forces of dampers, Coulomb friction and rotors as they are linear in their coefficients: along each speed the sum of `y` times its viscous",
        "damping, N m s or N s/m, its Coulomb friction, N m or N, and its rotor inertia, kg m^2 or kg; a speed needs these three and no other's.",
        "`y` is the speed, its sign and its rate. The sign is branch-free: a half at a speed of `1e-30`, zero at zero, without a dead band.",
        "A coefficient is what the speed feels of all joints that it moves: dampers and rotors of joints that follow times their multiplier",
        "squared, friction times its magnitude. Also known as friction regressor.",
    ],
    derivation: Derivation::Notes(roots::regressor::joint_regressor),
    ..PLAIN
};
