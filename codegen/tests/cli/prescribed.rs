//! Joints whose accelerations are prescribed.

use serde_json::{Value, json};

use super::project::{Project, model, system};

const FUNCTIONS: &str = "functions = [\"hybrid_dynamics\"]\n";

/// An arm of three bodies on one another, with these names and joints.
fn arm(bodies: [(&str, &str); 3]) -> String {
    let bodies = bodies.map(|(name, joint)| {
        format!(
            "[[body]]\nname = \"{name}\"\nmass = 1.5\nmass_center = [0.1, 0.02, -0.4]\n\
             inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.0, xz = 0.01, yz = 0.0 }}\n\
             attachment = [0.0, 0.0, -1.0]\n{joint}\n"
        )
    });
    format!(
        "name = \"arm\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0, 1, 2]\n{}",
        bodies.concat()
    )
}

/// An arm whose second body is fixed or moves as it is said, and whose third follows the first.
fn followed(joint: &str) -> String {
    let hand = "joint = [\"theta2\"]\nmimic = { joint = \"shoulder\", multiplier = 2.0 }";
    arm([
        ("upper", "joint = [\"theta1\"]\njoint_name = \"shoulder\""),
        ("fore", joint),
        ("hand", hand),
    ])
}

/// A project with this model, these joints prescribed, and more lines in `kane.toml`.
fn project(model: &str, prescribed: &str, more: &str) -> Project {
    let project = Project::empty();
    project.write("models/arm.toml", model);
    let config = system("models/arm.toml", "generated/arm.rs");
    let config = config.lines().filter(|line| !line.starts_with("functions"));
    let config: Vec<&str> = config.collect();
    let config = format!(
        "{}\n{FUNCTIONS}prescribed = {prescribed}\n{more}",
        config.join("\n")
    );
    project.write("kane.toml", &config);
    project
}

#[test]
fn unknown_joint_is_pointed_at_in_kane_toml() {
    let project = project(&followed("joint = [\"theta3\"]"), r#"["shulder"]"#, "");
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @r#"
    error: `prescribed` of system 1: `shulder` is no joint of the model
     --> kane.toml:5:15
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    ...
    5 | prescribed = ["shulder"]
      |               ^^^^^^^^^ expected a joint with a speed of its own
      |
      = help: did you mean `shoulder`?
    "#);
    // The same of one model, and of what is up to date.
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).err, ran.err);
    assert_eq!(project.kane(&["check"]).err, ran.err);
}

#[test]
fn joints_without_speeds_of_their_own_are_pointed_at_together() {
    let model = followed("joint = \"fixed\"");
    let project = project(&model, r#"["fore", "hand", "elephant"]"#, "");
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @r#"
    error: `prescribed` of system 1: the joint `fore` has no speed: it is fixed in the model
     --> kane.toml:5:15
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    ...
    5 | prescribed = ["fore", "hand", "elephant"]
      |               ^^^^^^ expected a joint with a speed of its own
      |
      = help: leave it out: its acceleration is zero

    error: `prescribed` of system 1: the joint `hand` has no speed of its own: it follows `shoulder`
     --> kane.toml:5:23
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    ...
    5 | prescribed = ["fore", "hand", "elephant"]
      |                       ^^^^^^ expected a joint with a speed of its own
      |
      = help: prescribe `shoulder`, which moves both

    error: `prescribed` of system 1: `elephant` is no joint of the model
     --> kane.toml:5:31
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    ...
    5 | prescribed = ["fore", "hand", "elephant"]
      |                               ^^^^^^^^^^ expected a joint with a speed of its own
      |
      = help: joints with speeds are shoulder
    "#);
}

#[test]
fn joint_that_is_locked_or_removed_has_no_acceleration_to_prescribe() {
    let model = followed("joint = [\"theta3\"]");
    for more in ["lock = { fore = 0.5 }\n", "remove = [\"fore\"]\n"] {
        let project = project(&model, r#"["fore"]"#, more);
        let ran = project.kane(&["generate"]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert!(
            ran.err
                .contains("the joint `fore` has no speed: it is locked or removed"),
            "{}",
            ran.err
        );
        assert!(ran.err.contains("kane.toml:5:15"), "{}", ran.err);
    }
    let project = project(&model, r#"["hand"]"#, "lock = { shoulder = 0.5 }\n");
    let ran = project.kane(&["generate"]);
    assert!(
        ran.err
            .contains("it is locked or removed, or follows a joint that is"),
        "{}",
        ran.err
    );
    // Prescribing what it follows would not help.
    assert!(!ran.err.contains("of its own: it follows"), "{}", ran.err);
}

#[test]
fn joint_named_twice_is_pointed_at_by_both_names() {
    let model = followed("joint = [\"theta3\"]");
    let ran = project(&model, r#"["fore", "fore"]"#, "").kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @r#"
    error: `prescribed` of system 1 names `fore` twice
     --> kane.toml:5:23
      |
    5 | prescribed = ["fore", "fore"]
      |               ------  ^^^^^^ the second one
      |               |
      |               the first one
    "#);
    // By its own name and by its body's.
    let ran = project(&model, r#"["shoulder", "upper"]"#, "").kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @r#"
    error: `prescribed` of system 1: `shoulder` and `upper` are one joint
     --> kane.toml:5:27
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    ...
    5 | prescribed = ["shoulder", "upper"]
      |               ----------  ^^^^^^^ expected each joint once
      |               |
      |               the first one
      |
      = help: leave one of the two out
    "#);
}

#[test]
fn joint_may_be_called_as_a_fixed_body_before_it() {
    let hand = "joint = [\"theta2\"]\nmimic = { joint = \"j\", multiplier = 2.0 }";
    let model = arm([
        ("j", "joint = \"fixed\""),
        ("upper", "joint = [\"theta1\"]\njoint_name = \"j\""),
        ("hand", hand),
    ]);
    let ran = project(&model, r#"["j"]"#, "").kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn names_that_are_no_text_are_pointed_at() {
    let model = followed("joint = [\"theta3\"]");
    let ran = project(&model, "[1]", "").kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("kane.toml:5:15"), "{}", ran.err);
    let ran = project(&model, "\"fore\"", "").kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("kane.toml:5:14"), "{}", ran.err);
}

#[test]
fn joints_of_the_command_line_have_no_place_in_kane_toml() {
    let project = project(&followed("joint = [\"theta3\"]"), r#"["shulder"]"#, "");
    let ran = project.kane(&["generate", "models/arm.toml", "--prescribed", "hand"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @"error: `models/arm.toml`: the joint `hand` has no speed of its own: it follows `shoulder`; prescribe `shoulder`, which moves both");
    for command in [
        &["info", "models/arm.toml"][..],
        &["check", "models/arm.toml"],
    ] {
        let ran = project.kane(&[command, &["--prescribed", "hand"]].concat());
        assert_eq!(ran.code, 2);
        assert!(
            ran.err
                .starts_with("error: `models/arm.toml`: the joint `hand` has no speed of its own"),
            "{}",
            ran.err
        );
    }
    let twice = [
        "info",
        "models/arm.toml",
        "--prescribed",
        "fore",
        "--prescribed",
        "fore",
    ];
    assert_eq!(
        project.kane(&twice).err,
        "error: --prescribed names `fore` twice\n"
    );
}

#[test]
fn banner_repeats_them_in_an_order_of_their_own_and_what_was_written_is_up_to_date() {
    let model = followed("joint = [\"theta3\"]");
    let one = project(&model, r#"["shoulder", "fore"]"#, "");
    assert_eq!(one.kane(&["generate"]).code, 0);
    let module = one.read("generated/arm.rs");
    let line = module.lines().nth(1).unwrap();
    assert!(
        line.ends_with("snap: 1e-9; prescribed: \"fore\", \"shoulder\"."),
        "{line}"
    );
    assert_eq!(one.kane(&["check"]).code, 0);
    let other = project(&model, r#"["fore", "shoulder"]"#, "");
    assert_eq!(other.kane(&["generate"]).code, 0);
    assert_eq!(other.read("generated/arm.rs"), module);
    let none = project(&model, "[]", "");
    assert_eq!(none.kane(&["generate"]).code, 0);
    assert!(
        none.read("generated/arm.rs")
            .lines()
            .nth(1)
            .unwrap()
            .ends_with("snap: 1e-9.")
    );
    // Options stand above `kane.toml`.
    let ran = other.kane(&["generate", "models/arm.toml", "--prescribed", "fore"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let changed = other.read("generated/arm.rs");
    assert!(changed.contains("prescribed: \"fore\"."), "{changed}");
    assert!(
        changed.contains("PRESCRIBED: [bool; NU] = [false, true];"),
        "{changed}"
    );
    assert_eq!(other.kane(&["check"]).code, 1);
}

#[test]
fn module_without_the_function_has_no_constant_of_it_and_is_the_same_but_for_its_banner() {
    let project = Project::generated();
    let plain = project.read("generated/arm.rs");
    let config = project.read("kane.toml") + "prescribed = [\"fore\"]\n";
    project.write("kane.toml", &config);
    assert_eq!(project.kane(&["generate"]).code, 0);
    let module = project.read("generated/arm.rs");
    let after_banner = |text: &str| text.split_once("\n\n").unwrap().1.to_owned();
    assert_eq!(after_banner(&module), after_banner(&plain));
    assert_ne!(module, plain);
}

#[test]
fn manifest_and_header_say_which_speeds_they_are() {
    let more = "manifest = true\nabi = \"c\"\n";
    let project = project(&followed("joint = [\"theta3\"]"), r#"["fore"]"#, more);
    assert_eq!(project.kane(&["generate"]).code, 0);
    let manifest: Value = serde_json::from_str(&project.read("generated/arm.json")).unwrap();
    assert_eq!(manifest["prescribed"], json!(["fore_theta3_dot"]));
    let functions = manifest["functions"].as_array().unwrap();
    let hybrid = functions
        .iter()
        .find(|one| one["name"] == "hybrid_dynamics")
        .unwrap();
    let arguments = hybrid["arguments"].as_array().unwrap().iter();
    let arguments: Vec<&Value> = arguments.map(|argument| &argument["name"]).collect();
    assert_eq!(arguments, ["p", "q", "u", "u_dot", "tau"]);
    let outputs = hybrid["outputs"].as_array().unwrap().iter();
    let outputs: Vec<[&Value; 2]> = outputs
        .map(|own| ["name", "shape"].map(|key| &own[key]))
        .collect();
    assert_eq!(
        json!(outputs),
        json!([["whole_u_dot", [2]], ["whole_tau", [2]]])
    );
    let header = project.read("generated/arm.h");
    assert!(
        header.contains("int ARM_PRESCRIBED[ARM_NU] = {\n    0,\n    1\n};"),
        "{header}"
    );
}

#[test]
fn eval_and_info_prescribe_too() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    let state = json!({
        "q": [0.3, 0.1, -0.4], "u": [0.5, -0.2, 0.7], "u_dot": [1.0, 2.0, 3.0], "tau": [4.0, 5.0, 6.0]
    });
    let evaluated = |function: &str, options: &[&str], state: &Value| -> Value {
        let arguments = ["eval", "arm.toml", "--function", function, "--state", "-"];
        let ran = project.kane_given(&[&arguments, options].concat(), &state.to_string());
        assert_eq!(ran.code, 0, "{ran:?}");
        serde_json::from_str(&ran.out).unwrap()
    };
    let found = evaluated("hybrid_dynamics", &["--prescribed", "upper"], &state);
    assert_eq!(found["whole_u_dot"][0], 1.0);
    assert_eq!(found["whole_u_dot"][1], 2.0);
    assert_eq!(found["whole_tau"][2], 6.0);
    let mut moved = state.clone();
    moved["u_dot"] = found["whole_u_dot"].clone();
    let tau = evaluated("inverse_dynamics", &[], &moved);
    for speed in 0..3 {
        let [found, expected] =
            [&found["whole_tau"][speed], &tau[speed]].map(|one| one.as_f64().unwrap());
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
    let count = |options: &[&str]| {
        let arguments = [
            "info",
            "arm.toml",
            "--functions",
            "hybrid_dynamics",
            "--json",
        ];
        let ran = project.kane(&[&arguments, options].concat());
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.out
    };
    assert_ne!(count(&[]), count(&["--prescribed", "upper"]));
}

#[test]
fn diff_tells_what_prescribing_costs() {
    let project = project(&followed("joint = [\"theta3\"]"), "[]", "");
    assert_eq!(project.kane(&["generate"]).code, 0);
    let plain = project.read("generated/arm.rs");
    project.write("generated/plain.rs", &plain);
    let arguments = ["generate", "models/arm.toml", "--prescribed", "fore"];
    assert_eq!(project.kane(&arguments).code, 0);
    let ran = project.kane(&["diff", "generated/plain.rs", "generated/arm.rs"]);
    assert!(ran.out.contains("hybrid_dynamics"), "{ran:?}");
    assert!(
        ran.out
            .contains("bodies and joints are the same: options differ"),
        "{ran:?}"
    );
}

/// Two systems of one model, the second with the elbow prescribed.
fn of_two_systems() -> Project {
    let second = "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/bias.rs\"\nfunctions = [\"bias\"]\n";
    let project = project(&followed("joint = [\"theta3\"]"), r#"["fore"]"#, "");
    let own = project.read("kane.toml");
    project.write("kane.toml", &format!("{second}\n{own}"));
    project
}

#[test]
fn of_several_systems_of_a_model_that_with_the_function_is_looked_at() {
    let project = of_two_systems();
    let state = r#"{"q": {}, "u": {}, "tau": {}, "u_dot": {"fore_theta3_dot": 1.0}}"#;
    project.write("state.json", state);
    let ran = project.kane(&[
        "eval",
        "models/arm.toml",
        "--function",
        "hybrid_dynamics",
        "--state",
        "state.json",
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(found["whole_u_dot"][1], 1.0, "{}", ran.out);
    let count = |more: &[&str]| {
        let asked = ["info", "models/arm.toml", "--functions", "hybrid_dynamics"];
        let ran = project.kane(&[&asked[..], more].concat());
        let row = ran.out.lines().last().unwrap().to_owned();
        assert!(row.contains("hybrid_dynamics"), "{}", ran.out);
        row
    };
    assert_eq!(count(&[]), count(&["--prescribed", "fore"]));
    assert_ne!(count(&[]), count(&["--prescribed", "upper"]));
}

#[test]
fn functions_for_several_modules_of_a_model_need_an_output() {
    let project = of_two_systems();
    assert_eq!(project.kane(&["generate"]).code, 0);
    let before = project.read("generated/bias.rs");
    let asked = ["generate", "models/arm.toml", "--functions", "mass_matrix"];
    let ran = project.kane(&asked);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `kane.toml` generates `generated/bias.rs`, `generated/arm.rs` from this model; say with --output which of them --functions is for");
    assert_eq!(project.read("generated/bias.rs"), before);
    let ran = project.kane(&[&asked[..], &["--output", "generated/bias.rs"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_ne!(project.read("generated/bias.rs"), before);
    // Without, each is what `kane.toml` says.
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).code, 0);
    assert_eq!(project.read("generated/bias.rs"), before);
}

#[test]
fn nothing_prescribed_is_told_of_hybrid_dynamics() {
    let project = project(&followed("joint = [\"theta3\"]"), "[]", "");
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0);
    let told =
        "warning: models/arm.toml: `hybrid_dynamics` is forward dynamics: no joint is prescribed";
    assert!(ran.err.contains(told), "{}", ran.err);
    project.write(
        "state.json",
        "{\"q\": {}, \"u\": {}, \"u_dot\": {}, \"tau\": {}}",
    );
    let asked = |function| {
        let options = ["--function", function, "--state", "state.json"];
        project.kane(&[&["eval", "models/arm.toml"][..], &options].concat())
    };
    let ran = asked("hybrid_dynamics");
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.err.contains(told), "{}", ran.err);
    let ran = asked("forward_dynamics");
    assert!(!ran.err.contains("prescribed"), "{}", ran.err);
}

#[test]
fn places_of_prescribed_speeds_that_moved_are_no_other_speeds() {
    let free = followed("joint = [\"theta2\"]\njoint_name = \"elbow\"");
    let project = project(&free, r#"["elbow"]"#, "").committed();
    project.replace(
        "models/arm.toml",
        "joint = [\"theta1\"]\n",
        "joint = [\"theta1\", \"theta3\"]\n",
    );
    project.replace(
        "models/arm.toml",
        "mimic = { joint = \"shoulder\", multiplier = 2.0 }",
        "",
    );
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    assert!(
        ran.out.contains("BREAKING: the places in u changed"),
        "{}",
        ran.out
    );
    assert!(!ran.out.contains("prescribed speeds"), "{}", ran.out);
}
