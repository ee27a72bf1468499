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
fn negative_limits_and_negative_friction_are_left_out() {
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
