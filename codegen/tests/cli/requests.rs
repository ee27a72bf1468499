//! Functions that a model cannot have as they are asked for.

use serde_json::{Value, json};

use super::project::{Project, model, system};

/// The arm, with these functions in `kane.toml`.
fn with_functions(functions: &str) -> Project {
    let project = Project::arm();
    let config = system("models/arm.toml", "generated/arm.rs");
    let config = config.lines().filter(|line| !line.starts_with("functions"));
    let config: Vec<&str> = config.collect();
    let config = config.join("\n");
    project.write("kane.toml", &format!("{config}\nfunctions = {functions}\n"));
    project
}

#[test]
fn unknown_frame_is_pointed_at_in_kane_toml() {
    let project = with_functions(r#"["bias", "mass_matrix + velocity(foer, local)"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @r#"
    error: `functions` of system 1: `foer` is no frame of the model; there are `fore`, `upper`
     --> kane.toml:4:46
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    3 | output = "generated/arm.rs"
    4 | functions = ["bias", "mass_matrix + velocity(foer, local)"]
      |                                              ^^^^ unknown frame
    "#);
    // The same of one model, and of what is up to date.
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).err, ran.err);
    assert_eq!(project.kane(&["check"]).err, ran.err);
}

#[test]
fn derivatives_by_values_that_are_not_there_are_told() {
    let project = with_functions(r#"["d(bias)/d(q, parameters)", "d(bias)/d(u)"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0);
    insta::assert_snapshot!(ran.err.lines().next().unwrap(), @"warning: models/arm.toml: `d(bias)/d(q, parameters)` has no column for `parameters`: the model sets no value at run time; write `{ runtime = 1.2 }` for a number of a model in TOML; `kane convert` makes one of any model");
}

#[test]
fn prescribed_speeds_that_no_function_asks_for_are_told() {
    let told = |functions: &str| {
        let project = with_functions(&format!("{functions}\nprescribed = [\"fore\"]"));
        let ran = project.kane(&["generate"]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        ran.err.contains("`prescribed` changes nothing")
    };
    assert!(told(r#"["bias"]"#));
    assert!(!told(r#"["bias+hybrid_dynamics"]"#));
    assert!(!told(r#"["d(hybrid_dynamics)/d(q)"]"#));
}

#[test]
fn all_unknown_frames_are_told_at_once() {
    let project = with_functions(r#"["pose(foer) + velocity(hand)", "imu(tool)"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    let told_once = |told: &str| {
        for name in ["foer", "hand", "tool"] {
            let fault = format!("`{name}` is no frame of the model");
            assert_eq!(told.matches(&fault).count(), 1, "{told}");
        }
    };
    told_once(&ran.err);
    // Beside a fault of the file too.
    project.write("kane.toml", &(project.read("kane.toml") + "fna = true\n"));
    let ran = project.kane(&["generate"]);
    assert!(ran.err.contains("unknown key `fna`"), "{}", ran.err);
    told_once(&ran.err);
    let project = with_functions(r#"["bias"]"#);
    let arguments = [
        "info",
        "models/arm.toml",
        "--functions",
        "jacobian(foer, hand)",
    ];
    let ran = project.kane(&arguments);
    insta::assert_snapshot!(ran.err, @r"
    error: `foer` is no frame of the model; there are `fore`, `upper`
    error: `hand` is no frame of the model; there are `upper`, `fore`
    ");
    let arguments = [
        "info",
        "models/arm.toml",
        "--functions",
        "jacobian(fore, LOCAL)",
    ];
    insta::assert_snapshot!(
        project.kane(&arguments).err,
        @"error: `LOCAL` is no frame of the model; for the frame's own axes write `local` after the frame: `(FRAME, local)`"
    );
}

#[test]
fn frame_that_is_written_in_two_ways_is_one() {
    let both = |functions: &str| {
        let project = with_functions(functions);
        let arm = project.read("models/arm.toml");
        project.write(
            "models/arm.toml",
            &arm.replace("\"fore\"", "\"Fore-{axes}\""),
        );
        (project.kane(&["generate"]), project)
    };
    let (ran, project) = both(r#"["pose(Fore-{axes})", "pose(fore_axes)"]"#);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let module = project.read("generated/arm.rs");
    assert_eq!(module.matches("pub fn fore_axes_pose<").count(), 1);
    assert!(module.contains("/// Pose of the frame `Fore-{axes}`: the matrix"));
    let (ran, _) = both(r#"["pose(Fore-{axes})+pose(fore_axes)"]"#);
    let first = ran.err.lines().next().unwrap();
    insta::assert_snapshot!(first, @"error: `functions` of system 1: `pose(Fore-{axes})+pose(fore_axes)` names `pose(Fore-{axes})` twice");
    assert!(ran.err.contains("--> kane.toml:4:14"));
    let (ran, _) = both(r#"["point_jacobian(Fore-{axes})+point_jacobian(fore_axes, local)"]"#);
    assert!(
        ran.err.contains("of their own; ask for them apart"),
        "{}",
        ran.err
    );
    let (ran, _) = both(r#"["vjp(pose(Fore-{axes}); q)+pose(fore_axes)"]"#);
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn parts_are_packed_before_they_are_joined() {
    let project = with_functions(r#"["packed(bias+d(bias)/d(q))"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    let help = "a part is packed by itself, and joined outside: `forward_dynamics+packed(d(forward_dynamics)/d(q, u))`";
    assert!(ran.err.contains(help), "{}", ran.err);
}

#[test]
fn functions_of_frames_stand_beside_all() {
    let project = with_functions(r#"["all", "pose(fore)", "bias+mass_matrix"]"#);
    assert_eq!(project.kane(&["generate"]).code, 0);
    let module = project.read("generated/arm.rs");
    assert!(module.contains("functions: all, bias+mass_matrix, pose(fore);"));
    let of_options = project.kane(&[
        "generate",
        "models/arm.toml",
        "--functions",
        "pose(fore),bias+mass_matrix",
        "--functions",
        "all",
        "--output",
        "other.rs",
    ]);
    assert_eq!(of_options.code, 0, "{}", of_options.err);
    for function in ["fn fore_pose<", "fn bias_and_mass_matrix<", "fn regressor<"] {
        assert!(module.contains(function), "{function}");
        assert!(project.read("other.rs").contains(function), "{function}");
    }
}

#[test]
fn unknown_frame_of_the_command_line_has_no_place_in_kane_toml() {
    let project = with_functions(r#"["pose(foer)"]"#);
    let ran = project.kane(&["generate", "models/arm.toml", "--functions", "pose(foer)"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err, @"error: `foer` is no frame of the model; there are `fore`, `upper`");
}

#[test]
fn joint_that_is_asked_for_as_a_frame_is_told_its_body() {
    let project = with_functions(r#"["pose(elbow)", "pose(flange)"]"#);
    let arm = model("arm", "2.0").replace("[0, 1]", "[0, 1, 2]");
    let tool = r#"joint_name = "elbow"

[[body]]
name = "tool"
mass = 0.5
mass_center = [0.0, 0.0, 0.0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.0, -1.0]
joint_name = "flange"
joint = []
"#;
    project.write("models/arm.toml", &(arm + tool));
    let ran = project.kane(&["generate"]);
    insta::assert_snapshot!(ran.err);
}

#[test]
fn functions_of_one_name_are_pointed_at_in_kane_toml() {
    let project = with_functions(r#"["pose(upper)+pose(fore)", "pose(upper_pose_and_fore)"]"#);
    let frame = "[[frame]]\nname = \"upper_pose_and_fore\"\nbody = \"fore\"\n";
    project.write("models/arm.toml", &(model("arm", "2.0") + frame));
    let ran = project.kane(&["generate"]);
    insta::assert_snapshot!(ran.err, @r#"
    error: `functions` of system 1: `pose(upper)+pose(fore)` and `pose(upper_pose_and_fore)` would both be called `upper_pose_and_fore_pose` in generated code
     --> kane.toml:4:40
      |
    2 | model = "models/arm.toml"
      |         ----------------- the model
    3 | output = "generated/arm.rs"
    4 | functions = ["pose(upper)+pose(fore)", "pose(upper_pose_and_fore)"]
      |              ------------------------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^ the second one
      |              |
      |              the first one
    "#);
}

#[test]
fn frame_with_a_quote_in_its_name_is_asked_for_with_two() {
    let project = with_functions(r#"['pose("2"" pipe")']"#);
    let frame = "[[frame]]\nname = '2\" pipe'\nbody = \"fore\"\n";
    project.write("models/arm.toml", &(model("arm", "2.0") + frame));
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let module = project.read("generated/arm.rs");
    assert!(
        module.contains(r#"functions: pose("2"" pipe")"#),
        "{module}"
    );
}

#[test]
fn function_of_the_default_set_may_be_named_beside_it() {
    let project = with_functions(r#"["default", "rotation", "kinetic_energy"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let module = project.read("generated/arm.rs");
    assert_eq!(module.matches("pub fn rotation<").count(), 1);
    assert_eq!(module.matches("pub fn kinetic_energy<").count(), 1);
}

#[test]
fn what_outputs_are_read_by_stands_in_the_manifest_and_what_eval_prints() {
    let project = with_functions(
        r#"["jacobian_packed(stand)", "jacobian_packed(fore)", "mass_matrix_packed", "base_regressor"]"#,
    );
    let config = project.read("kane.toml");
    project.write("kane.toml", &(config + "manifest = true\nabi = \"c\"\n"));
    let frame = "[[frame]]\nname = \"stand\"\n";
    project.write("models/arm.toml", &(model("arm", "2.0") + frame));
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let manifest: Value = serde_json::from_str(&project.read("generated/arm.json")).unwrap();
    let constants = &manifest["constants"];
    assert_eq!(constants["STAND_SPEEDS"], json!([]));
    assert_eq!(constants["FORE_SPEEDS"], json!([0, 1, 2]));
    let n_base = constants["BASE_PARAMETERS"].as_array().unwrap().len();
    let functions = manifest["functions"].as_array().unwrap();
    let shape = |name: &str| {
        let function = functions.iter().find(|function| function["name"] == name);
        function.unwrap()["outputs"][0]["shape"].clone()
    };
    assert_eq!(shape("stand_jacobian_packed"), json!([3, 0]));
    assert_eq!(shape("base_regressor"), json!([3, n_base]));
    let places = constants["MASS_MATRIX_PACKED_PLACES"].as_array().unwrap();
    assert_eq!(shape("mass_matrix_packed"), json!([places.len()]));
    let header = project.read("generated/arm.h");
    assert!(header.contains("there is none of this length.\n#define ARM_STAND_SPEEDS_LEN 0\n"));

    let evaluated = |function: &str| -> Value {
        let arguments = ["eval", "models/arm.toml", "-f", function, "-s", "-"];
        let ran = project.kane_given(&arguments, r#"{"q": [0.1, 0.2, 0.3]}"#);
        assert_eq!(ran.code, 0, "{}", ran.err);
        serde_json::from_str(&ran.out).unwrap()
    };
    let rows = json!([[], [], []]);
    let expected = json!({ "linear": rows, "angular": rows, "speeds": [] });
    assert_eq!(evaluated("jacobian_packed(stand)"), expected);
    let both = evaluated("jacobian_packed(stand) + jacobian_packed(fore)");
    assert_eq!(both["fore_jacobian_packed_speeds"], json!([0, 1, 2]));
}

#[test]
fn all_unknown_functions_are_reported_with_what_was_meant() {
    let arguments = [
        "generate",
        "models/arm.toml",
        "--functions",
        "mass_matrx,bias,bias,nonsense_entirely",
    ];
    let ran = Project::arm().kane(&arguments);
    assert_eq!(ran.code, 2);
    let lines: Vec<&str> = ran.err.lines().collect();
    assert_eq!(
        lines[0],
        "error: `mass_matrx` is no function; did you mean `mass_matrix`?"
    );
    assert_eq!(lines[1], "error: --functions names `bias` twice");
    assert!(lines[2].starts_with(
        "error: `nonsense_entirely` is no function; `kane info MODEL --functions all` lists those of a system; "
    ));
}

#[test]
fn frames_that_the_model_lacks_are_told_beside_unknown_functions() {
    let arguments = [
        "generate",
        "models/arm.toml",
        "--functions",
        "jacobian(flange),foo+pose",
    ];
    let ran = Project::arm().kane(&arguments);
    assert_eq!(ran.code, 2);
    for part in [
        "`foo` is no function; ",
        "`pose` is of a frame; ",
        "`flange` is no frame of the model; ",
    ] {
        assert!(ran.err.contains(part), "{}", ran.err);
    }
}

#[test]
fn functions_of_frames_are_among_those_that_may_be_meant() {
    let project = Project::arm();
    let arguments = ["generate", "models/arm.toml", "--functions"];
    let ran = |functions: &str| project.kane(&[&arguments[..], &[functions]].concat());
    let misspelt = ran("jacobain(fore)");
    assert_eq!(misspelt.code, 2);
    assert_eq!(
        misspelt.err,
        "error: `jacobain` is no function; did you mean `jacobian`?\n"
    );
    let none = ran("nonsense_entirely").err;
    assert!(none.contains(", operational_inverse_inertia"), "{none}");
    let config = system("models/arm.toml", "generated/arm.rs");
    project.write(
        "kane.toml",
        &config.replace("mass_matrix", "jacobain(fore)"),
    );
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("did you mean `jacobian`?"), "{}", ran.err);
}

#[test]
fn what_is_asked_for_and_what_is_changed_are_told_together() {
    let project = Project::arm();
    let arguments = [
        "generate",
        "models/arm.toml",
        "--functions",
        "pose(hand), bais",
        "--lock",
        "elbow=1",
        "--prescribed",
        "wrist",
    ];
    let told = |arguments: &[&str], expected: &[&str]| {
        let ran = project.kane(arguments);
        assert_eq!(ran.code, 2);
        for fault in expected {
            assert!(ran.err.contains(fault), "{fault}: {}", ran.err);
        }
    };
    let lacking = [
        "`hand` is no frame of the model",
        "`lock` names `elbow`",
        "`wrist` is no joint of the model",
    ];
    told(
        &arguments,
        &[&lacking[..], &["`bais` is no function"]].concat(),
    );
    let mut known = arguments;
    known[3] = "pose(hand)";
    told(&known, &lacking);
}

#[test]
fn what_kane_toml_asks_for_and_the_model_lacks_is_told_there() {
    let project = Project::arm();
    project.write(
        "kane.toml",
        "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"arm.rs\"\nfunctions = [\"bias\", \"own = pose(hand)\"]\n",
    );
    for arguments in [
        &["info", "models/arm.toml"][..],
        &["eval", "models/arm.toml", "--function", "own"],
    ] {
        let ran = project.kane(arguments);
        assert_eq!(ran.code, 2);
        for part in ["`hand` is no frame of the model", "--> kane.toml:4:"] {
            assert!(ran.err.contains(part), "{}", ran.err);
        }
    }
    let ran = project.kane(&["info", "models/arm.toml", "--functions", "pose(hand)"]);
    assert!(!ran.err.contains("kane.toml"), "{}", ran.err);
    project.write("other.toml", &project.read("models/arm.toml"));
    let ran = project.kane(&["diff", "other.toml", "models/arm.toml"]);
    let fault = "`other.toml`: `hand` is no frame of the model";
    assert!(ran.err.contains(fault), "{}", ran.err);
    assert!(
        ran.err.contains("the options are those of `kane.toml`"),
        "{}",
        ran.err
    );
    let models = ["diff", "other.toml", "models/arm.toml"];
    let ran = project.kane(&[&models[..], &["--prescribed", "knee"]].concat());
    let origin = "the options are those of the command line, and of `kane.toml`";
    assert!(ran.err.contains(origin), "{}", ran.err);
}

#[test]
fn a_name_near_one_of_the_kane_toml_is_met_with_that() {
    let project = Project::arm();
    project.replace("kane.toml", "\"bias\"", "\"both = mass_matrix+bias\"");
    for arguments in [
        ["eval", "models/arm.toml", "--function", "bothh"],
        ["info", "models/arm.toml", "--functions", "bothh"],
    ] {
        let ran = project.kane(&arguments);
        assert_eq!(ran.code, 2);
        assert_eq!(
            ran.err,
            "error: `bothh` is no function; did you mean `both` of kane.toml?\n"
        );
    }
}

#[test]
fn frame_that_went_is_told_once_whatever_is_of_it() {
    let project = with_functions(r#"["pose(tip)", "jacobian(tip)", "velocity(tip)"]"#);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert_eq!(ran.err.matches("error:").count(), 1, "{}", ran.err);
    assert!(
        ran.err.contains("help: 2 more functions ask for it"),
        "{}",
        ran.err
    );
}

#[test]
fn a_frame_that_stands_twice_is_refused() {
    for request in [
        "operational_inverse_inertia(fore, fore)",
        "linear_operational_inverse_inertia(upper, fore, upper)",
    ] {
        let ran = with_functions(&format!("[\"{request}\"]")).kane(&["generate"]);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains("twice"), "{}", ran.err);
    }
    let ran = with_functions("[\"mass_matrix()\"]").kane(&["generate"]);
    assert!(
        ran.err
            .contains("`mass_matrix` is of the whole system; expected nothing in brackets"),
        "{}",
        ran.err
    );
}
