//! Words that users look for and that name no function and no frame.

/// Words for what no function writes, and what to do about each.
pub(super) const NO_FUNCTIONS: [(&str, &[&str]); 34] = [
    (
        "`jacobian(FRAME)` is about the frame's origin, along inertial axes; none is about the inertial origin",
        &["spatialjacobian"],
    ),
    (
        "forces of contacts follow from `operational_inverse_inertia(FRAME, ..)` and `acceleration(FRAME)`: docs/dictionary.md, \"Contact\"",
        &[
            "contact",
            "contacts",
            "contactforces",
            "constraint",
            "constraints",
            "constraintdynamics",
            "constrainedforwarddynamics",
            "kkt",
            "forwarddynamicscontactsdirect",
        ],
    ),
    (
        "closed loops are cut open, and forces between two frames hold them together: docs/dictionary.md, \"Closed loops\"",
        &[
            "loop",
            "loops",
            "closedloop",
            "closedloops",
            "loopclosure",
            "loopconstraint",
            "fourbar",
            "fourbarlinkage",
            "constraintjacobian",
            "lagrangemultipliers",
            "baumgarte",
        ],
    ),
    (
        "it follows from momenta and the mass centre: docs/dictionary.md, \"Contact\"",
        &[
            "zmp",
            "zeromomentpoint",
            "capturepoint",
            "dcm",
            "divergentcomponent",
        ],
    ),
    (
        "derivatives of what sensors measure are `d(imu(FRAME))/d(q, u, u_dot)`, `jacobian(FRAME)` and the like: docs/functions.md, \"Derivatives\"",
        &[
            "measurement",
            "measurementjacobian",
            "observation",
            "innovation",
        ],
    ),
    (
        "it is `bias` less `gravity_forces`, springs and dampers, or `coriolis_matrix` times `u`",
        &["coriolisvector", "coriolisforces", "cu"],
    ),
    (
        "a module has `LOWER_LIMITS`, `UPPER_LIMITS`, `VELOCITY_LIMITS` and `EFFORT_LIMITS`",
        &["limits", "jointlimits", "positionlimits", "torquelimits"],
    ),
    (
        "it is `centroidal_momentum_matrix` times `u`; `angular_momentum` is about the inertial origin",
        &["centroidal", "centroidalmomentum", "hg", "subtreeangmom"],
    ),
    (
        "it is `center_of_mass_jacobian` times `u_dot`, and `center_of_mass_jacobian_dot_u`",
        &["acom", "centerofmassacceleration"],
    ),
    (
        "`regressor` writes forces of joints; none writes the wrench of one body",
        &["bodyregressor", "jointbodyregressor"],
    ),
    (
        "a sum does all in one function, such as `mass_matrix+bias`",
        &["allterms"],
    ),
    (
        "`operational_inverse_inertia(FRAME)` writes its inverse",
        &[
            "lambda",
            "osim",
            "effectivemass",
            "taskinertia",
            "taskspaceinertia",
            "operationalinertia",
            "operationalspaceinertia",
            "operationalspaceinertiamatrix",
        ],
    ),
    (
        "velocities and accelerations from another frame follow from `jacobian(FRAME, OTHER)` and `jvp(jacobian(FRAME, OTHER); q)`",
        &["relativevelocity", "relativeacceleration"],
    ),
    (
        "add `generalized_forces` to `tau` of `hybrid_dynamics`, and take it from the forces that are found of prescribed speeds",
        &["loadedhybriddynamics"],
    ),
    (
        "a tool is a frame of the model, as in `pose(FRAME)` and `jacobian(FRAME)`",
        &["endeffector", "ee", "eef", "tcp", "tool", "flange"],
    ),
    (
        "it follows from `jacobian(FRAME)`: the square root of the determinant of `J J^T`",
        &["manipulability", "manipulabilitymeasure"],
    ),
    (
        "no equation has friction; a module has what the model says of it, `FRICTION`",
        &["friction", "coulombfriction", "frictionloss"],
    ),
    (
        "gains follow from `A` and `B` of a step, which `kane::discrete` computes in Rust and `rk4_linearized` in C",
        &["lqr", "dlqr", "riccati"],
    ),
    (
        "a filter needs `A` of a step, which `kane::discrete` computes in Rust and `rk4_linearized` in C",
        &[
            "ekf",
            "kalman",
            "kalmanfilter",
            "statetransition",
            "statetransitionmatrix",
        ],
    ),
    (
        "it is `inverse_dynamics` at the wanted accelerations plus gains times the errors of `q` and `u`",
        &["computedtorque", "computedtorquecontrol", "ctc"],
    ),
    (
        "springs and dampers of joints are part of `bias`",
        &["damping", "damper", "viscousfriction", "qfrcpassive"],
    ),
    (
        "no step here is implicit: build one from `d(inverse_dynamics)/d(q, u, u_dot)`, by Newton iteration or in an optimiser",
        &["impliciteuler", "implicitmidpoint", "collocation"],
    ),
    (
        "a projector follows from `jacobian(FRAME)` and `mass_matrix_inverse`: `1 - J^T (J M^-1 J^T)^-1 J M^-1`",
        &["nullspace", "nullspaceprojector"],
    ),
    (
        "`pose(FRAME)` writes a rotation matrix; `kane::rotation` makes rotation vectors of it",
        &["quaternion", "rpy", "eulerangles"],
    ),
    (
        "`inertial_parameters` writes the masses, each the first of its body's ten numbers",
        &["totalmass"],
    ),
    (
        "multiply what `hessian(F; X)` writes by the vector",
        &["hvp", "hessianvectorproduct"],
    ),
    (
        "the change of speeds by an impulse follows from `operational_inverse_inertia(FRAME, ..)`",
        &["impulsedynamics", "impulse", "impact"],
    ),
    (
        "a mass, a mass centre or an inertia that changes is `{ runtime = .. }` in the model",
        &["payload"],
    ),
    (
        "they are `tau` and `generalized_forces`, less `gravity_forces` and the forces of springs and dampers",
        &["generalizedactiveforces", "activeforces"],
    ),
    (
        "they are minus `inverse_dynamics`, without its gravity, springs and dampers",
        &["generalizedinertiaforces", "inertiaforces"],
    ),
    (
        "`inertial_parameters` writes the tensors of bodies, and `mass_matrix` the inertia of joints",
        &["inertiatensor"],
    ),
    (
        "of all that a free base carries it is the block of `mass_matrix` at the base's speeds, about its origin",
        &["compositeinertia"],
    ),
    (
        "it is `kinetic_energy` less `potential_energy`; `kinetic_energy+potential_energy` writes both",
        &["lagrangian"],
    ),
    (
        "it is the scalar product of forces, such as `tau` or `generalized_forces`, and `u`",
        &["power"],
    ),
];

/// What the runtime crate does, for every system.
pub(super) const RUNTIME: [(&str, &[&str]); 7] = [
    (
        "`kane::inverse_kinematics` in Rust, for every system",
        &["inversekinematics", "ik"],
    ),
    (
        "`kane::manifold::q_plus` in Rust and `q_plus` in C, for every system",
        &["integrate", "mjintegratepos", "qplus"],
    ),
    (
        "`kane::manifold::q_minus` in Rust and `q_minus` in C, for every system",
        &["difference", "mjdifferentiatepos", "qminus"],
    ),
    (
        "`kane::manifold::scale_quaternions` in Rust and `scale_quaternions` in C, for every system with quaternions",
        &["scalequaternions", "normalizequaternions"],
    ),
    (
        "`kane::manifold::TangentMap` in Rust, for every system",
        &["dintegrate", "ddifference", "integratetransport"],
    ),
    (
        "`kane::rotation` in Rust, for every system",
        &["log3", "log6", "exp3", "exp6", "jlog3", "jlog6", "jexp3"],
    ),
    (
        "`kane::discrete` in Rust, and `rk4_step` and others in C, with the request `forward_dynamics`; for `A` and `B` with `forward_dynamics+d(forward_dynamics)/d(q, u, tau)`",
        &[
            "euler",
            "symplecticeuler",
            "discrete",
            "mjstep",
            "step",
            "linearize",
            "linearized",
            "linearise",
            "linearization",
            "linearisation",
            "statespace",
            "discretize",
            "discretise",
            "rk4",
        ],
    ),
];

/// Kinds of Jacobians and the like, which are no frames though they stand where a frame could.
pub(super) const NO_FRAMES: [&str; 14] = [
    "analytic",
    "analytical",
    "angular",
    "bias",
    "body",
    "classical",
    "contact",
    "frame",
    "geometric",
    "linear",
    "point",
    "relative",
    "spatial",
    "world",
];
