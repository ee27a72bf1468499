//! The names themselves: what Pinocchio, MuJoCo, RBDL, Drake and textbooks call our requests, operators and variables; in small letters
//! and digits, without the words with which names of other tools begin.

/// Our requests, and other names of the same.
pub(super) const REQUESTS: [(&str, &[&str]); 53] = [
    (
        "inverse_dynamics",
        &[
            "qfrcinverse",
            "rnea",
            "rne",
            "id",
            "newtoneuler",
            "mjinverse",
        ],
    ),
    (
        "mass_matrix",
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
        &["aba", "fd", "articulatedbodyalgorithm", "mjforward"],
    ),
    (
        "bias",
        &["nle", "nonlineareffects", "qfrcbias", "biasterm", "mjrne"],
    ),
    (
        "gravity_forces",
        &[
            "gravity",
            "gravityterm",
            "gravload",
            "generalizedgravity",
            "gravitycompensation",
            "gravityvector",
            "gravitygeneralizedforces",
            "g",
        ],
    ),
    ("coriolis_matrix", &["coriolis", "christoffel", "c"]),
    (
        "mass_matrix_inverse",
        &["minv", "minverse", "inversemassmatrix", "m1"],
    ),
    ("mass_matrix_dot", &["mdot"]),
    ("mass_matrix_product", &["choleskymv", "mjmulm"]),
    (
        "mass_matrix_solve",
        &["choleskysolve", "mjsolvem", "minvtimestau"],
    ),
    (
        "mass_matrix_factors",
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
        &["frameposition", "endeffectorposition", "pointposition"],
    ),
    (
        "velocity(FRAME)",
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
        &["pointvelocity", "translationalvelocity"],
    ),
    (
        "acceleration(FRAME)",
        &[
            "frameacceleration",
            "frameclassicalacceleration",
            "mjobjectacceleration",
            "pointacceleration6d",
            "spatialacceleration",
            "bodyspatialaccelerationinworld",
        ],
    ),
    (
        "linear_acceleration(FRAME)",
        &["pointacceleration", "translationalacceleration"],
    ),
    (
        "jacobian(FRAME)",
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
    ("point_jacobian(FRAME)", &["mjjac", "mjjacbodycom"]),
    ("jacobian(FRAME, local)", &["bodyjacobian", "jacobe"]),
    (
        "linear_jacobian(FRAME)",
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
        &["biastranslationalacceleration"],
    ),
    ("generalized_force(FRAME)", &["mjapplyft", "wrench"]),
    (
        "operational_inverse_inertia(FRAME)",
        &[
            "delassus",
            "delassusmatrix",
            "efcar",
            "operationalspaceinverseinertia",
            "jminvjt",
        ],
    ),
    ("imu(FRAME)", &["accelerometer", "gyro"]),
    (
        "center_of_mass",
        &[
            "com",
            "centerofmassposition",
            "centerofmasspositioninworld",
            "subtreecom",
        ],
    ),
    (
        "center_of_mass_velocity",
        &[
            "vcom",
            "subtreelinvel",
            "centerofmasstranslationalvelocityinworld",
        ],
    ),
    (
        "center_of_mass_jacobian",
        &[
            "jcom",
            "jacobiancenterofmass",
            "comjacobian",
            "mjjacsubtreecom",
            "jacobiancenterofmasstranslationalvelocity",
        ],
    ),
    (
        "centroidal_momentum_matrix",
        &["centroidalmap", "cmm", "ccrba", "ag", "mjangmommat"],
    ),
    ("linear_momentum+angular_momentum", &["momentum"]),
    (
        "kinetic_energy+potential_energy",
        &["mechanicalenergy", "energy", "totalenergy"],
    ),
    ("kinetic_energy", &["mjenergyvel", "ke"]),
    ("potential_energy", &["mjenergypos", "pe"]),
    ("normalize", &["mjnormalizequat"]),
    ("regressor", &["jointtorqueregressor", "torqueregressor"]),
    (
        "inertial_parameters",
        &[
            "dynamicparameters",
            "standardparameters",
            "todynamicparameters",
            "pi",
        ],
    ),
    (
        "base_parameters",
        &["minimalparameters", "baseinertialparameters"],
    ),
    ("base_regressor", &["minimalregressor", "reducedregressor"]),
    ("hybrid_dynamics", &["hybrid", "hybridaba", "fdab"]),
    (
        "centroidal_momentum_matrix_dot_u",
        &["momentumrate", "centroidalmomentumtimevariation"],
    ),
    (
        "jvp(centroidal_momentum_matrix; q)",
        &["dccrba", "dag", "centroidalmaptimevariation"],
    ),
    (
        "joint_wrenches",
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
        &[
            "idderivatives",
            "rneaderivatives",
            "idsva",
            "inversedynamicsderivatives",
            "diddq",
            "diddu",
            "dtaudq",
            "mjdinversefd",
        ],
    ),
    (
        "d(forward_dynamics)/d(q, u, tau)",
        &[
            "abaderivatives",
            "forwarddynamicsderivatives",
            "dfddq",
            "dfddu",
            "dfddtau",
            "fdderivatives",
            "mjdtransitionfd",
        ],
    ),
    ("loaded_inverse_dynamics", &["statictorque"]),
    ("d(gravity_forces)/d(q)", &["generalizedgravityderivatives"]),
    (
        "d(loaded_inverse_dynamics)/d(q)",
        &["statictorquederivatives"],
    ),
    (
        "d(velocity(FRAME))/d(q, u)",
        &["framevelocityderivatives", "pointvelocityderivatives"],
    ),
    (
        "d(acceleration(FRAME))/d(q, u, u_dot)",
        &[
            "frameaccelerationderivatives",
            "pointclassicaccelerationderivatives",
            "forwardkinematicsderivatives",
        ],
    ),
    (
        "d(jacobian(FRAME))/d(q)",
        &["jointkinematichessians", "jointkinematichessian"],
    ),
    (
        "hessian(inverse_dynamics; q, u, u_dot)",
        &["rneasecondorderderivatives", "idsvaso"],
    ),
];

/// What to say beside the request, of names that mean something a little different.
pub(super) const REMARKS: [(&str, &[&str]); 13] = [
    (
        "whose linear part is the acceleration of the frame's origin; that of a spatial acceleration is less by `ω × v`",
        &[
            "frameacceleration",
            "frameaccelerationderivatives",
            "spatialacceleration",
        ],
    ),
    (
        "without gravity, which MuJoCo subtracts",
        &["mjobjectacceleration"],
    ),
    (
        "in which springs and dampers of joints act",
        &[
            "rnea",
            "aba",
            "nle",
            "nonlineareffects",
            "qfrcbias",
            "mjrne",
            "rneaderivatives",
            "abaderivatives",
        ],
    ),
    (
        "of which gravity, springs and dampers are part",
        &["biasterm"],
    ),
    ("with the other sign", &["gravitygeneralizedforces"]),
    ("at rest", &["statictorque"]),
    ("about the inertial origin", &["momentum"]),
    (
        "of all bodies; there is none of a subtree",
        &["subtreecom", "subtreelinvel", "mjjacsubtreecom"],
    ),
    (
        "with `u` for `q_direction`; times `u` it is `centroidal_momentum_matrix_dot_u`",
        &["dccrba", "dag", "centroidalmaptimevariation"],
    ),
    (
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
        "of a point that is given; of the frame's origin it is `jacobian(FRAME)`",
        &["mjjac", "mjjacbodycom"],
    ),
    (
        "which is the rate for `u_dot = 0`: add `centroidal_momentum_matrix` times `u_dot`",
        &["momentumrate", "centroidalmomentumtimevariation"],
    ),
    (
        "of a system in which `prescribed` names joints",
        &["hybrid", "hybridaba", "fdab"],
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
    ("kane::inverse_kinematics", &["inversekinematics", "ik"]),
    (
        "kane::manifold::q_plus",
        &["integrate", "mjintegratepos", "qplus"],
    ),
    (
        "kane::manifold::q_minus",
        &["difference", "mjdifferentiatepos", "qminus"],
    ),
    (
        "kane::manifold::TangentMap",
        &["dintegrate", "ddifference", "integratetransport"],
    ),
    (
        "kane::rotation",
        &["log3", "log6", "exp3", "exp6", "jlog3", "jlog6", "jexp3"],
    ),
    (
        "kane::discrete",
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
