//! Masses, inertias and joints that are accepted, with and without a warning.

use kane_codegen::expr::ExprGraph;
use kane_codegen::functions::{Formulation, Function};
use kane_codegen::given;
use kane_test_support::models::{body, build, system};

#[test]
fn impossible_principal_moments_are_a_warning() {
    let text = system("[0]", &[("a", "[\"theta1\"]")]).replace("zz = 0.02", "zz = 0.3");
    insta::assert_snapshot!(build(&text).unwrap().warnings, @r#"
    warning: `inertia` of body `a` has the principal moments 0.09, 0.11 and 0.3, which no rigid body has; it is computed as given
     --> model.toml:8:18
      |
    8 | inertia = { xx = 0.1, yy = 0.1, zz = 0.3, xy = 0.01, xz = 0.0, yz = 0.0 }
      |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ the largest exceeds the sum of the others
      |
      = help: no principal moment can exceed the sum of the two others; is it taken about the mass centre?
    "#);
}

#[test]
fn moments_of_a_plate_in_six_digits_are_accepted() {
    let text = system("[0]", &[("a", "[\"theta1\"]")])
        .replace("zz = 0.02, xy = 0.01", "zz = 0.200001, xy = 0.0")
        .replace("xx = 0.1", "xx = 0.100001");
    assert!(build(&text).unwrap().warnings.is_empty());
}

#[test]
fn damper_that_pushes_is_a_warning() {
    let text = system("[0]", &[("a", "[\"theta1\"]")]) + "damping = -0.1\n";
    insta::assert_snapshot!(build(&text).unwrap().warnings);
}

#[test]
fn spring_that_pushes_away_from_rest_is_a_warning() {
    let text = system("[0]", &[("a", "[\"theta1\"]")]) + "stiffness = -1.0\n";
    let told = build(&text).unwrap().warnings.brief().lines[0].1.clone();
    assert!(
        told.contains("`stiffness` of body `a` is -1.0: it pushes away from rest"),
        "{told}"
    );
}

#[test]
fn limits_of_angles_of_a_quaternion_are_a_warning() {
    let with = |limits: &str| {
        let joint = format!("chart = \"quaternion\"\nlimits = {limits}\n");
        build(&(system("[0]", &[("a", "\"free\"")]) + &joint)).unwrap()
    };
    for limits in [
        "{ lower = -0.5, upper = 0.5 }",
        "{ theta2 = { upper = 0.5 } }",
    ] {
        let told = with(limits).warnings.brief().lines[0].1.clone();
        let expected = "`lower` and `upper` of body `a` do not limit its angles: its orientation is a quaternion";
        assert!(told.contains(expected), "{told}");
    }
    for limits in ["{ s1 = { upper = 0.5 } }", "{ velocity = 3.0 }"] {
        assert!(with(limits).warnings.is_empty(), "{limits}");
    }
}

#[test]
fn rounded_right_angle_between_free_angles_is_a_warning() {
    let text =
        system("[0]", &[("a", "[\"theta1\", \"theta3\"]")]) + "locked = { theta2 = -1.5708 }\n";
    insta::assert_snapshot!(build(&text).unwrap().warnings, @r#"
    warning: `theta2` of body `a` is locked near cos(theta2) = 0, between free `theta1` and `theta3`
      --> model.toml:11:21
       |
    10 | joint = ["theta1", "theta3"]
       |          --------  -------- free here
       |          |
       |          free here
    11 | locked = { theta2 = -1.5708 }
       |                     ^^^^^^^ `theta1` and `theta3` turn about one axis nearly
       |
       = help: leave out one of `theta1` and `theta3`: only their sum or difference would matter
    "#);
}

#[test]
fn point_mass_pendulum_is_a_system() {
    let text = system("[0]", &[("bob", "[\"theta1\", \"theta2\"]")])
        .replace(
            "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01",
            "xx = 0, yy = 0, zz = 0, xy = 0",
        )
        .replace("0.01, 0.02, -0.5", "0, 0, -0.5");
    assert!(build(&text).unwrap().warnings.is_empty());
}

#[test]
fn massless_bodies_may_carry_massive_ones() {
    // A universal joint in two bodies, the first without mass.
    let cross = body("cross", "[\"theta1\"]").replace("mass = 2.0", "mass = 0");
    let cross = cross.replace(
        "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01",
        "xx = 0, yy = 0, zz = 0, xy = 0",
    );
    let text = format!(
        "name = \"s\"\ngravity = [0, 0, 0]\nlower_bodies = [0, 1]\n{cross}{}",
        body("shaft", "[\"theta2\"]")
    );
    assert!(build(&text).unwrap().warnings.is_empty());
}

#[test]
fn a_massless_frame_leaves_the_mass_centre_of_a_massless_body_where_it_is() {
    let massless = |name: &str, joint: &str| {
        body(name, joint).replace("mass = 2.0", "mass = 0").replace(
            "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01",
            "xx = 0, yy = 0, zz = 0, xy = 0",
        )
    };
    let text = format!(
        "name = \"s\"\ngravity = [0, 0, 0]\nlower_bodies = [0, 1, 1]\n{}body_attachment = [0.0, 0.0, 1.0]\n{}{}",
        massless("cross", "[\"theta1\"]"),
        massless("frame", "\"fixed\""),
        body("shaft", "[\"theta2\"]"),
    );
    let tree = build(&text).unwrap().tree;
    let function = Function::find("mass_center_position").unwrap();
    let derived = function.derive(
        &tree,
        Formulation::Recursive,
        &kane_codegen::recursive::Plan::full(&tree),
    );
    let centers = derived.graph.evaluate(&derived.roots, |_| 0.0);
    // The joint at (0, 0.1, 0.3), the origin a metre below, and the mass centre from there.
    let expected = [0.01, 0.12, -1.2];
    for (center, expected) in centers.iter().zip(expected) {
        assert!((center - expected).abs() < 1e-15, "{centers:?}");
    }
}

#[test]
fn smallest_and_largest_scales_are_systems() {
    for (mass, length) in [(1e-120, 1e-30), (1e120, 1e30), (1e-9, 1e6), (1e12, 1e-6)] {
        let inertia = 0.1 * mass * length * length;
        let text = format!(
            "name = \"s\"\ngravity = [0, 0, 0]\nlower_bodies = [0, 1]\n{}",
            ["a", "b"]
                .map(|name| body(name, "\"free\"")
                    .replace("mass = 2.0", &format!("mass = {mass:e}"))
                    .replace(
                        "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01",
                        &format!("xx = {inertia:e}, yy = {inertia:e}, zz = {inertia:e}, xy = 0")
                    )
                    .replace("0.01, 0.02, -0.5", &format!("{length:e}, 0, 0"))
                    .replace("0.0, 0.1, 0.3", &format!("{length:e}, 0, 0")))
                .join("\n")
        );
        assert!(
            build(&text).is_ok(),
            "mass {mass}, length {length}: {}",
            build(&text).unwrap_err()
        );
    }
}

#[test]
fn the_mass_centre_of_the_only_part_with_mass_stays_as_written() {
    // 0.7 times this, divided by 0.7, is not this.
    let arm = body("arm", "[\"theta1\", \"theta2\"]")
        .replace("mass = 2.0", "mass = 0.7")
        .replace("0.01, 0.02, -0.5", "0.31, -0.01098, 0.07");
    let tool = body("tool", "\"fixed\"")
        .replace("mass = 2.0", "mass = 0.0")
        .replace(
            "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01",
            "xx = 0, yy = 0, zz = 0, xy = 0",
        );
    let text = format!("name = \"s\"\ngravity = [0, 0, 0]\nlower_bodies = [0, 1]\n{arm}{tool}");
    let tree = build(&text).unwrap().tree;
    let values = |name: &str| {
        let function = Function::find(name).unwrap();
        let plan = kane_codegen::recursive::Plan::full(&tree);
        let derived = function.derive(&tree, Formulation::Recursive, &plan);
        derived.graph.evaluate(&derived.roots, |_| 0.0)
    };
    // Where all coordinates are zero, it stands where the joint is, and so far from it.
    let expected = [0.31, -0.01098 + 0.1, 0.07 + 0.3];
    assert_eq!(values("mass_center_position")[..3], expected);
    let mut graph = ExprGraph::default();
    let center = given::mass_center(&mut graph, &tree.bodies[0]);
    let center = center.map(|component| graph.as_number(component));
    assert_eq!(center, [Some(0.31), Some(-0.01098), Some(0.07)]);
    let inertia = given::inertia(&mut graph, &tree.bodies[0]);
    let moments = inertia.diagonal.map(|moment| graph.as_number(moment));
    assert_eq!(moments, [Some(0.1), Some(0.1), Some(0.02)]);
}
