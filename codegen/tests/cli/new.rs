//! `kane new` and `kane completions`.

use std::process::Command;

use super::project::{Project, repository};

/// A floating robot with a joint.
const ROBOT: &str = "<robot name=\"bird\">
    <link name=\"hull\"><inertial><mass value=\"2\"/>
    <inertia ixx=\"1\" iyy=\"1.2\" izz=\"1.4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <link name=\"wing\"><inertial><origin xyz=\"0 0.3 0\"/><mass value=\"0.5\"/>
    <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <joint name=\"shoulder\" type=\"continuous\"><parent link=\"hull\"/><child link=\"wing\"/><axis xyz=\"1 0 0\"/></joint>
    </robot>";

#[test]
fn new_packages_run_pass_their_tests_and_are_up_to_date() {
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    let kane = repository("");
    let kane = kane.to_str().unwrap();
    let target = project.path("target");
    for arguments in [
        &["new", "pendulum", "--kane", kane][..],
        &["new", "bird", "bird.urdf", "--base", "free", "--kane", kane],
    ] {
        let name = arguments[1];
        let ran = project.kane(arguments);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let last = ran.err.lines().last().unwrap();
        assert_eq!(last, format!("wrote {name}/; next: cd {name} && cargo run"));
        let check = project.kane_in(name, &["check"]);
        assert_eq!((check.code, check.out.as_str()), (0, ""), "{}", check.err);
        let mut cargo = Command::new(env!("CARGO"));
        let cargo = cargo
            .args(["test", "--offline", "--quiet"])
            .current_dir(project.path(name));
        let output = cargo.env("CARGO_TARGET_DIR", &target).output().unwrap();
        let printed = String::from_utf8_lossy(&output.stdout);
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{printed}{told}");
        assert!(!told.contains("warning"), "{told}");
        let mut program = Command::new(env!("CARGO"));
        let program = program
            .args(["run", "--offline", "--quiet"])
            .current_dir(project.path(name));
        let output = program.env("CARGO_TARGET_DIR", &target).output().unwrap();
        let printed = String::from_utf8_lossy(&output.stdout);
        assert!(printed.starts_with("after two seconds\nq = ["), "{printed}");
    }
}

#[test]
fn model_that_includes_others_is_written_whole() {
    let project = Project::empty();
    let part = "<mujoco><worldbody><body name=\"arm\"><inertial pos=\"0 0 0.1\" mass=\"1\" diaginertia=\"1 1 1\"/>\
                <joint name=\"turn\"/></body></worldbody></mujoco>";
    project.write("part.xml", part);
    project.write("whole.xml", "<mujoco><include file=\"part.xml\"/></mujoco>");
    let ran = project.kane(&["new", "robot", "whole.xml"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let model = project.read("robot/models/robot.toml");
    assert!(model.contains("name = \"arm\""), "{model}");
    assert_eq!(project.kane_in("robot", &["check"]).code, 0);
    assert!(
        project
            .read("robot/Cargo.toml")
            .contains("kane = { version = \"0.1.0\"")
    );
}

#[test]
fn what_cannot_be_a_package_is_refused_and_nothing_written() {
    let project = Project::empty();
    project.write("there/file", "");
    project.write("broken.urdf", "<robot");
    let before = project.files();
    for (arguments, told) in [
        (&["new", "my-arm"][..], "`my-arm` cannot be the name"),
        (&["new", "test"], "`test` cannot be the name"),
        (&["new", "there"], "`there` is there already"),
        (&["new", "arm", "broken.urdf"], "broken.urdf:1:"),
        (
            &["new", "arm", "absent.urdf"],
            "cannot access `absent.urdf`",
        ),
        (
            &["new", "arm", "--kane", "there"],
            "`there` holds no package",
        ),
    ] {
        let ran = project.kane(arguments);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert!(ran.err.contains(told), "{told}\n{}", ran.err);
    }
    assert_eq!(project.files(), before);
}

#[test]
fn shells_are_told_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = Project::empty().kane(&["completions", shell]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        for command in [
            "generate", "check", "diff", "info", "eval", "convert", "verify", "new",
        ] {
            assert!(ran.out.contains(command), "{shell}: {command}");
        }
    }
}
