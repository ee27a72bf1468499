//! The names themselves: what Pinocchio, MuJoCo, RBDL, Drake and textbooks call our requests, operators and variables; in small letters
//! and digits, without the words with which names of other tools begin.

/// Our requests, what to say beside them, and other names of the same, or of what differs as that says.
pub(super) const REQUESTS: [(&str, &str, &[&str]); 66] = [
    (
        "inverse_dynamics",
        "",
        &["qfrcinverse", "rne", "id", "newtoneuler", "mjinverse"],
    ),
    (
        "inverse_dynamics",
        "in which springs and dampers of joints act",
        &["rnea"],
    ),
    (
        "mass_matrix",
        "",
        &[
            "qm",
            "crba",
            "compositerigidbodyalgorithm",
            "m",
            "inertia",
            "inertiamatrix",
            "jointspaceinertia",
            "mjfullm",
            "mjcrb",
        ],
    ),
    (
        "forward_dynamics",
        "",
        &["fd", "articulatedbodyalgorithm", "mjforward"],
    ),
    (
        "forward_dynamics",
        "in which springs and dampers of joints act",
        &["aba"],
    ),
    (
        "bias",
        "in which springs and dampers of joints act",
        &["nle", "nonlineareffects", "qfrcbias", "mjrne"],
    ),
    (
        "bias",
        "of which gravity, springs and dampers are part",
        &["biasterm"],
    ),
    (
        "gravity_forces",
        "",
        &[
            "gravity",
            "gravityterm",
            "gravload",
            "generalizedgravity",
            "gravitycompensation",
            "gravityvector",
            "g",
        ],
    ),
    (
        "gravity_forces",
        "with the other sign",
        &["gravitygeneralizedforces"],
    ),
    ("coriolis_matrix", "", &["coriolis", "christoffel", "c"]),
    (
        "mass_matrix_inverse",
        "",
        &["minv", "minverse", "inversemassmatrix", "m1"],
    ),
    ("mass_matrix_dot", "", &["mdot"]),
    ("mass_matrix_product", "", &["choleskymv", "mjmulm"]),
    (
        "mass_matrix_solve",
        "",
        &["choleskysolve", "mjsolvem", "minvtimestau"],
    ),
    (
        "mass_matrix_factors",
        "",
        &[
            "mjfactorm",
            "cholesky",
            "choleskydecompose",
            "qld",
            "sparsefactorizeltl",
        ],
    ),
    (
        "pose(FRAME)",
        "",
        &[
            "frameplacement",
            "frameplacements",
            "updateframeplacements",
            "bodyposeinworld",
            "homogeneoustransform",
            "fk",
            "fkine",
            "forwardkinematics",
            "endeffectorpose",
            "framesforwardkinematics",
            "placement",
            "transform",
            "omf",
            "orientation",
            "xpos",
            "xmat",
            "sitexpos",
            "sitexmat",
            "bodytobasecoordinates",
            "bodyworldorientation",
            "relativetransform",
        ],
    ),
    (
        "position(FRAME)",
        "",
        &["frameposition", "endeffectorposition", "pointposition"],
    ),
    (
        "velocity(FRAME)",
        "",
        &[
            "framevelocity",
            "twist",
            "mjobjectvelocity",
            "pointvelocity6d",
            "spatialvelocity",
            "bodyspatialvelocityinworld",
        ],
    ),
    (
        "linear_velocity(FRAME)",
        "",
        &["pointvelocity", "translationalvelocity"],
    ),
    (
        "acceleration(FRAME)",
        "",
        &[
            "frameclassicalacceleration",
            "pointacceleration6d",
            "bodyspatialaccelerationinworld",
        ],
    ),
    (
        "acceleration(FRAME)",
        "whose linear part is the acceleration of the frame's origin; that of a spatial acceleration is less by `ω × v`",
        &["frameacceleration"],
    ),
    (
        "acceleration(FRAME)",
        "which is Drake's; that of other tools has a linear part that is less by `ω × v`",
        &["spatialacceleration"],
    ),
    (
        "acceleration(FRAME)",
        "without gravity, which MuJoCo subtracts",
        &["mjobjectacceleration"],
    ),
    (
        "linear_acceleration(FRAME)",
        "",
        &["pointacceleration", "translationalacceleration"],
    ),
    (
        "jacobian(FRAME)",
        "",
        &[
            "jac",
            "jacob0",
            "framejacobian",
            "jointjacobian",
            "jointjacobians",
            "geometricjacobian",
            "contactjacobian",
            "taskjacobian",
            "mjjacbody",
            "mjjacsite",
            "pointjacobian6d",
            "jacobianspatialvelocity",
        ],
    ),
    (
        "point_jacobian(FRAME)",
        "of a point that is given; of the frame's origin it is `jacobian(FRAME)`",
        &["mjjac", "mjjacbodycom"],
    ),
    ("jacobian(FRAME, local)", "", &["bodyjacobian", "jacobe"]),
    (
        "linear_jacobian(FRAME)",
        "",
        &[
            "jacp",
            "translationaljacobian",
            "translationjacobian",
            "positionjacobian",
            "jacobiantranslationalvelocity",
        ],
    ),
    (
        "jacobian_dot_u(FRAME)",
        "",
        &[
            "jdotv",
            "jdotqdot",
            "biasspatialacceleration",
            "drift",
            "driftacceleration",
        ],
    ),
    (
        "jvp(jacobian(FRAME); q)",
        "with `u` for `q_direction`; times `u` it is `jacobian_dot_u(FRAME)`",
        &[
            "jdot",
            "jacobiandot",
            "jacobiantimederivative",
            "jacobiantimevariation",
            "jointjacobiantimevariation",
            "jointjacobianstimevariation",
            "framejacobiantimevariation",
            "mjjacdot",
        ],
    ),
    (
        "linear_jacobian_dot_u(FRAME)",
        "",
        &["biastranslationalacceleration"],
    ),
    ("generalized_force(FRAME)", "", &["mjapplyft", "wrench"]),
    (
        "operational_inverse_inertia(FRAME)",
        "",
        &[
            "delassus",
            "delassusmatrix",
            "efcar",
            "operationalspaceinverseinertia",
            "jminvjt",
        ],
    ),
    ("imu(FRAME)", "", &["accelerometer", "gyro"]),
    (
        "center_of_mass",
        "",
        &["com", "centerofmassposition", "centerofmasspositioninworld"],
    ),
    (
        "center_of_mass",
        "of all bodies; there is none of a subtree",
        &["subtreecom"],
    ),
    (
        "center_of_mass_velocity",
        "",
        &["vcom", "centerofmasstranslationalvelocityinworld"],
    ),
    (
        "center_of_mass_velocity",
        "of all bodies; there is none of a subtree",
        &["subtreelinvel"],
    ),
    (
        "center_of_mass_jacobian",
        "",
        &[
            "jcom",
            "jacobiancenterofmass",
            "comjacobian",
            "jacobiancenterofmasstranslationalvelocity",
        ],
    ),
    (
        "center_of_mass_jacobian",
        "of all bodies; there is none of a subtree",
        &["mjjacsubtreecom"],
    ),
    (
        "centroidal_momentum_matrix",
        "",
        &["centroidalmap", "cmm", "ccrba", "ag", "mjangmommat"],
    ),
    (
        "linear_momentum+angular_momentum",
        "about the inertial origin",
        &["momentum"],
    ),
    (
        "kinetic_energy+potential_energy",
        "",
        &["mechanicalenergy", "energy", "totalenergy"],
    ),
    ("kinetic_energy", "", &["mjenergyvel", "ke"]),
    ("potential_energy", "", &["mjenergypos", "pe"]),
    ("normalize", "", &["mjnormalizequat"]),
    (
        "regressor",
        "",
        &["jointtorqueregressor", "torqueregressor"],
    ),
    (
        "inertial_parameters",
        "",
        &[
            "dynamicparameters",
            "standardparameters",
            "todynamicparameters",
            "pi",
        ],
    ),
    (
        "base_parameters",
        "",
        &["minimalparameters", "baseinertialparameters"],
    ),
    (
        "base_regressor",
        "",
        &["minimalregressor", "reducedregressor"],
    ),
    (
        "hybrid_dynamics",
        "of a system in which `prescribed` names joints",
        &["hybrid", "hybridaba", "fdab"],
    ),
    (
        "centroidal_momentum_matrix_dot_u",
        "which is the rate for `u_dot = 0`: add `centroidal_momentum_matrix` times `u_dot`",
        &["momentumrate", "centroidalmomentumtimevariation"],
    ),
    (
        "jvp(centroidal_momentum_matrix; q)",
        "with `u` for `q_direction`; times `u` it is `centroidal_momentum_matrix_dot_u`",
        &["dccrba", "dag", "centroidalmaptimevariation"],
    ),
    (
        "joint_wrenches",
        "",
        &[
            "dataf",
            "cfrcint",
            "reaction",
            "reactions",
            "reactionforces",
            "jointreactions",
        ],
    ),
    (
        "d(inverse_dynamics)/d(q, u, u_dot)",
        "",
        &[
            "idderivatives",
            "idsva",
            "inversedynamicsderivatives",
            "diddq",
            "diddu",
            "dtaudq",
            "mjdinversefd",
        ],
    ),
    (
        "d(inverse_dynamics)/d(q, u, u_dot)",
        "in which springs and dampers of joints act",
        &["rneaderivatives"],
    ),
    (
        "d(forward_dynamics)/d(q, u, tau)",
        "",
        &[
            "forwarddynamicsderivatives",
            "dfddq",
            "dfddu",
            "dfddtau",
            "fdderivatives",
            "mjdtransitionfd",
        ],
    ),
    (
        "d(forward_dynamics)/d(q, u, tau)",
        "in which springs and dampers of joints act",
        &["abaderivatives"],
    ),
    ("loaded_inverse_dynamics", "at rest", &["statictorque"]),
    (
        "d(gravity_forces)/d(q)",
        "",
        &["generalizedgravityderivatives"],
    ),
    (
        "d(loaded_inverse_dynamics)/d(q)",
        "",
        &["statictorquederivatives"],
    ),
    (
        "d(velocity(FRAME))/d(q, u)",
        "",
        &["framevelocityderivatives", "pointvelocityderivatives"],
    ),
    (
        "d(acceleration(FRAME))/d(q, u, u_dot)",
        "",
        &[
            "pointclassicaccelerationderivatives",
            "forwardkinematicsderivatives",
        ],
    ),
    (
        "d(acceleration(FRAME))/d(q, u, u_dot)",
        "whose linear part is the acceleration of the frame's origin; that of a spatial acceleration is less by `ω × v`",
        &["frameaccelerationderivatives"],
    ),
    (
        "d(jacobian(FRAME))/d(q)",
        "",
        &["jointkinematichessians", "jointkinematichessian", "djdq"],
    ),
    (
        "hessian(inverse_dynamics; q, u, u_dot)",
        "",
        &["rneasecondorderderivatives", "idsvaso"],
    ),
];

/// How derivatives of a function `F` by variables `X` are asked for.
pub(super) const OPERATORS: [(&str, &[&str]); 5] = [
    (
        "d(F)/d(X)",
        &["d", "derivative", "derivatives", "jacfwd", "jacrev"],
    ),
    ("packed(d(F)/d(X))", &["packed"]),
    ("jvp(F; X)", &["jvp", "jtimes", "directionalderivative"]),
    ("vjp(F; X)", &["vjp", "gradient", "grad"]),
    ("hessian(F; X)", &["hessian", "hess"]),
];

/// What the runtime crate does, for every system.
pub(super) const RUNTIME: [(&str, &[&str]); 6] = [
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
            "eulerstep",
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
            "rk4step",
            "rk4linearized",
            "eulerlinearized",
        ],
    ),
];

/// Our variables, and other names of the same.
pub(in crate::functions) const VARIABLES: [(&str, &[&str]); 5] = [
    ("q", &["qpos"]),
    ("u", &["v", "qd", "dq", "qdot", "qvel"]),
    ("u_dot", &["a", "qdd", "ddq", "qddot", "qacc", "vdot"]),
    ("tau", &["torque", "torques", "forces", "ctrl"]),
    ("loads", &["load", "fext", "wrench", "wrenches"]),
];
