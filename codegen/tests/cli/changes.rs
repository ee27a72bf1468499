//! The arguments that say how a model is read and what is changed of it.

use super::project::{Project, system};

const COMMANDS: [&[&str]; 4] = [
    &["generate", "models/arm.toml", "--output", "-"],
    &["check", "models/arm.toml"],
    &["info", "models/arm.toml"],
    &[
        "eval",
        "models/arm.toml",
        "--function",
        "bias",
        "--state",
        "state.json",
    ],
];

/// The second line of `generated/arm.rs`, from the tolerance on.
fn changes(project: &Project) -> String {
    let text = project.read("generated/arm.rs");
    let line = text.lines().nth(1).unwrap();
    line[line.find("snap: ").unwrap()..].to_owned()
}

#[test]
fn every_command_knows_them() {
    for command in ["generate", "check", "info", "eval"] {
        let help = Project::empty().kane(&[command, "--help"]).out;
        for option in [
            "--base <",
            "--chart <",
            "--leave-out <",
            "--snap <",
            "--lock <",
            "--remove <",
            "--remove-massless[",
            "--prescribed <",
        ] {
            assert!(help.contains(option), "{command} {option}");
        }
    }
}

#[test]
fn model_that_says_it_itself_is_not_told_its_base_or_chart() {
    let project = Project::arm();
    project.write(
        "state.json",
        r#"{"q": [0, 0, 0], "u": [0, 0, 0], "u_dot": [0, 0, 0]}"#,
    );
    for command in COMMANDS {
        let arguments = ["--base", "fixed", "--chart", "angles"];
        let ran = project.kane(&[command, &arguments[..]].concat());
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{command:?}");
        assert!(
            ran.err
                .starts_with("error: the base can be chosen for a URDF alone: ")
                && ran
                    .err
                    .contains("\n\nerror: the chart can be chosen for a URDF or MJCF alone: "),
            "{}",
            ran.err
        );
    }
}

#[test]
fn key_that_a_format_has_not_is_pointed_at_in_kane_toml() {
    let project = Project::arm();
    project.write(
        "kane.toml",
        &(system("models/arm.toml", "generated/arm.rs")
            + "base = \"free\"\nleave_out = [\"tendons\"]\n"),
    );
    let ran = project.kane(&["generate"]);
    insta::assert_snapshot!(ran.err);
    // What is said on the command line stands nowhere.
    let ran = project.kane(&["generate", "models/arm.toml", "--base", "free"]);
    assert!(!ran.err.contains("base = "), "{}", ran.err);
}

#[test]
fn values_that_are_none_are_refused() {
    for (option, value, reason) in [
        ("--base", "floating", "[possible values: fixed, free]"),
        ("--chart", "euler", "[possible values: angles, quaternion]"),
        ("--snap", "0.5", "expected at least 0 and less than 0.01"),
        ("--snap", "nan", "expected at least 0 and less than 0.01"),
        ("--snap", "x", "expected a number"),
        ("--lock", "elbow=up", "`up` is no number"),
        ("--lock", "elbow=inf", "expected a finite number"),
        ("--lock", "=0.5", "expected a name before the value"),
    ] {
        for command in COMMANDS {
            let ran = Project::arm().kane(&[command, &[option, value]].concat());
            assert_eq!((ran.code, ran.out.as_str()), (2, ""));
            assert!(ran.err.contains(reason), "{option} {value}: {}", ran.err);
        }
    }
}

#[test]
fn a_coordinate_of_an_orientation_cannot_be_locked() {
    let project = Project::arm();
    let free = "\"free\"\nchart = \"quaternion\"";
    project.replace("models/arm.toml", r#"["theta1", "s2"]"#, free);
    let ran = project.kane(&["info", "models/arm.toml", "--lock", "upper_e1=0.3"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("it is part of an orientation"),
        "{}",
        ran.err
    );
}

#[test]
fn names_given_twice_are_reported_together() {
    let arguments = [
        "info",
        "models/arm.toml",
        "--lock",
        "fore",
        "--lock",
        "fore=0.5",
        "--remove",
        "upper",
        "--remove",
        "upper",
    ];
    let ran = Project::arm().kane(&arguments);
    assert_eq!(ran.code, 2);
    assert_eq!(
        ran.err,
        "error: --lock names `fore` twice\nerror: --remove names `upper` twice\n"
    );
}

#[test]
fn options_stand_above_kane_toml() {
    let project = Project::arm();
    let config = project.read("kane.toml") + "snap = 1e-6\nlock = { fore = 0.25 }\n";
    project.write("kane.toml", &config);
    assert_eq!(project.kane(&["generate"]).code, 0);
    assert_eq!(changes(&project), "snap: 1e-6; lock: \"fore\" = 0.25.");
    let ran = project.kane(&["generate", "models/arm.toml", "--lock", "fore=-0.5"]);
    assert_eq!(ran.code, 0, "{ran:?}");
    assert_eq!(changes(&project), "snap: 1e-6; lock: \"fore\" = -0.5.");
    let ran = project.kane(&["generate", "models/arm.toml", "--snap", "0"]);
    assert_eq!(ran.code, 0, "{ran:?}");
    assert_eq!(changes(&project), "snap: 0.0; lock: \"fore\" = 0.25.");
}

#[test]
fn command_that_is_printed_has_them() {
    let project = Project::generated();
    for arguments in [
        ["--snap", "1e-5", "--lock", "fore=0.5"],
        ["--snap", "0.0", "--remove", "fore"],
    ] {
        let ran = project.kane(&[&["check", "models/arm.toml"], &arguments[..]].concat());
        assert_eq!(ran.code, 1);
        let expected = format!(
            "run: kane generate models/arm.toml {}\n",
            arguments.join(" ")
        );
        assert!(ran.out.ends_with(&expected), "{}", ran.out);
    }
}

/// An arm with a finger that has no mass.
const FINGER: &str = "<robot name=\"arm\"><link name=\"base\"/><link name=\"arm\"><inertial><mass value=\"1\"/>\
    <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><link name=\"finger\"/>\
    <joint name=\"elbow\" type=\"continuous\"><parent link=\"base\"/><child link=\"arm\"/></joint>\
    <joint name=\"grip\" type=\"prismatic\"><parent link=\"arm\"/><child link=\"finger\"/>\
    <limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint></robot>\n";

#[test]
fn motions_without_mass_are_removed_wherever_that_is_said() {
    let project = Project::empty();
    project.write("arm.urdf", FINGER);
    let ran = project.kane(&["generate", "arm.urdf", "--output", "arm.rs"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("error: joint `grip` moves no mass")
            && ran.err.contains("`--remove-massless`"),
        "{}",
        ran.err
    );
    let ran = project.kane(&[
        "generate",
        "arm.urdf",
        "--output",
        "arm.rs",
        "--remove-massless",
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        ran.err
            .contains("held at zero, for it moves no mass: `grip`"),
        "{}",
        ran.err
    );
    let banner = |project: &Project| project.read("arm.rs").lines().nth(1).unwrap().to_owned();
    assert!(
        banner(&project).ends_with("; remove_massless: true."),
        "{}",
        banner(&project)
    );
    // The command that brings the file up to date has it.
    project.write("arm.rs", &project.read("arm.rs").replace("let ", "let  "));
    let ran = project.kane(&[
        "check",
        "arm.urdf",
        "--output",
        "arm.rs",
        "--remove-massless",
    ]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    assert!(
        ran.out
            .ends_with("run: kane generate arm.urdf --output arm.rs --remove-massless\n"),
        "{}",
        ran.out
    );
    let config = "[[system]]\nmodel = \"arm.urdf\"\noutput = \"arm.rs\"\nremove_massless = true\n";
    project.write("kane.toml", config);
    assert_eq!(project.kane(&["generate"]).code, 0);
    assert!(
        banner(&project).ends_with("; remove_massless: true."),
        "{}",
        banner(&project)
    );
    let ran = project.kane(&["generate", "arm.urdf", "--remove-massless=false"]);
    assert_eq!(ran.code, 2, "{}", ran.err);
    let ran = project.kane(&[
        "info",
        "arm.urdf",
        "--remove-massless",
        "--functions",
        "q_dot",
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn rounded_angles_are_told_where_operations_are_counted_and_not_by_check() {
    let project = Project::empty();
    let turned = FINGER
        .replace("<link name=\"finger\"/>", "<link name=\"finger\"><inertial><origin xyz=\"0.1 0.2 0.3\"/><mass value=\"2\"/>\
            <inertia ixx=\"1\" iyy=\"2\" izz=\"2.5\" ixy=\"0.1\" ixz=\"0\" iyz=\"0\"/></inertial></link>")
        .replace("<parent link=\"arm\"/>", "<origin rpy=\"1.5708 0 0\"/><parent link=\"arm\"/>");
    project.write("arm.urdf", &turned);
    let says = |arguments: &[&str]| {
        let ran = project.kane(arguments);
        assert!(ran.code < 2, "{}", ran.err);
        ran.err
            .contains(": rounded right angles cost operations: `--snap 1e-5`")
    };
    assert!(says(&["generate", "arm.urdf", "--output", "arm.rs"]));
    assert!(says(&["info", "arm.urdf"]));
    assert!(!says(&["check", "arm.urdf", "--output", "arm.rs"]));
    assert!(!says(&[
        "generate", "arm.urdf", "--output", "arm.rs", "--snap", "1e-5"
    ]));
}

#[test]
fn what_an_mjcf_leaves_out_is_warned_of_and_stands_in_the_banner() {
    let project = Project::arm();
    project.write(
        "models/arm.xml",
        "<mujoco><option density=\"1\"/><worldbody><body name=\"a\"><joint name=\"j\"/><geom size=\"1\"/></body></worldbody>
<equality><connect name=\"loop\" body1=\"a\" anchor=\"0 0 0\"/></equality></mujoco>",
    );
    let generate = ["generate", "models/arm.xml", "--output", "-"];
    let ran = project.kane(&generate);
    assert_eq!(ran.code, 2);
    for option in ["`--leave-out fluid`", "`--leave-out loop`"] {
        assert!(ran.err.contains(option), "{}", ran.err);
    }
    let ran = project.kane(&[&generate[..], &["--leave-out", "loop,fluid"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.err.contains(": connect equality `loop` is left out"));
    let banner = ran.out.lines().nth(1).unwrap_or_default();
    assert!(
        banner.contains("leave_out: \"fluid\", \"loop\""),
        "{banner}"
    );
    let ran = project.kane(&["info", "models/arm.toml", "--leave-out", "fluid"]);
    assert_eq!(ran.code, 2);
    let fault = "error: what is left out can be chosen for an MJCF alone: ";
    assert!(ran.err.contains(fault), "{}", ran.err);
}

/// A project whose `kane.toml` has these lines more.
fn project(more: &str) -> Project {
    let project = Project::arm();
    let config = system("models/arm.toml", "generated/arm.rs");
    project.write("kane.toml", &format!("{}\n{more}\n", config.trim_end()));
    project
}

#[test]
fn unknown_joints_are_pointed_at_in_kane_toml() {
    let project = project("lock = { foer = 0.1, upper = 0.2 }\nremove = [\"hand\", \"upper\"]");
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err);
    // The same of one model, and of what is up to date.
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).err, ran.err);
    assert_eq!(project.kane(&["check"]).err, ran.err);
}

#[test]
fn unknown_joint_of_the_command_line_has_no_place_in_kane_toml() {
    let project = project("remove = [\"hand\"]");
    let ran = project.kane(&["generate", "models/arm.toml", "--remove", "hand"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(!ran.err.contains("kane.toml"), "{}", ran.err);
    assert!(
        ran.err
            .starts_with("error: `remove` names `hand`; no joint is called so"),
        "{}",
        ran.err
    );
}

#[test]
fn list_of_the_command_line_leaves_the_places_of_the_other() {
    let project = project("lock = { foer = 0.1 }\nremove = [\"hand\"]");
    let ran = project.kane(&["generate", "models/arm.toml", "--lock", "fore"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(ran.err.contains("--> kane.toml:6:11"), "{}", ran.err);
    assert!(!ran.err.contains("foer"), "{}", ran.err);
}

#[test]
fn faults_of_the_model_and_of_kane_toml_are_told_together() {
    let project = project("remove = [\"hand\"]");
    let model = project
        .read("models/arm.toml")
        .replacen("mass = 2.0", "mass = -2.0", 1);
    project.write("models/arm.toml", &model);
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    for fault in ["`mass` of body `upper` is -2.0", "`remove` names `hand`"] {
        assert_eq!(ran.err.matches(fault).count(), 1, "{}", ran.err);
    }
}

#[test]
fn info_and_eval_see_the_model_that_is_generated() {
    let project = Project::arm();
    let config = project.read("kane.toml") + "lock = { fore = 0.25 }\n";
    project.write("kane.toml", &config);
    project.write("state.json", "{\"q\": [0.5, 0.1]}");
    let n_coordinates = |words: &[&str]| {
        let ran = project.kane(&[&["info", "models/arm.toml", "--json"][..], words].concat());
        let value: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
        value["coordinates"].as_array().unwrap().len()
    };
    assert_eq!(n_coordinates(&[]), 2);
    // What is said on the command line stands above it.
    assert_eq!(
        n_coordinates(&["--lock", "upper_theta1", "--lock", "upper_s2"]),
        1
    );
    let mass_matrix = |words: &[&str]| {
        let command = [
            "eval",
            "models/arm.toml",
            "-f",
            "mass_matrix",
            "-s",
            "state.json",
        ];
        let ran = project.kane(&[&command, words].concat());
        assert_eq!((ran.code, ran.err.as_str()), (0, ""));
        ran.out
    };
    let locked = mass_matrix(&[]);
    assert_eq!(locked, mass_matrix(&["--lock", "fore=0.25"]));
    assert_ne!(locked, mass_matrix(&["--lock", "fore=1.25"]));
    // A model that is not listed is as it is.
    project.write("other.toml", &project.read("models/arm.toml"));
    let ran = project.kane(&["info", "other.toml", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(value["coordinates"].as_array().unwrap().len(), 3);
}

#[test]
fn several_names_in_one_are_told_apart() {
    let project = Project::arm();
    let told = |option: &str, names: &str| {
        let ran = project.kane(&["info", "models/arm.toml", option, names]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{option}");
        ran.err
    };
    let help = "these are several names: give each by itself";
    for (option, names) in [
        ("--lock", "upper_theta1=0.1,upper_s2=0.2"),
        ("--remove", "upper,fore"),
        ("--prescribed", "upper,fore"),
    ] {
        assert!(told(option, names).contains(help), "{option}");
    }
    assert!(!told("--remove", "uper,foer").contains(help));
    let coordinates = "the coordinates of that joint are upper_theta1, upper_s2";
    assert!(told("--lock", "upper").contains(coordinates));
}

#[test]
fn changes_of_a_model_that_cannot_be_read_are_not_told_too() {
    let project = Project::empty();
    project.write("arm.toml", "name = ");
    project.write("arm.urdf", "<robot name=\"arm\"><link name=\"a\">");
    project.write("arm.xml", "<mujoco><include file=\"bodies.xml\"/></mujoco>");
    for model in ["arm.toml", "arm.urdf", "arm.xml"] {
        let changes = ["--lock", "elbow=0.5", "--remove", "wrist"];
        let ran = project.kane(&[&["info", model][..], &changes].concat());
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert_eq!(ran.err.matches("error: ").count(), 1, "{}", ran.err);
    }
}
