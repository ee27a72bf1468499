//! What `kane info` shows of springs, dampers, rotors and friction.

use serde_json::Value;

use crate::{
    info::section,
    project::{Project, model, repository},
};

#[test]
fn what_acts_in_joints_is_shown_a_line_a_kind() {
    let project = Project::empty();
    let text = model("arm", "2.0");
    let shown = |options: &[&str]| {
        let ran = project.kane(&[&["info", "arm.toml", "--functions", "bias"], options].concat());
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.out
    };
    project.write("arm.toml", &text);
    assert!(!shown(&[]).contains("In joints"));
    let spring = "stiffness = { s2 = { runtime = 3.0 } }\nrest = { s2 = 0.5 }\ndamping = 0.1\n";
    let text = text.replace(
        "joint = [\"theta1\"",
        &format!("{spring}joint = [\"theta1\""),
    );
    project.write("arm.toml", &(text + "damping = 0.1\nfriction = 0.2\n"));
    insta::assert_snapshot!(section(&shown(&[]), "In joints"), @"
    stiffness, N m/rad or N/m: upper_s2 3.0
    rest, rad or m: upper_s2 0.5
    damping, N m s/rad or N s/m: 0.1 for all
    friction (not in the equations), N m or N: fore_theta2 0.2
    ");
    let said: Value = serde_json::from_str(&shown(&["--json"])).unwrap();
    let upper = &said["bodies"][0];
    assert_eq!(upper["stiffness"], serde_json::json!({ "s2": 3.0 }));
    assert_eq!(
        upper["damping"],
        serde_json::json!({ "theta1": 0.1, "s2": 0.1 })
    );
    assert_eq!(upper.get("armature"), None);
    assert_eq!(said["bodies"][1].get("stiffness"), None);
}

#[test]
fn what_acts_in_joints_is_named_by_motions_or_components_of_angular_velocity() {
    let path = repository("examples/optimal/models/tumbler.toml");
    let shown = |options: &[&str]| {
        let all = [&["info", path.to_str().unwrap()], options].concat();
        Project::empty().kane(&all).out
    };
    insta::assert_snapshot!(section(&shown(&[]), "In joints"), @"
    stiffness, N m/rad or N/m: tail_theta3 2.0
    damping, N m s/rad or N s/m: arm_w1 0.02, arm_w2 0.02, arm_w3 0.02, tail_theta3 0.01
    ");
    let said: Value = serde_json::from_str(&shown(&["--json"])).unwrap();
    let arm = serde_json::json!({ "w1": 0.02, "w2": 0.02, "w3": 0.02 });
    assert_eq!(said["bodies"][1]["damping"], arm);
}

#[test]
fn numbers_that_were_made_exact_are_told_wherever_numbers_are_shown() {
    let project = Project::empty();
    let turned = |error: &str| {
        model("arm", "2.0").replace(
            "joint = [\"theta2\"]",
            &format!("joint = \"revolute\"\naxis = [0.0, {error}, 1.0]"),
        )
    };
    project.write("exact.toml", &turned("0.0"));
    project.write("near.toml", &turned("1e-11"));
    let told = |model: &str, more: &[&str]| {
        let info = ["info", model].to_vec();
        let eval = ["eval", model, "-f", "inertial_parameters"].to_vec();
        [info, eval].map(|command| {
            let ran = project.kane(&[&command[..], more].concat());
            assert_eq!(ran.code, 0, "{}", ran.err);
            ran.err
        })
    };
    let note = "note: near.toml: entries of constant rotations and axes nearer than 1e-9 to 0, 1 or -1 were made exact, which changed none by more than 1.0e-11: `axis` of `fore`\n";
    assert_eq!(told("near.toml", &[]), [note, note]);
    assert_eq!(told("near.toml", &["--quiet"]), ["", ""]);
    assert_eq!(told("exact.toml", &[]), ["", ""]);
}
