//! `kane diff`.

use serde_json::Value;

use super::project::{Project, Ran, model, repository};

/// Two arms, the second one edited: what is told of them.
fn edited(edit: impl Fn(&str) -> String) -> (i32, String) {
    let ran = told(edit, &["--functions", "mass_matrix,bias", "--lines"]);
    assert_eq!(ran.code != 0, !ran.out.is_empty(), "{ran:?}");
    // What is said of the model, without the diff of the text.
    let (said, diff) = ran
        .out
        .split_once("--- old.toml\told\n")
        .unwrap_or_default();
    assert_eq!(diff.starts_with("+++ new.toml\tnew\n@@ -"), ran.code != 0);
    (ran.code, said.to_owned())
}

fn told(edit: impl Fn(&str) -> String, options: &[&str]) -> Ran {
    let project = Project::empty();
    let old = model("arm", "2.0");
    let new = edit(&old);
    project.write("old.toml", &old);
    project.write("new.toml", &new);
    project.kane(&[&["diff", "old.toml", "new.toml"], options].concat())
}

/// One more body on the upper one.
fn with_hand(text: &str) -> String {
    let (_, fore) = text.split_once("[[body]]\nname = \"fore\"").unwrap();
    let text = text.replace("[0, 1]", "[0, 1, 1]");
    format!("{text}\n[[body]]\nname = \"hand\"{fore}")
}

#[test]
fn model_that_says_the_same_otherwise_does_not_differ() {
    let ran = told(
        |text| text.replace("mass = 1.5", "mass = 1.50 # weighed"),
        &[],
    );
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(ran.err, "nothing differs between old.toml and new.toml\n");
}

#[test]
fn changed_mass_is_a_value_and_breaks_nothing() {
    let (code, said) = edited(|text| text.replace("mass = 1.5", "mass = 1.7"));
    assert_eq!(code, 1);
    insta::assert_snapshot!(said, @"
    values
      changed  fore: mass  1.5 -> 1.7
    ");
}

#[test]
fn frames_are_told_by_their_names() {
    let frame = "\n[[frame]]\nname = \"tip\"\nbody = \"fore\"\nposition = [0.0, 0.0, 0.8]\n";
    let ran = told(|text| text.to_owned() + frame, &["--functions", "bias"]);
    assert_eq!(ran.code, 1);
    assert_eq!(
        ran.out,
        "values\n  added    frame tip: body      fore\n  added    frame tip: position  [0.0, 0.0, 0.8]\ngenerated text is the same\n"
    );
}

#[test]
fn a_frame_at_the_origin_is_told_too() {
    let ran = told(
        |text| text.to_owned() + "\n[[frame]]\nname = \"tip\"\n",
        &["--functions", "bias"],
    );
    assert_eq!(ran.code, 1);
    assert_eq!(
        ran.out,
        "values\n  added    frame tip: body  the inertial frame\ngenerated text is the same\n"
    );
}

#[test]
fn number_that_becomes_a_parameter_is_told_with_the_operations_that_it_costs() {
    let (_, said) = edited(|text| text.replace("mass = 1.5", "mass = { runtime = 1.5 }"));
    assert!(
        said.contains("values\n  changed  fore: mass  1.5 -> 1.5 at run time\n"),
        "{said}"
    );
    assert!(
        said.contains("operations\n  changed  Prepared::new  0 -> "),
        "{said}"
    );
}

#[test]
fn added_body_breaks_every_layout_that_it_is_in() {
    let (code, said) = edited(with_hand);
    assert_eq!(code, 1);
    let said = said.split("operations").next().unwrap();
    insta::assert_snapshot!(said, @r#"
    BREAKING: the places in arrays over bodies changed
      added    hand  2
    BREAKING: the places in q changed
      added    hand_theta2  3
    BREAKING: the places in u changed
      added    hand_theta2_dot  3
    bodies and joints
      added    hand  on upper, joint ["theta2"], mass 1.5, at [0.0, 0.0, -1.0]
    "#);
}

#[test]
fn renamed_joint_moves_nothing() {
    let (code, said) = edited(|text| {
        let joint = "joint = [\"theta2\"]\n";
        assert!(text.contains(joint), "{text}");
        text.replacen(joint, &format!("joint_name = \"elbow\"\n{joint}"), 1)
    });
    assert_eq!(code, 1);
    insta::assert_snapshot!(said, @"
    BREAKING: the names in q and in C headers changed
      renamed  fore_theta2 -> elbow  2
    BREAKING: the names in u and in C headers changed
      renamed  fore_theta2_dot -> elbow_dot  2
    bodies and joints
      added    fore: joint_name  elbow
    ");
}

#[test]
fn renamed_body_keeps_its_places() {
    let (code, said) = edited(|text| {
        let text = text.replace("name = \"fore\"", "name = \"shank\"");
        text.replace("mass = 1.5", "mass = 1.25")
    });
    assert_eq!(code, 1);
    let (said, _) = said.split_once("operations").unwrap();
    insta::assert_snapshot!(said, @"
    BREAKING: the names in arrays over bodies and in C headers changed
      renamed  fore -> shank  1
    BREAKING: the names in q and in C headers changed
      renamed  fore_theta2 -> shank_theta2  2
    BREAKING: the names in u and in C headers changed
      renamed  fore_theta2_dot -> shank_theta2_dot  2
    values
      changed  fore -> shank: mass  1.5 -> 1.25
    ");
}

#[test]
fn another_parameter_at_a_place_breaks_what_fills_them_in_order() {
    let project = Project::empty();
    let model = model("arm", "2.0");
    let at_run_time = |number: &str| {
        assert!(model.contains(number), "{model}");
        model.replace(
            number,
            &number.replacen("1.5", "{ runtime = 1.5 }", 1).replacen(
                "-0.4",
                "{ runtime = -0.4 }",
                1,
            ),
        )
    };
    project.write("old.toml", &at_run_time("mass = 1.5"));
    project.write("new.toml", &at_run_time("0.02, -0.4]"));
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    assert_eq!(ran.code, 1);
    let told = "BREAKING: the places in Parameters changed\n";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn removed_body_is_told_with_the_place_that_it_had() {
    let project = Project::empty();
    let new = model("arm", "2.0");
    project.write("old.toml", &with_hand(&new));
    project.write("new.toml", &new);
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    assert_eq!(ran.code, 1);
    for part in [
        "q changed\n  removed  hand_theta2  3\n",
        "bodies and joints\n  removed  hand  on upper, joint [\"theta2\"], mass 1.5, at [0.0, 0.0, -1.0]\n",
    ] {
        assert!(ran.out.contains(part), "{part}\n{}", ran.out);
    }
}

#[test]
fn renumbered_bodies_move_what_is_indexed_by_them() {
    let project = Project::empty();
    let old = with_hand(&model("arm", "2.0"));
    let swapped = old.replace("\"hand\"", "\"?\"");
    let swapped = swapped
        .replace("\"fore\"", "\"hand\"")
        .replace("\"?\"", "\"fore\"");
    project.write("old.toml", &old);
    project.write("new.toml", &swapped);
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    assert_eq!(ran.code, 1);
    let said = ran.out.split("generated text (").next().unwrap();
    insta::assert_snapshot!(said, @"
    BREAKING: the places in arrays over bodies changed
      moved    hand  2 -> 1
      moved    fore  1 -> 2
    BREAKING: the places in q changed
      moved    hand_theta2  3 -> 2
      moved    fore_theta2  2 -> 3
    BREAKING: the places in u changed
      moved    hand_theta2_dot  3 -> 2
      moved    fore_theta2_dot  2 -> 3
    ");
}

#[test]
fn another_joint_is_told_with_the_coordinate_that_went_and_the_one_that_came() {
    let (_, said) = edited(|text| text.replace("[\"theta2\"]", "[\"s3\"]"));
    let said = said.split("operations").next().unwrap();
    insta::assert_snapshot!(said, @r#"
    BREAKING: the places in q changed
      added    fore_s3      2
      removed  fore_theta2  2
    BREAKING: the places in u changed
      added    fore_s3_dot      2
      removed  fore_theta2_dot  2
    bodies and joints
      changed  fore: joint  ["theta2"] -> ["s3"]
    "#);
}

#[test]
fn another_order_of_the_coordinates_is_breaking_though_no_operation_changes() {
    let (_, said) = edited(|text| format!("order = \"notes\"\n{text}"));
    insta::assert_snapshot!(said, @"
    BREAKING: the places in q changed
      moved    fore_theta2  2 -> 1
      moved    upper_s2     1 -> 2
    BREAKING: the places in u changed
      moved    fore_theta2_dot  2 -> 1
      moved    upper_s2_dot     1 -> 2
    values
      added    order  notes
    ");
}

#[test]
fn other_arguments_of_a_function_are_breaking() {
    let project = Project::arm();
    let generated = |file: &str, functions: &str| {
        let arguments = [
            "generate",
            "models/arm.toml",
            "--functions",
            functions,
            "--output",
            file,
        ];
        assert_eq!(project.kane(&arguments).code, 0, "{functions}");
    };
    generated("old.rs", "step = bias+mass_matrix");
    generated("new.rs", "step = mass_matrix+bias");
    let ran = project.kane(&["diff", "old.rs", "new.rs"]);
    let told = "BREAKING: functions that are gone, or have other arguments\n  changed  step  p, q, u, bias, m -> p, q, u, m, bias\n";
    assert!(ran.out.contains(told), "{}", ran.out);
    generated("gone.rs", "mass_matrix");
    let ran = project.kane(&["diff", "old.rs", "gone.rs"]);
    let told = "BREAKING: functions that are gone, or have other arguments\n  removed  step\n";
    assert!(ran.out.contains(told), "{}", ran.out);
    let ran = project.kane(&["diff", "old.rs", "new.rs", "--format", "json"]);
    assert!(ran.out.contains("\"breaking\": true"), "{}", ran.out);
}

#[test]
fn places_that_mean_something_else_are_breaking() {
    let project = Project::arm();
    let joint = |joint: &str| {
        let model = model("arm", "2.0").replace("[\"theta2\"]", joint);
        model.replace("name = \"fore\"", "name = \"fore\"\njoint_name = \"elbow\"")
    };
    project.write("old.toml", &joint("\"revolute\"\naxis = [0, 1, 0]"));
    project.write("new.toml", &joint("\"prismatic\"\naxis = [0, 1, 0]"));
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    let told = "BREAKING: places that mean something else\n  changed  q of elbow  rad -> m\n";
    assert!(ran.out.starts_with(told), "{}", ran.out);

    let generated = |file: &str, prescribed: &str| {
        let arguments = [
            "generate",
            "old.toml",
            "--functions",
            "hybrid_dynamics",
            "--prescribed",
            prescribed,
            "--output",
            file,
        ];
        assert_eq!(project.kane(&arguments).code, 0, "{prescribed}");
    };
    generated("old.rs", "elbow");
    generated("new.rs", "upper");
    let ran = project.kane(&["diff", "old.rs", "new.rs"]);
    let told = "\nBREAKING: places that mean something else\n  changed  prescribed speeds  elbow_dot -> upper_theta1_dot, upper_s2_dot\n\
                options\n  changed  prescribed  \"elbow\" -> \"upper\"\n";
    assert!(ran.out.contains(told), "{}", ran.out);
    project.write(
        "renamed.rs",
        &project.read("old.rs").replace("elbow", "knee"),
    );
    let renamed = project.kane(&["diff", "old.rs", "renamed.rs"]);
    assert!(renamed.out.contains("knee_dot"), "{}", renamed.out);
    assert!(!renamed.out.contains("places that mean"), "{}", renamed.out);
    let ran = project.kane(&["diff", "old.rs", "new.rs", "--format", "json"]);
    let told: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(told["breaking"], true);
    assert_eq!(told["meanings"][0]["new"], "upper_theta1_dot, upper_s2_dot");
}

#[test]
fn body_on_another_one_is_told() {
    let text = with_hand(&model("arm", "2.0"));
    let project = Project::empty();
    project.write("old.toml", &text);
    project.write("new.toml", &text.replace("[0, 1, 1]", "[0, 1, 2]"));
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    assert!(
        ran.out
            .contains("bodies and joints\n  changed  hand: lower_body  upper -> fore\n"),
        "{}",
        ran.out
    );
    assert!(!ran.out.contains("BREAKING"));
}

#[test]
fn json_says_the_same_for_programs() {
    let ran = told(with_hand, &["--format", "json"]);
    assert_eq!(ran.code, 1);
    let value: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(
        (&value["breaking"], &value["same"]),
        (&Value::from(true), &Value::from(false))
    );
    let coordinates = &value["layouts"][1];
    assert_eq!(coordinates["array"], "q");
    assert_eq!(
        coordinates["added"],
        serde_json::json!([{ "name": "hand_theta2", "place": 3 }])
    );
    let hand = &value["bodies"]["added"][0];
    assert_eq!(
        (&hand["name"], &hand["values"]["mass"]),
        (&Value::from("hand"), &Value::from("1.5"))
    );
    let functions = value["functions"]["changed"].as_array().unwrap();
    assert!(functions.iter().all(|function| {
        let total = |side: &str| function[side]["total"].as_u64().unwrap();
        total("new") > total("old")
    }));
    assert!(!functions.is_empty());
    let ran = told(str::to_owned, &["--format", "json"]);
    let value: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((ran.code, &value["same"]), (0, &Value::from(true)));
}

#[test]
fn markdown_has_a_table_a_section_and_folds_the_diff() {
    let ran = told(
        |text| text.replace("\"fore\"", "\"fo|re\""),
        &["--format", "markdown", "--functions", "mass_matrix"],
    );
    assert_eq!(ran.code, 1);
    let (said, diff) = ran.out.split_once("<details>").unwrap();
    insta::assert_snapshot!(said);
    assert!(diff.starts_with("<summary>Generated text</summary>\n\n```diff\n--- old.toml\told\n"));
    assert!(diff.ends_with("\n```\n\n</details>\n"), "{diff}");
}

#[test]
fn long_diff_is_cut_in_markdown_alone() {
    let arguments = |format| ["--functions", "all", "--lines", "--format", format];
    let lines = |format| {
        let ran = told(with_hand, &arguments(format));
        ran.out.lines().count()
    };
    assert!(lines("text") > 1000);
    assert!(lines("markdown") < 600);
    let ran = told(with_hand, &arguments("markdown"));
    assert!(ran.out.contains(" more lines\n"));
}

#[test]
fn generated_text_is_summed_up_where_lines_are_not_asked_for() {
    let ran = told(
        |text| text.replace("mass = 1.5", "mass = 1.7"),
        &["--functions", "mass_matrix,bias"],
    );
    assert_eq!(ran.code, 1);
    insta::assert_snapshot!(ran.out);
}

#[test]
fn modules_are_compared_by_what_they_hold() {
    let project = Project::generated();
    let old = project.read("generated/arm.rs");
    project.write("old.rs", &old);
    let same = project.kane(&["diff", "old.rs", "generated/arm.rs"]);
    assert_eq!((same.code, same.out.as_str()), (0, ""));

    project.replace("models/arm.toml", "mass = 2.0", "mass = { runtime = 2.0 }");
    project.replace("models/arm.toml", "[\"theta2\"]", "[\"s3\"]");
    assert_eq!(project.kane(&["generate"]).code, 0);
    let ran = project.kane(&["diff", "old.rs", "generated/arm.rs", "--lines"]);
    assert_eq!(ran.code, 1);
    for part in [
        "BREAKING: the places in q changed\n  added    fore_s3      2\n  removed  fore_theta2  2\n",
        "bodies and joints\n  changed  fore: joint  theta2 -> s3\n",
        "values\n  added    parameter upper_mass  2.0 kg\n",
        "operations\n  changed  Prepared::new",
        "--- old.rs\told\n+++ generated/arm.rs\tnew\n@@ -",
    ] {
        assert!(ran.out.contains(part), "{part}\n{}", ran.out);
    }
}

#[test]
fn modules_of_one_model_are_known_as_such() {
    let project = Project::generated();
    let arguments = ["generate", "models/arm.toml", "--output", "fused.rs"];
    let ran = project.kane(
        &[
            &arguments[..],
            &["--functions", "mass_matrix,bias", "--fma"],
        ]
        .concat(),
    );
    assert_eq!(ran.code, 0, "{ran:?}");
    let ran = project.kane(&["diff", "generated/arm.rs", "fused.rs", "--lines"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.starts_with(
            "bodies and joints are the same: options differ\noptions\n  added    fma  true\n--- "
        ),
        "{}",
        ran.out
    );
}

#[test]
fn what_is_no_module_or_is_none_beside_a_model_is_refused() {
    let project = Project::generated();
    project.write("by_hand.rs", "pub fn bias() {}\n");
    project.write("broken.rs", "pub fn\n");
    let ran = project.kane(&["diff", "by_hand.rs", "broken.rs"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @"
    error: `by_hand.rs`: it is no generated module: it has no `BODY_NAMES`
    error: `broken.rs`: it is not Rust that can be read: unexpected end of input, expected identifier
    ");
    let ran = project.kane(&["diff", "models/arm.toml", "generated/arm.rs"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @"error: a model and a module cannot be compared; expected two models, or two modules, which end in `.rs`");
}

#[test]
fn faults_of_both_models_are_reported() {
    let project = Project::empty();
    project.write("old.toml", &model("arm", "-1.0"));
    project.write("new.toml", &model("arm", "true"));
    let ran = project.kane(&["diff", "old.toml", "new.toml"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    for part in ["old.toml:7:8", "new.toml:7:8"] {
        assert!(ran.err.contains(part), "{}", ran.err);
    }
    let ran = project.kane(&["diff", "gone.toml", "new.toml"]);
    assert_eq!((ran.code, ran.err.contains("`gone.toml`")), (2, true));
}

#[test]
fn formats_of_models_make_no_difference() {
    let project = Project::empty();
    let robot = repository("tests/robots/double_pendulum/double_pendulum.urdf");
    let robot = robot.to_str().unwrap();
    let convert = ["convert", robot, "--output", "robot.toml"];
    assert_eq!(project.kane(&convert).code, 0);
    let ran = project.kane(&["diff", robot, "robot.toml"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{}", ran.err);
    // What one of them says itself is not asked of it.
    let free = ["--base", "free"];
    let convert = [&["convert", robot, "--output", "free.toml"][..], &free].concat();
    assert_eq!(project.kane(&convert).code, 0);
    let ran = project.kane(&[&["diff", robot, "free.toml"][..], &free].concat());
    assert!(ran.err.is_empty(), "{}", ran.err);
    assert!(!ran.out.contains("values"), "{}", ran.out);
    let ran = project.kane(&[&["diff", "free.toml", "free.toml"][..], &free].concat());
    assert_eq!(ran.code, 2);
}
