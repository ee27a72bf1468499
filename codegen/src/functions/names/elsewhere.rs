//! The names themselves: what Pinocchio, MuJoCo, RBDL, Drake and textbooks call our requests, operators and variables; in small letters
//! and digits, without the words with which names of other tools begin.

/// Our requests, and other names of the same.
pub(super) const REQUESTS: [(&str, &[&str]); 49] = [
    (
        "inverse_dynamics",
        &["rnea", "rne", "id", "newtoneuler", "mjinverse"],
    ),
    (
        "mass_matrix",
        &[
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
        &["cholesky", "choleskydecompose", "qld", "sparsefactorizeltl"],
    ),
    (
        "pose(FRAME)",
        &[
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
            "mjjac",
            "mjjacbody",
            "mjjacsite",
            "pointjacobian6d",
            "jacobianspatialvelocity",
        ],
    ),
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
            "jacobiantimevariation",
            "jdot",
            "jdotv",
            "jdotqdot",
            "jacobiandot",
            "framejacobiantimevariation",
            "mjjacdot",
            "biasspatialacceleration",
            "drift",
            "driftacceleration",
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
            "osim",
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
        &["cmm", "ccrba", "ag", "mjangmommat"],
    ),
    (
        "linear_momentum+angular_momentum",
        &["momentum", "centroidalmomentum"],
    ),
    (
        "kinetic_energy+potential_energy",
        &["energy", "totalenergy"],
    ),
    ("kinetic_energy", &["mjenergyvel", "ke"]),
    ("potential_energy", &["mjenergypos", "pe"]),
    ("normalize", &["mjnormalizequat"]),
    (
        "regressor",
        &["jointtorqueregressor", "torqueregressor", "bodyregressor"],
    ),
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
        &[
            "dccrba",
            "dag",
            "momentumrate",
            "centroidalmomentumtimevariation",
        ],
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
pub(super) const REMARKS: [(&str, &[&str]); 6] = [
    (
        "whose linear part is the acceleration of the frame's origin; that of Pinocchio's spatial acceleration is less by `ω × v`",
        &["frameacceleration", "frameaccelerationderivatives"],
    ),
    (
        "of which springs and dampers are part",
        &["nle", "nonlineareffects", "qfrcbias", "mjrne"],
    ),
    (
        "of all bodies; there is none of a subtree",
        &["subtreecom", "subtreelinvel", "mjjacsubtreecom"],
    ),
    (
        "which is the matrix `A_G_dot` times `u`; there is none of the matrix alone",
        &["dccrba", "dag"],
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
