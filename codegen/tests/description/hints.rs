//! What is told of models that are read, and of those that are refused: the words with which users are helped.

use kane_codegen::{
    description::{Base, Reading, urdf},
    diagnostic::{Diagnostics, Source},
    error::Error,
    functions::Parsed,
    tree::{self, Checked},
};
use kane_test_support::models::{body, build, system};

fn robot(text: &str, base: Base) -> Result<Checked, Diagnostics> {
    let reading = Reading {
        base: Some(base),
        ..Reading::default()
    };
    tree::build(&urdf::parse(&Source::new("robot.urdf", text), &reading))
}

fn warnings(checked: &Checked) -> String {
    checked.warnings.to_string()
}

const LINK: &str = "<inertial><mass value='1'/><origin xyz='.1 0 0'/><inertia ixx='.1' iyy='.1' izz='.1' ixy='0' ixz='0' iyz='0'/></inertial>";

/// A robot whose only joint has this type and this inside.
fn of_joint(kind: &str, inside: &str) -> String {
    format!(
        "<robot name='r'><link name='a'/><link name='b'>{LINK}</link><joint name='j' type='{kind}'>
<parent link='a'/><child link='b'/>{inside}</joint></robot>"
    )
}

#[test]
fn negative_limits_and_negative_friction_count_as_none() {
    let limits = "<limit lower='-1' upper='1' effort='-1' velocity='-1'/><dynamics friction='-2'/>";
    let tree = robot(&of_joint("revolute", limits), Base::Fixed)
        .unwrap()
        .tree;
    let mechanics = &tree.bodies[0].joint.mechanics;
    for own in mechanics {
        assert_eq!(own.velocity, f64::INFINITY);
        assert_eq!(own.effort, f64::INFINITY);
        assert_eq!(own.friction, 0.0);
    }
    assert!(mechanics.iter().any(|own| own.range == [-1.0, 1.0]));
}

#[test]
fn the_order_of_a_list_of_rotations_is_told_to_mean_nothing() {
    let told = |joint: &str| warnings(&build(&system("[0]", &[("a", joint)])).unwrap());
    let warned = told("[\"theta3\", \"theta1\"]");
    let words = "`joint` of body `a` lists `theta3` before `theta1`; the order means nothing: rotations are about x, then y, then z";
    assert!(warned.contains(words), "{warned}");
    for joint in ["[\"theta1\", \"theta3\"]", "[\"s2\", \"theta1\", \"s1\"]"] {
        let told = told(joint);
        assert!(!told.contains("order"), "{told}");
    }
}

#[test]
fn a_base_of_its_own_is_read_fixed() {
    let advice = "read it with `--base fixed`";
    for kind in ["floating", "planar", "prismatic"] {
        let faults = robot(&of_joint(kind, ""), Base::Free)
            .unwrap_err()
            .to_string();
        assert!(faults.contains(advice), "{kind}: {faults}");
        assert!(robot(&of_joint(kind, ""), Base::Fixed).is_ok());
    }
    let hinge = robot(&of_joint("continuous", ""), Base::Free);
    let faults = hinge.unwrap_err().to_string();
    assert!(!faults.contains(advice), "{faults}");
}

#[test]
fn joints_that_move_no_mass_together_are_one_list() {
    let massless = |name: &str| {
        let body = body(name, "\"revolute\"\naxis = [0.0, 0.0, 1.0]");
        let body = body.replace("mass = 2.0", "mass = 0.0");
        let body = body.replace("[0.0, 0.1, 0.3]", "[0.0, 0.0, 0.3]");
        body + &format!("joint_name = \"{name}_joint\"\n")
    };
    let faults = |n: usize, lower: &str| {
        let mut text = format!("name = \"system\"\nlower_bodies = {lower}\ngravity = [0, 0, 0]\n");
        for name in &["a", "b", "c"][..n] {
            text += &massless(name);
        }
        let last = text.rfind("mass = 0.0").unwrap();
        text.replace_range(last..last + "mass = 0.0".len(), "mass = 2.0");
        let inertia = "inertia = { xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01, xz = 0.0, yz = 0.0 }";
        let none = "inertia = { xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0 }";
        let last = text.rfind(inertia).unwrap();
        let (head, tail) = text.split_at(last);
        build(&(head.replace(inertia, none) + tail))
            .unwrap_err()
            .to_string()
    };
    let two = faults(2, "[0, 1]");
    assert!(
        two.contains("a motion of joints `a_joint` and `b_joint` together moves no mass"),
        "{two}"
    );
    let three = faults(3, "[0, 1, 2]");
    assert!(
        three.contains(
            "2 motions of joints `a_joint`, `b_joint` and `c_joint` together move no mass"
        ),
        "{three}"
    );
}

#[test]
fn springs_on_quaternions_are_told_what_to_do() {
    let spring = |joint: &str| {
        let text = system("[0]", &[("a", joint)]) + "chart = \"quaternion\"\nstiffness = 1.0\n";
        build(&text).unwrap_err().to_string()
    };
    for joint in ["\"spherical\"", "\"free\""] {
        let told = spring(joint);
        let advice = "add the moment of a spring on its orientation to `tau`";
        assert!(told.contains(advice), "{told}");
    }
}

#[test]
fn a_model_without_gravity_is_told_how_to_mean_it() {
    let text = system("[0]", &[("a", "[\"theta1\"]")]);
    let none = "gravity = [0, 0, 0]\n";
    assert!(!warnings(&build(&text).unwrap()).contains("gravity"));
    let told = warnings(&build(&text.replace(none, "")).unwrap());
    let advice = "or `gravity = [0.0, 0.0, 0.0]` if that is meant";
    assert!(told.contains(advice), "{told}");
}

#[test]
fn the_mass_centre_is_no_frame() {
    let tree = build(&system("[0]", &[("a", "[\"theta1\"]")]))
        .unwrap()
        .tree;
    for center in ["com", "center_of_mass", "CenterOfMass"] {
        let request = Parsed::read(&format!("jacobian({center})")).unwrap();
        let faults = request.on(&tree).unwrap_err();
        let told = Error::Requests(faults).to_string();
        assert!(told.contains("`center_of_mass_jacobian`"), "{told}");
    }
}
