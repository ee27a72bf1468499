//! What `kane diff` tells of generated text: which kind of difference it is, and what constants of modules hold.

use kane_codegen::report::ReadModule;
use serde_json::Value;

use super::project::{Project, Ran, model, repository, system};

/// A URDF and the same with an edit.
fn edited([from, to]: [&str; 2], options: &[&str]) -> Ran {
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    assert!(text.contains(from), "{from}");
    let project = Project::empty();
    project.write("old.urdf", &text);
    project.write("new.urdf", &text.replace(from, to));
    project.kane(&[&["diff", "old.urdf", "new.urdf"], options].concat())
}

/// A module of that URDF, `old.rs`, and one after an edit of the text, `new.rs`.
fn by_hand([from, to]: [&str; 2]) -> Project {
    let project = Project::empty();
    let robot = repository("models/arm.urdf");
    let robot = robot.to_str().unwrap();
    let functions = ["--functions", "bias,jacobian(tool)", "--output", "old.rs"];
    let ran = project.kane(&[&["generate", robot], &functions[..]].concat());
    assert_eq!(ran.code, 0, "{ran:?}");
    project.write("new.rs", &project.read("old.rs"));
    project.replace("new.rs", from, to);
    project
}

#[test]
fn base_parameters_that_are_other_sums_are_told_and_break_nothing() {
    let longer = ["xyz=\"0.4 0 0\"", "xyz=\"0.41 0 0\""];
    let functions = ["--functions", "base_regressor"];
    let ran = edited(longer, &functions);
    let said = "\nbase parameters\n  changed  BASE_PARAMETERS[0] and 4 more  izz(shoulder) + izz(upper_arm) + 0.16 m(forearm) + izz(forearm) -> ";
    assert!(ran.out.contains(said), "{}", ran.out);
    assert!(!ran.out.contains("BREAKING"), "{}", ran.out);
    // Names are no other sums.
    let ran = edited(["\"forearm\"", "\"radius\""], &functions);
    assert!(!ran.out.contains("base parameters"), "{}", ran.out);
}

#[test]
fn number_of_base_parameters_is_told_where_bodies_come() {
    let hinge = [
        "name=\"flange\" type=\"fixed\"",
        "name=\"flange\" type=\"continuous\"",
    ];
    let json = edited(
        hinge,
        &["--functions", "base_regressor", "--format", "json"],
    );
    let told: Value = serde_json::from_str(&json.out).unwrap();
    let base = &told["base_parameters"];
    assert_eq!(
        (&base["name"], &base["old"]),
        (&"BASE_PARAMETERS".into(), &"15 entries".into())
    );
    assert_ne!(base["new"], base["old"]);
}

#[test]
fn warnings_about_the_new_model_alone_are_told() {
    let typo = ["dynamics damping=\"0.05\"", "dynamics dampin=\"0.05\""];
    let ran = edited(typo, &[]);
    assert!(ran.err.starts_with("warning: new.urdf:"), "{}", ran.err);
    assert!(
        ran.err.contains("unknown attribute `dampin`"),
        "{}",
        ran.err
    );
    let ran = edited(typo, &["--format", "json"]);
    let told: Value = serde_json::from_str(&ran.out).unwrap();
    let warnings = told["warnings"].as_array().unwrap();
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    // What the old model has too is no news.
    let project = Project::empty();
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    let text = text.replace(typo[0], typo[1]);
    project.write("old.urdf", &text);
    project.write("new.urdf", &text.replace("\"0.5\"", "\"0.75\""));
    let ran = project.kane(&["diff", "old.urdf", "new.urdf"]);
    assert_eq!((ran.code, ran.err.as_str()), (1, ""));
}

#[test]
fn arrays_of_modules_that_hold_something_else_are_named() {
    let limits = [
        "LOWER_LIMITS: [f64; NQ] = [-3.1,",
        "LOWER_LIMITS: [f64; NQ] = [-3.05,",
    ];
    let ran = by_hand(limits).kane(&["diff", "old.rs", "new.rs"]);
    let said = "\nconstants\n  changed  LOWER_LIMITS[0]  -3.1 -> -3.05\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let tool = ["position: [0.3, 0.0, 0.0]", "position: [0.3, 0.5, 0.0]"];
    let project = by_hand(tool);
    let ran = project.kane(&["diff", "old.rs", "new.rs"]);
    let said = "FRAMES[1].position of tool  [0.3, 0.0, 0.0] -> [0.3, 0.5, 0.0]\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let ran = project.kane(&["diff", "old.rs", "new.rs", "--format", "json"]);
    let told: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(told["constants"][0]["name"], "FRAMES[1].position of tool");
}

#[test]
fn arrays_of_one_number_are_compared_with_lists() {
    let none = "FRICTION: [f64; NU] = [0.0; NU];";
    let list = by_hand([none, "FRICTION: [f64; NU] = [0.0, 0.5, 0.0];"]);
    let ran = list.kane(&["diff", "old.rs", "new.rs"]);
    let said = "\nconstants\n  changed  FRICTION[1]  0.0 -> 0.5\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let ran = list.kane(&["diff", "new.rs", "old.rs"]);
    let said = "\nconstants\n  changed  FRICTION[1]  0.5 -> 0.0\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let all = by_hand([none, "FRICTION: [f64; NU] = [0.5; NU];"]);
    let ran = all.kane(&["diff", "old.rs", "new.rs"]);
    let said = "\nconstants\n  changed  FRICTION[0] and 2 more  0.0 -> 0.5\n";
    assert!(ran.out.contains(said), "{}", ran.out);
}

#[test]
fn entries_of_arrays_are_told_as_people_write_them() {
    let unlimited = "VELOCITY_LIMITS: [f64; NU] = [f64::INFINITY, 3.0, 4.0]";
    let limits = by_hand(["VELOCITY_LIMITS: [f64; NU] = [3.0, 3.0, 4.0]", unlimited]);
    let ran = limits.kane(&["diff", "old.rs", "new.rs"]);
    let said = "VELOCITY_LIMITS[0]  3.0 -> f64::INFINITY\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let body = ["body: Some(2)", "body: Some(1)"];
    let ran = by_hand(body).kane(&["diff", "old.rs", "new.rs"]);
    let said = "  Some(2) -> Some(1)\n";
    assert!(ran.out.contains(said), "{}", ran.out);
}

#[test]
fn joints_are_told_once() {
    let angle = "q: [None, Some(2), None, None, None, None, None]";
    let length = "q: [None, None, None, None, Some(2), None, None]";
    let ran = by_hand([angle, length]).kane(&["diff", "old.rs", "new.rs"]);
    let said = "\nbodies and joints\n  changed  forearm: joint  theta2 -> s1\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    assert!(!ran.out.contains("JOINTS"), "{}", ran.out);
}

#[test]
fn module_that_was_edited_by_hand_is_known_as_such() {
    let note = "the model and all that is asked for are the same: edited by hand, or written by another version of kane\n";
    let ran =
        by_hand(["R::from_f64(9.81)", "R::from_f64(9.5)"]).kane(&["diff", "old.rs", "new.rs"]);
    assert!(ran.out.starts_with(note), "{}", ran.out);
    let ran = by_hand([", format ", ", format 1"]).kane(&["diff", "old.rs", "new.rs"]);
    assert!(
        ran.out.starts_with(
            "bodies and joints are the same: written by different versions of kane, formats "
        ),
        "{}",
        ran.out
    );
    let first = ran.out.lines().next().unwrap();
    assert!(!first.contains("functions"), "{first}");
}

#[test]
fn other_versions_of_kane_do_not_hide_that_functions_differ() {
    let project = by_hand([", format ", ", format 1"]);
    for file in ["old.rs", "new.rs"] {
        let functions = if file == "old.rs" {
            "bias"
        } else {
            "mass_matrix"
        };
        let robot = repository("models/arm.urdf");
        let generate = [
            "generate",
            robot.to_str().unwrap(),
            "--functions",
            functions,
        ];
        let ran = project.kane(&[&generate[..], &["--output", file]].concat());
        assert_eq!(ran.code, 0, "{ran:?}");
    }
    project.replace("new.rs", ", format ", ", format 1");
    let ran = project.kane(&["diff", "old.rs", "new.rs"]);
    let first = ran.out.lines().next().unwrap();
    assert!(first.ends_with(", and functions differ"), "{first}");
}

#[test]
fn other_layout_of_a_module_is_known_as_such() {
    let spaces = by_hand(["pub const NB: usize", "pub  const  NB :usize"]);
    let line_ends = by_hand(["\n", "\r\n"]);
    let both = by_hand(["pub const NB: usize", "pub  const  NB :usize"]);
    both.replace("new.rs", "\n", "\r\n");
    for project in [spaces, line_ends, both] {
        let ran = project.kane(&["diff", "old.rs", "new.rs"]);
        let note = "only the layout differs: formatted by another tool\ngenerated text ";
        assert!(ran.out.starts_with(note), "{}", ran.out);
        assert!(
            ran.out.ends_with("; only the layout changed\n"),
            "{}",
            ran.out
        );
    }
}

#[test]
fn places_of_a_range_are_no_numbers_of_the_model() {
    let weight = "R::from_f64(9.81)";
    let project = by_hand([weight, "R::from_f64([9.81; 4][0..3][0])"]);
    project.replace("old.rs", weight, "R::from_f64([9.81; 4][0..2][0])");
    let ran = project.kane(&["diff", "old.rs", "new.rs"]);
    assert_eq!(
        (ran.code, ran.out.contains("only ")),
        (1, false),
        "{}",
        ran.out
    );
}

#[test]
fn all_functions_are_told_where_everything_is() {
    let heavier = ["<mass value=\"0.5\"/>", "<mass value=\"0.75\"/>"];
    let ran = edited(heavier, &[]);
    assert!(ran.out.contains(" and 4 more\n"), "{}", ran.out);
    let ran = edited(heavier, &["--verbose"]);
    assert!(!ran.out.contains(" more\n"), "{}", ran.out);
    let last = "potential_energy\n";
    assert!(ran.out.ends_with(last), "{}", ran.out);
}

#[test]
fn wrapped_lines_hide_neither_numbers_nor_names_alone() {
    // The longer number or name does not fit on the line.
    let longer = ["<mass value=\"1.0\"/>", "<mass value=\"1.23456789\"/>"];
    let ran = edited(longer, &[]);
    assert!(ran.out.ends_with("; only numbers changed\n"), "{}", ran.out);
    let lines = |ran: &Ran| -> Vec<usize> {
        let line = ran.out.lines().last().unwrap();
        let numbers = line.split([' ', ',']).filter_map(|word| word.parse().ok());
        numbers.take(2).collect()
    };
    let counts = lines(&ran);
    assert_ne!(counts[0], counts[1], "nothing is wrapped: {}", ran.out);

    let renamed = ["\"forearm\"", "\"a_forearm_with_a_long_name\""];
    let ran = edited(renamed, &[]);
    assert!(ran.out.ends_with("; only names changed\n"), "{}", ran.out);
    let counts = lines(&ran);
    assert_ne!(counts[0], counts[1], "nothing is wrapped: {}", ran.out);
}

#[test]
fn names_and_numbers_together_are_neither_alone() {
    let old = model("arm", "2.0");
    let new = old
        .replace("\"fore\"", "\"shank\"")
        .replace("mass = 1.5", "mass = 1.75");
    let project = Project::empty();
    project.write("old.toml", &old);
    project.write("new.toml", &new);
    let ran = project.kane(&["diff", "old.toml", "new.toml", "--functions", "bias"]);
    assert!(!ran.out.contains("only "), "{}", ran.out);
}

#[test]
fn warnings_are_told_of_systems_whose_modules_are_the_same() {
    let project = Project::empty();
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    project.write("arm.urdf", &text);
    project.write("kane.toml", &system("arm.urdf", "arm.rs"));
    let project = project.committed();
    project.replace(
        "arm.urdf",
        "damping=\"0.05\"",
        "damping=\"0.05\" spring=\"1\"",
    );
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert!(
        ran.err.contains("unknown attribute `spring`"),
        "{}",
        ran.err
    );
}

#[test]
fn warnings_about_a_model_are_told_once_for_all_of_its_systems() {
    let project = Project::empty();
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    project.write("arm.urdf", &text);
    let systems = ["one.rs", "two.rs"].map(|module| system("arm.urdf", module));
    project.write("kane.toml", &systems.concat());
    let project = project.committed();
    let damping = "damping=\"0.05\"";
    project.replace("arm.urdf", damping, &format!("{damping} spring=\"1\""));
    let warning = "unknown attribute `spring`";
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!(ran.err.matches(warning).count(), 1, "{}", ran.err);
    // Programs and pull requests are told too, though no module differs.
    let ran = project.kane(&["diff", "HEAD", "--format", "json"]);
    let told: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(told["same"], true);
    let warnings = told["warnings"].as_array().unwrap();
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert_eq!(warnings[0]["model"], "arm.urdf");
    let message = warnings[0]["message"].as_str().unwrap();
    assert!(message.contains(warning), "{message}");
    let ran = project.kane(&["diff", "HEAD", "--format", "markdown"]);
    let row = "| warning | `arm.urdf` | `unknown attribute 'spring'";
    assert_eq!(ran.out.matches(row).count(), 1, "{}", ran.out);
}

#[test]
fn what_rewrites_a_long_function_is_told_where_alike_branches_differ() {
    let old = std::fs::read_to_string(repository("tests/robots/solo12/solo12.urdf")).unwrap();
    let [mass, heavier] = ["mass value=\"0.14853845\"", "mass value=\"0.14853846\""];
    let project = Project::empty();
    project.write("old.urdf", &old);
    let told = |new: &str, options: &[&str]| {
        project.write("new.urdf", new);
        let function = "d(forward_dynamics)/d(q, u, tau)";
        let all = [
            "diff",
            "old.urdf",
            "new.urdf",
            "--base",
            "free",
            "--functions",
            function,
        ];
        project.kane(&[&all, options].concat()).out
    };
    // The shoulder of the first leg alone.
    let ran = told(&old.replacen(mass, heavier, 1), &[]);
    let (_, reasons) = ran.split_once("long functions").unwrap_or_default();
    let (reasons, _) = reasons.split_once("\ngenerated text").unwrap_or_default();
    insta::assert_snapshot!(reasons.lines().last().unwrap().trim(), @"changed  d_forward_dynamics_d_q_u_tau  inputs in which branches or columns differ: 21 -> 23 in lockstep_1, 112 -> 115 in lockstep_3; values are declared in groups, because rustc's stack limits single declarations");
    // Those of all legs: these stay alike.
    let ran = told(&old.replace(mass, heavier), &["--format", "json"]);
    let said: Value = serde_json::from_str(&ran).unwrap();
    assert_eq!(
        (&said["same"], &said["forms"]),
        (&false.into(), &Value::Array(Vec::new()))
    );
}

#[test]
fn helpers_and_stages_that_came_or_went_are_told() {
    let module = |parts: &[&str], body: &str| {
        let helper =
            |name: &&str| format!("fn {name}<R>(sides: &[[R; 4]; 2]) -> [[R; 4]; 1] {{}}\n");
        let parts: String = parts.iter().map(helper).collect();
        format!("{parts}pub fn bias<R>() {{ {body} }}\npub fn bias_of<R>() {{}}")
    };
    let reasons = |old: &str, new: &str| {
        let [old, new] = [old, new].map(|text| ReadModule::read(text).unwrap());
        let forms = old.forms(&new);
        let told = forms.into_iter();
        told.map(|own| format!("{}: {}", own.name, own.reasons.join("; ")))
            .collect::<Vec<_>>()
    };
    let plain = module(&["bias_lockstep_1"], "");
    let other = module(
        &["bias_lockstep_1", "bias_lockstep_2", "bias_stage_1"],
        "let (a, b);",
    );
    let said = "bias: helpers: 1 -> 2; stages: 0 -> 1; values are declared in groups, because rustc's stack limits single declarations";
    assert_eq!(reasons(&plain, &other), [said]);
    let said = "bias: helpers: 2 -> 1; stages: 1 -> 0; values are declared one by one, because rustc's stack allows it again";
    assert_eq!(reasons(&other, &plain), [said]);
    let fewer = plain.replace("[[R; 4]; 2]", "[[R; 3]; 2]");
    let said = "bias: branches or columns side by side: 4 -> 3 in lockstep_1";
    assert_eq!(reasons(&plain, &fewer), [said]);
    // Numbers of a body are no form.
    let edited = plain.replace("{  }", "{ let a = 1.0; }");
    assert_ne!(edited, plain);
    assert_eq!(reasons(&plain, &edited), [""; 0]);
}
