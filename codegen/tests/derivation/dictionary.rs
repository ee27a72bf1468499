//! Names that other tools have.

use kane_codegen::functions::{Parsed, advice, elsewhere};

#[test]
fn names_of_other_tools_lead_to_ours() {
    for (name, request) in [
        ("rnea", "inverse_dynamics"),
        ("CRBA", "mass_matrix"),
        ("aba", "forward_dynamics"),
        ("nle", "bias"),
        ("computeMinverse", "mass_matrix_inverse"),
        ("mj_jac", "point_jacobian(FRAME)"),
        ("mj_jacBody", "jacobian(FRAME)"),
        ("getVelocity", "velocity(FRAME)"),
        ("computeFrameJacobian", "jacobian(FRAME)"),
        (
            "CalcJacobianTranslationalVelocity",
            "linear_jacobian(FRAME)",
        ),
        ("computeCoriolisMatrix", "coriolis_matrix"),
        ("MassMatrix", "mass_matrix"),
        ("CalcMassMatrix", "mass_matrix"),
        (
            "computeRNEADerivatives",
            "d(inverse_dynamics)/d(q, u, u_dot)",
        ),
    ] {
        assert_eq!(elsewhere(name), Some(request));
        Parsed::read(request).expect("a request");
        assert!(Parsed::read(name).is_err(), "{name} is ours");
    }
    for (name, request) in [
        ("attitude", "pose(FRAME)"),
        ("dcm", "pose(FRAME)"),
        ("constraint_forces", "joint_wrenches"),
        ("joint_forces", "joint_wrenches"),
        ("hinge_torque", "inverse_dynamics"),
        ("stiffness_matrix", "d(bias)/d(q)"),
        ("damping_matrix", "d(bias)/d(u)"),
    ] {
        assert_eq!(elsewhere(name), Some(request));
    }
    assert_eq!(elsewhere("jerk"), None);
}

#[test]
fn words_of_textbooks_are_met_with_what_makes_them() {
    for (name, ours) in [
        ("generalized_active_forces", "generalized_forces"),
        ("generalized_inertia_forces", "inverse_dynamics"),
        ("inertia_tensor", "inertial_parameters"),
        ("composite_inertia", "mass_matrix"),
        ("lagrangian", "kinetic_energy+potential_energy"),
        ("power", "generalized_forces"),
    ] {
        let said = advice(name);
        assert!(said.contains(&format!("`{ours}`")), "{name}: {said}");
        Parsed::read(ours).expect("a request");
        assert!(Parsed::read(name).is_err(), "{name} is ours");
    }
}

#[test]
fn steps_are_met_with_what_they_need() {
    for (name, said) in [
        (
            "RK4Step",
            "that is `kane::discrete::rk4::step` in Rust and `rk4_step` in C, with `forward_dynamics`",
        ),
        (
            "driven_euler_adjoint",
            "that is `kane::discrete::euler::adjoint` with `kane::conditions::Driven` in Rust and `driven_euler_adjoint` in C, \
             with `hybrid_dynamics`, `vjp(hybrid_dynamics; q, u, tau)`",
        ),
        (
            "rk4_by_parameters",
            "that is `kane::discrete::rk4::by_parameters` in Rust and `rk4_by_parameters` in C, \
             with `forward_dynamics+d(forward_dynamics)/d(q, u, tau)`, `d(forward_dynamics)/d(parameters)`",
        ),
        (
            "scale_quaternions",
            "that is `kane::manifold::scale_quaternions` in Rust and `scale_quaternions` in C, for every system with quaternions",
        ),
    ] {
        assert_eq!(advice(name), said);
    }
}

#[test]
fn unknown_names_are_met_with_advice() {
    assert_eq!(advice("crba"), "here it is called `mass_matrix`");
    assert_eq!(advice("biass"), "did you mean `bias`?");
    assert_eq!(advice("ALL"), "did you mean `all`?");
    // The only one that begins so.
    assert_eq!(advice("grav"), "did you mean `gravity_forces`?");
    assert_eq!(
        advice("tool0_point_jacobian"),
        "did you mean `point_jacobian(tool0)`?"
    );
    assert_eq!(
        advice("tool0_linear_jacobian"),
        "did you mean `linear_jacobian(tool0)`?"
    );
    for (name, request) in [
        ("d_forward_dynamics", "d(forward_dynamics)/d(q, u, tau)"),
        (
            "d_forward_dynamics_d_q_tau",
            "d(forward_dynamics)/d(q, tau)",
        ),
        ("bias_derivatives", "d(bias)/d(q, u)"),
        ("d_bias_d_q_packed", "packed(d(bias)/d(q))"),
        ("d_jacobian_dq", "d(jacobian(FRAME))/d(q)"),
        (
            "jvp_inverse_dynamics_u_u_dot",
            "jvp(inverse_dynamics; u, u_dot)",
        ),
        ("hessian_bias", "hessian(bias; q, u)"),
        ("mass_matrix_and_tool0_pose", "mass_matrix+pose(tool0)"),
        ("bias_at_sin_cos", "bias(sin_cos)"),
    ] {
        assert_eq!(advice(name), format!("did you mean `{request}`?"));
    }
    assert_eq!(
        advice("all"),
        "it means several functions, and stands alone; for several in one write a sum such as `mass_matrix+bias`"
    );
    assert!(
        advice("getFrameAcceleration")
            .ends_with("that of a spatial acceleration is less by `ω × v`")
    );
    assert_eq!(
        advice("nle"),
        "here it is called `bias`, in which springs and dampers of joints act"
    );
    assert_eq!(
        advice("angular_jacobian"),
        "did you mean `jacobian(FRAME)`?"
    );
    assert_eq!(
        advice("dccrba"),
        "here it is called `jvp(centroidal_momentum_matrix; q)`, with `u` for `q_direction`; times `u` it is `centroidal_momentum_matrix_dot_u`"
    );
    assert_eq!(
        advice("computeCentroidalMomentum"),
        "it is `centroidal_momentum_matrix` times `u`; `angular_momentum` is about the inertial origin"
    );
    assert_eq!(advice("osim"), advice("operational_space_inertia"));
    assert!(advice("totalMass").starts_with("`inertial_parameters` writes the masses"));
    assert_eq!(advice("defualt"), "did you mean `default`?");
    assert!(advice("spatial_jacobian").ends_with("none is about the inertial origin"));
    assert_eq!(
        advice("operational_space_inertia"),
        "`operational_inverse_inertia(FRAME)` writes its inverse"
    );
    for (name, operator) in [
        ("jvp", "jvp(F; X)"),
        ("jtimes", "jvp(F; X)"),
        ("gradient", "vjp(F; X)"),
        ("hessian", "hessian(F; X)"),
        ("jacfwd", "d(F)/d(X)"),
    ] {
        assert!(advice(name).starts_with(&format!("expected `{operator}`")));
    }
    assert_eq!(
        advice("inverse_kinematics"),
        "that is `kane::inverse_kinematics` in Rust, for every system"
    );
    insta::assert_snapshot!(advice("jerk"), @"`kane info MODEL --functions all` lists those of a system; those of a frame are pose, position, velocity, acceleration, jacobian, jacobian_packed, point_jacobian, jacobian_dot_u, generalized_force, imu, operational_inverse_inertia, and some of its origin alone, as linear_jacobian");
}

#[test]
fn the_mass_centre_has_many_names() {
    for (name, request) in [
        ("com_jacobian", "center_of_mass_jacobian"),
        ("mass_centre_velocity", "center_of_mass_velocity"),
        ("mass_center", "center_of_mass"),
        ("momentum_matrix", "centroidal_momentum_matrix"),
    ] {
        assert_eq!(advice(name), format!("here it is called `{request}`"));
    }
    assert!(advice("com_acceleration").starts_with("it is `center_of_mass_jacobian` times"));
}
