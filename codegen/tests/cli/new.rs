//! `kane new` and `kane completions`.

use std::process::Command;

#[cfg(unix)]
use kane_test_support::tool::tool;

use super::project::{Project, model, repository};

/// A floating robot with a joint.
const ROBOT: &str = "<robot name=\"bird\">
    <link name=\"hull\"><inertial><mass value=\"2\"/>
    <inertia ixx=\"1\" iyy=\"1.2\" izz=\"1.4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <link name=\"wing\"><inertial><origin xyz=\"0 0.3 0\"/><mass value=\"0.5\"/>
    <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <joint name=\"shoulder\" type=\"continuous\"><parent link=\"hull\"/><child link=\"wing\"/><axis xyz=\"1 0 0\"/></joint>
    </robot>";

/// An arm as exporters write it: with rounded right angles, of which sines and cosines multiply, and a light finger with a damper that stops
/// it within a third of a millisecond.
const GRIPPER: &str = "<robot name=\"gripper\">
    <link name=\"base\"/>
    <link name=\"arm\"><inertial><origin xyz=\"0.1 0.2 0.3\"/><mass value=\"1\"/>
    <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <link name=\"finger\"><inertial><origin xyz=\"0.01 0 0.01\"/><mass value=\"0.1\"/>
    <inertia ixx=\"0.0003\" iyy=\"0.0003\" izz=\"0.0003\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <joint name=\"elbow\" type=\"continuous\"><parent link=\"base\"/><child link=\"arm\"/>
    <origin xyz=\"0.06 0 0\" rpy=\"1.5708 0 -3.1416\"/><axis xyz=\"0 0 1\"/></joint>
    <joint name=\"grip\" type=\"continuous\"><parent link=\"arm\"/><child link=\"finger\"/>
    <origin xyz=\"0.5 0 0.5\"/><axis xyz=\"0 1 0\"/><dynamics damping=\"1\"/></joint>
    </robot>";

#[test]
fn new_packages_run_pass_their_tests_and_are_up_to_date() {
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    project.write("gripper.urdf", GRIPPER);
    let kane = repository("");
    let kane = kane.to_str().unwrap();
    let target = project.path("target");
    for arguments in [
        &["new", "pendulum", "--kane", kane][..],
        &["new", "bird", "bird.urdf", "--base", "free", "--kane", kane],
        &["new", "gripper", "gripper.urdf", "--kane", kane],
    ] {
        let name = arguments[1];
        let ran = project.kane(arguments);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let last = ran.err.lines().last().unwrap();
        assert_eq!(last, format!("wrote {name}/; next: cd {name} && cargo run"));
        // As rustfmt has them.
        let program = project.read(&format!("{name}/src/main.rs"));
        let uses = program.lines().filter(|line| line.starts_with("use "));
        assert!(
            uses.map(|line| line.split("::").next()).is_sorted(),
            "{program}"
        );
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

/// Of `cl` the Makefile knows nothing.
#[cfg(unix)]
#[test]
fn new_package_in_c_runs_and_is_up_to_date() {
    let tools = ["make", "cc"].map(|name| tool(name, "a new package in C"));
    let [Some(make), Some(_)] = tools else {
        return;
    };
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    let kane = repository("");
    let kane = kane.to_str().unwrap();
    let new = ["new", "bird", "bird.urdf", "--base", "free"];
    let ran = project.kane(&[&new[..], &["--abi", "c", "--kane", kane]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let next = "wrote bird/; next: cd bird && make run";
    assert_eq!(ran.err.lines().last(), Some(next));
    let check = project.kane_in("bird", &["check"]);
    assert_eq!((check.code, check.out.as_str()), (0, ""), "{}", check.err);
    let mut make = Command::new(make);
    let make = make.current_dir(project.path("bird")).args([
        "--silent",
        "run",
        "CFLAGS=-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror",
    ]);
    let make = make.env("CARGO_NET_OFFLINE", "true");
    let target = project.path("target");
    let output = make.env("CARGO_TARGET_DIR", &target).output().unwrap();
    let printed = String::from_utf8_lossy(&output.stdout);
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{printed}{told}");
    assert!(!told.contains("warning"), "{told}");
    let last = "u = 0.000 0.000 0.000 0.000 0.000 0.000 0.000\n";
    assert!(printed.ends_with(last), "{printed}");
    // What it does not call is not linked; texts for debuggers may still name it.
    let program = std::fs::read(target.join("release/bird")).unwrap();
    let count = |name: &str| {
        let parts = program.windows(name.len());
        parts.filter(|part| *part == name.as_bytes()).count()
    };
    assert!(count("bird_inverse_dynamics_f64") > count("bird_inverse_dynamics_f32"));
}

#[test]
fn model_that_includes_others_is_written_whole_as_it_was_read() {
    let project = Project::empty();
    let part = "<mujoco><worldbody><body name=\"arm\"><inertial pos=\"0 0 0.1\" mass=\"1\" diaginertia=\"1 1 1\"/>\
                <freejoint name=\"base\"/></body></worldbody></mujoco>";
    project.write("part.xml", part);
    project.write(
        "whole.xml",
        "<mujoco><option density=\"1\"/><include file=\"part.xml\"/></mujoco>",
    );
    let new = ["new", "robot", "whole.xml"];
    let options = ["--leave-out", "fluid", "--chart", "angles"];
    let ran = project.kane(&[&new[..], &options].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.err.starts_with("warning: whole.xml:1:"), "{}", ran.err);
    let model = project.read("robot/models/robot.toml");
    assert!(model.contains("name = \"arm\""), "{model}");
    let module = project.read("robot/src/robot.rs");
    assert!(module.contains("pub const NQ: usize = 6;"));
    assert_eq!(project.kane_in("robot", &["check"]).code, 0);
    let version = env!("CARGO_PKG_VERSION");
    let depends = format!("kane = {{ version = \"{version}\"");
    assert!(project.read("robot/Cargo.toml").contains(&depends));
    let workflow = project.read("robot/.github/workflows/kane.yml");
    assert!(
        workflow.contains(&format!("--version {version}\n")),
        "{workflow}"
    );
}

#[test]
fn changes_of_the_model_go_into_kane_toml_and_the_start_is_within_the_limits() {
    let project = Project::empty();
    let limits = "<limit lower=\"-3\" upper=\"-1\" velocity=\"1\" effort=\"1\"/>";
    let massless = "<link name=\"tip\"/><joint name=\"roll\" type=\"continuous\"><parent link=\"wing\"/><child link=\"tip\"/></joint>";
    let robot = ROBOT
        .replace("type=\"continuous\"", "type=\"revolute\"")
        .replace("</joint>", &format!("{limits}</joint>{massless}"));
    project.write("bird.urdf", &robot);
    let options = ["--remove-massless", "--snap", "1e-5"];
    let refused = project.kane(&["new", "bird", "bird.urdf"]);
    assert_eq!(refused.code, 2);
    let ran = project.kane(&[&["new", "bird", "bird.urdf"][..], &options].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let config = project.read("bird/kane.toml");
    assert!(
        config.contains("\nsnap = 1e-5\nremove_massless = true\n"),
        "{config}"
    );
    assert!(config.contains("\"jacobian(tip)\""), "{config}");
    assert_eq!(project.kane_in("bird", &["check"]).code, 0);
    let program = project.read("bird/src/main.rs");
    assert!(program.contains("    -2.0, // shoulder\n"), "{program}");
    // Of one end alone, there.
    let arm = model("arm", "2.0") + "limits = { theta2 = { lower = 0.5 } }\n";
    project.write("arm.toml", &arm);
    let options = ["--lock", "upper_theta1=0.1", "--prescribed", "fore"];
    let ran = project.kane(&[&["new", "held", "arm.toml"][..], &options].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let config = project.read("held/kane.toml");
    let changes = "lock = { \"upper_theta1\" = 0.1 }\nprescribed = [\"fore\"]\n";
    assert!(config.contains(changes), "{config}");
    assert_eq!(project.kane_in("held", &["check"]).code, 0);
    let program = project.read("held/src/main.rs");
    assert!(program.contains("    0.5, // fore_theta2\n"), "{program}");
}

#[test]
fn changes_that_cannot_be_made_are_refused_before_anything_is_written() {
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    let before = project.files();
    let ran = project.kane(&["new", "bird", "bird.urdf", "--lock", "hull=0"]);
    assert!(ran.code == 2 && ran.err.contains("`hull`"), "{}", ran.err);
    assert_eq!(project.files(), before);
}

#[test]
fn what_cannot_be_a_package_is_refused_and_nothing_written() {
    let project = Project::empty();
    project.write("there/file", "");
    project.write("broken.urdf", "<robot");
    project.write("arm.rs", "");
    let before = project.files();
    for (arguments, told) in [
        (&["new", "my-arm"][..], "`my-arm` cannot be the name"),
        (&["new", "test"], "`test` cannot be the name"),
        (&["new", "tests"], "`tests` cannot be the name"),
        (&["new", "lib"], "`lib` cannot be the name"),
        (&["new", "f64"], "`f64` cannot be the name"),
        (&["new", "Arm"], "expected a lower-case letter first"),
        (&["new", "Self"], "`Self` cannot be the name"),
        (&["new", "build"], "Rust or cargo use it for something else"),
        (&["new", "there"], "`there` is there already"),
        (&["new", "arm", "broken.urdf"], "broken.urdf:1:"),
        (&["new", "arm", "arm.rs"], "`.rs` is no model"),
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
fn workspace_around_a_new_package_is_told() {
    let project = Project::empty();
    let kane = repository("");
    let is_told = |name: &str| {
        let ran = project.kane(&["new", name, "--kane", kane.to_str().unwrap()]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        ran.err
            .contains("Cargo.toml` is a workspace: the package has to be among its `members`")
    };
    assert!(!is_told("alone"));
    for (name, manifest, expected) in [
        ("table", "\u{feff}[ workspace ]\r\nmembers = []\r\n", true),
        ("dotted", "workspace.members = []\n", true),
        ("comment", "# [workspace]\n[package]\nname = \"a\"\n", false),
        ("text", "a = \"\"\"\n[workspace]\n\"\"\"\n", false),
    ] {
        project.write("Cargo.toml", manifest);
        assert_eq!(is_told(name), expected, "{name}");
    }
}

#[test]
fn folder_of_the_crate_stays_relative_where_it_was_given_so() {
    let project = Project::empty();
    project.write("crates/kane/Cargo.toml", "");
    let dependency = |name: &str, kane: &str| {
        let ran = project.kane(&["new", name, "--kane", kane]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let manifest = project.read(&format!("{name}/Cargo.toml"));
        let line = manifest.lines().find(|line| line.starts_with("kane = "));
        line.unwrap_or_default().to_owned()
    };
    let relative = "kane = { path = \"../../crates/kane\", default-features = false }";
    assert_eq!(dependency("robots/arm", "crates/kane"), relative);
    // Cargo follows links before it goes up.
    #[cfg(unix)]
    {
        project.write("deep/below/file", "");
        std::os::unix::fs::symlink(project.path("deep/below"), project.path("link")).unwrap();
        let relative = relative.replace("../../crates", "../../../crates");
        assert_eq!(dependency("link/hand", "crates/kane"), relative);
    }
    let absolute = project.path("crates/kane");
    let absolute = absolute.canonicalize().unwrap();
    let line = dependency("leg", absolute.to_str().unwrap());
    assert!(line.contains(absolute.to_str().unwrap()), "{line}");
}

#[test]
fn shells_are_told_every_command() {
    let help = Project::empty().kane(&["--help"]).out;
    let (_, commands) = help.split_once("Commands:\n").unwrap();
    let commands = commands.lines().take_while(|line| !line.is_empty());
    let commands: Vec<&str> = commands
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(commands.len() > 8, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = Project::empty().kane(&["completions", shell]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let is_word = |character: char| character.is_alphanumeric() || character == '_';
        let words: Vec<&str> = ran.out.split(|c| !is_word(c)).collect();
        for command in &commands {
            assert!(words.contains(command), "{shell}: {command}");
        }
    }
}

#[test]
fn what_stands_in_the_wrong_place_is_told() {
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    let ran = project.kane(&["new", "bird.urdf", "bird"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `bird.urdf` is a file; the name of the package comes first, then the model");
    let generator = repository("codegen");
    let ran = project.kane(&[
        "new",
        "bird",
        "bird.urdf",
        "--kane",
        generator.to_str().unwrap(),
    ]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("holds the package `kane-codegen`; expected the folder of the crate `kane`"),
        "{}",
        ran.err
    );
    let ran = project.kane(&["new", "."]);
    insta::assert_snapshot!(ran.err, @"error: `.` is there already; expected the name of a new folder");
    let ran = project.kane(&["new", "math", "bird.urdf", "--abi", "c"]);
    assert!(ran.err.contains("header of C"), "{}", ran.err);
}

#[test]
fn prescribed_joints_get_the_function_that_heeds_them() {
    let project = Project::empty();
    project.write("bird.urdf", ROBOT);
    let ran = project.kane(&["new", "bird", "bird.urdf", "--prescribed", "shoulder"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(!ran.err.contains("changes nothing"), "{}", ran.err);
    assert!(
        project
            .read("bird/kane.toml")
            .contains("functions = [\"default\", \"hybrid_dynamics\"]")
    );
    assert!(
        project
            .read("bird/src/bird.rs")
            .contains("pub fn hybrid_dynamics<")
    );
    let ran = project.kane_in("bird", &["check"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn package_that_cannot_be_written_whole_leaves_nothing() {
    let project = Project::empty();
    // The name of the file of tests, which is longer than the module's, is too long.
    let name = "a".repeat(250);
    let ran = project.kane(&["new", &name]);
    assert_eq!(ran.code, 2, "{}", ran.err);
    assert!(ran.err.contains("_tests.rs`: "), "{}", ran.err);
    assert!(!project.path(&name).exists(), "{:?}", project.files());
}
