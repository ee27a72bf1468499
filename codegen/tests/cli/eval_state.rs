//! The state that `kane eval` is given.

use serde_json::json;

use super::{
    eval::arm,
    project::{Project, model, repository},
};

#[test]
fn all_faults_of_the_state_are_reported() {
    let state = r#"{
        "q": [0.0, "a", null],
        "uu": [1, 2, 3],
        "tau": 3,
        "loads": [{"force": [1, 2], "momentum": [0, 0, 0]}, 7],
        "w_rel": [[0, 0, 0]],
        "parameters": {"uper_mass": 1.0, "upper_mass": [2.0]}
    }"#;
    let ran = arm("forcing", state);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err);
}

#[test]
fn places_may_be_named() {
    let function = "bias+loaded_forward_dynamics";
    let listed = arm(
        function,
        r#"{"q": [0.0, 0.2, 0.3], "u": [1, 0, 2], "tau": [0, 0, 0],
            "loads": [{"force": [0, 0, 0], "moment": [0, 0, 0]}, {"force": [1, 2, 3], "moment": [0, 0, 1]}]}"#,
    );
    let named = arm(
        function,
        r#"{"q": {"fore_theta2": 0.3, "upper_s2": 0.2}, "u": {"upper_theta1": 1, "fore_theta2_dot": 2}, "tau": {},
            "loads": {"fore": {"force": [1, 2, 3], "moment": [0, 0, 1]}}}"#,
    );
    assert_eq!((listed.code, &listed.out), (0, &named.out));
    // A joint without a name is called as its body.
    let body = arm("potential_energy", r#"{"q": {"fore": 0.3}}"#);
    let own = arm("potential_energy", r#"{"q": {"fore_theta2": 0.3}}"#);
    assert_eq!((body.code, &body.out), (0, &own.out), "{}", body.err);
    let ran = arm(
        "bias",
        r#"{"q": {"fore_theta": 0.3}, "u": {"knee": [1], "upper_s2": 1, "upper_s2_dot": 2}}"#,
    );
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @r#"
    error: `q.fore_theta` names none of the coordinates
     --> state.json:1:8
      |
    1 | {"q": {"fore_theta": 0.3}, "u": {"knee": [1], "upper_s2": 1, "upper_s2_dot": 2}}
      |        ^^^^^^^^^^^^ here
      |
      = help: did you mean `fore_theta2`?

    error: `u.knee` names none of the speeds
     --> state.json:1:34
      |
    1 | {"q": {"fore_theta": 0.3}, "u": {"knee": [1], "upper_s2": 1, "upper_s2_dot": 2}}
      |                                  ^^^^^^ here
      |
      = help: the speeds are upper_theta1, upper_s2, fore_theta2

    error: `u.upper_s2_dot` is `upper_s2` by another name; expected one
     --> state.json:1:62
      |
    1 | {"q": {"fore_theta": 0.3}, "u": {"knee": [1], "upper_s2": 1, "upper_s2_dot": 2}}
      |                                                              ^^^^^^^^^^^^^^ here
    "#);
}

#[test]
fn joints_and_frames_have_the_names_of_the_model_and_of_generated_code() {
    let project = Project::empty();
    let model = repository("tests/robots/solo12/solo12.urdf");
    let evaluated = |function: &str, state: &str| {
        project.write("state.json", state);
        let model = model.to_str().unwrap();
        let asked = ["--function", function, "--state", "state.json"];
        let ran = project.kane(&[&["eval", model, "--base", "free"][..], &asked].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        ran.out
    };
    let generated = evaluated(
        "velocity(fl_foot)",
        r#"{"q": {"fl_haa": 0.1}, "u": {"fl_kfe": 0.2, "fl_hfe_dot": 0.3}}"#,
    );
    let own = evaluated(
        "velocity(FL_FOOT)",
        r#"{"q": {"FL_HAA": 0.1}, "u": {"FL_KFE": 0.2, "FL_HFE": 0.3}}"#,
    );
    assert_eq!(generated, own);
}

#[test]
fn what_the_function_does_not_need_may_be_absent() {
    assert_eq!(arm("rotation", r#"{"q": [0, 0, 0]}"#).code, 0);
    let ran = arm("inverse_dynamics", r#"{"q": [0, 0, 0]}"#);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @r#"
    error: `inverse_dynamics` needs `u`, which is missing; expected a list of 3 numbers, one a speed
    --> state.json
     = help: `"u": {}` means that all are zero

    error: `inverse_dynamics` needs `u_dot`, which is missing; expected a list of 3 numbers, one a speed
    --> state.json
     = help: `"u_dot": {}` means that all are zero
    "#);
}

#[test]
fn state_that_is_not_json_is_shown_with_its_line() {
    let ran = arm("rotation", "{\"q\": [0,\n 0 0]}");
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @r"
    error: not valid JSON: expected `,` or `]`
     --> state.json:2:4
      |
    2 |  0 0]}
      |    ^ here
    ");
}

#[test]
fn key_that_stands_twice_is_shown_with_its_line() {
    let ran = arm(
        "rotation",
        "{\"parameters\": {\"q\": 1},\n \"q\": [0, 0, 0],\n \"q\": [1, 0, 0]}",
    );
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @r#"
    error: the key `q` stands twice
     --> state.json:3:2
      |
    3 |  "q": [1, 0, 0]}
      |  ^^^ here
    "#);
}

#[test]
fn state_that_ends_early_is_shown_at_its_end() {
    let ran = arm("rotation", "");
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .starts_with("error: not valid JSON: EOF while parsing a value"),
        "{}",
        ran.err
    );
}

#[test]
fn no_state_is_needed_for_a_function_without_inputs() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    let ran = |function: &str| project.kane(&["eval", "arm.toml", "--function", function]);
    let weighed = ran("inertial_parameters");
    assert_eq!((weighed.code, weighed.err.as_str()), (0, ""));
    let bodies: Vec<Vec<f64>> = serde_json::from_str(&weighed.out).unwrap();
    assert!(bodies.iter().any(|parameters| parameters[0] == 2.0));

    let ran = ran("rotation");
    let needs = "error: `rotation` needs a state; give one with `--state FILE`\n";
    assert_eq!((ran.code, ran.err.as_str()), (2, needs));
}

#[test]
fn state_that_is_no_object_is_said() {
    let ran = arm("rotation", "[0, 0, 0]");
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .starts_with("error: the file holds a list; expected an object"),
        "{}",
        ran.err
    );
}

#[test]
fn quaternion_of_another_length_is_told_where_it_counts() {
    let project = Project::empty();
    let free = "\"free\"\nchart = \"quaternion\"";
    project.write(
        "arm.toml",
        &model("arm", "2.0").replace(r#"["theta1", "s2"]"#, free),
    );
    let ran = |function: &str, scalar: f64| {
        let arguments = ["eval", "arm.toml", "--function", function, "--state", "-"];
        let q: Vec<f64> = [scalar].into_iter().chain([0.0; 7]).collect();
        project.kane_given(&arguments, &json!({ "q": q }).to_string())
    };
    assert!(
        ran("rotation", 2.0)
            .err
            .contains("has length 2; expected 1")
    );
    assert_eq!(ran("rotation", 1.0).err, "");
    assert_eq!(ran("normalize", 2.0).err, "");
}

#[test]
fn a_frame_s_rotation_that_is_none_is_told() {
    let project = Project::empty();
    let frame = "\n[[frame]]\nname = \"tool\"\nrotation = { runtime = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }\n";
    project.write("arm.toml", &(model("arm", "2.0") + frame));
    let ran = |function: &str, entry: f64| {
        let arguments = ["eval", "arm.toml", "--function", function, "--state", "-"];
        let state = json!({ "q": {}, "parameters": { "tool_rotation_x_x": entry } });
        project.kane_given(&arguments, &state.to_string()).err
    };
    assert!(ran("pose(tool)", 2.0).starts_with("warning: the rotation of frame `tool` is none;"));
    assert!(ran("pose(tool)", -1.0).starts_with("warning: the rotation of frame `tool` is none;"));
    assert_eq!(ran("pose(tool)", 1.0), "");
    assert_eq!(ran("rotation", 2.0), "");
}

#[test]
fn a_key_is_shown_whatever_quotes_it_holds() {
    let ran = arm("bias", r#"{"q": {"a\\\"b" : 1}, "u": {}}"#);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @r#"
    error: `q.a\\"b` names none of the coordinates
     --> state.json:1:8
      |
    1 | {"q": {"a\\\"b" : 1}, "u": {}}
      |        ^^^^^^^^ here
      |
      = help: the coordinates are upper_theta1, upper_s2, fore_theta2
    "#);
}

#[test]
fn masses_below_zero_are_warned_of() {
    let ran = arm(
        "mass_matrix",
        r#"{"q": {}, "parameters": {"upper_mass": -2}}"#,
    );
    let told = "warning: `upper_mass` is -2.0 kg; expected zero or more\n";
    assert_eq!((ran.code, ran.err.as_str()), (0, told));
}

#[test]
fn what_has_no_place_of_its_own_is_told_where_it_is() {
    let project = Project::empty();
    project.write("model.urdf", FOLLOWER);
    for (function, state, told) in [
        (
            "potential_energy",
            r#"{"q": {"right": 0.1}}"#,
            "it follows `left`",
        ),
        (
            "generalized_forces",
            r#"{"q": {}, "loads": {"tool": {"force": [0, 0, 1], "moment": [0, 0, 0]}}}"#,
            "it is fixed to `one`; name that",
        ),
    ] {
        project.write("state.json", state);
        let ran = project.kane(&[
            "eval",
            "model.urdf",
            "-f",
            function,
            "--state",
            "state.json",
        ]);
        assert_eq!(ran.code, 2, "{}", ran.out);
        assert!(ran.err.contains(told), "{}", ran.err);
    }
}

/// Two fingers, of which one follows the other, and a tool.
const FOLLOWER: &str = "<robot name=\"gripper\"><link name=\"base\"/>
    <link name=\"one\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"1\"/>
    <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <link name=\"two\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"1\"/>
    <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
    <link name=\"tool\"/>
    <joint name=\"left\" type=\"continuous\"><parent link=\"base\"/><child link=\"one\"/><axis xyz=\"0 1 0\"/></joint>
    <joint name=\"right\" type=\"continuous\"><parent link=\"base\"/><child link=\"two\"/><axis xyz=\"0 1 0\"/><mimic joint=\"left\"/></joint>
    <joint name=\"mount\" type=\"fixed\"><parent link=\"one\"/><child link=\"tool\"/></joint>
    </robot>";

#[test]
fn what_is_locked_or_removed_is_told_as_such() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    project.write("state.json", r#"{"q": {"fore_theta2": 1}}"#);
    let told = |change: &[&str]| {
        let asked = ["eval", "arm.toml", "--function", "potential_energy"];
        let ran = project.kane(&[&asked[..], &["--state", "state.json"], change].concat());
        assert_eq!(ran.code, 2);
        ran.err
    };
    let held = "`lock` holds it at 0.3";
    for name in ["fore_theta2", "fore"] {
        project.write("state.json", &format!(r#"{{"q": {{"{name}": 1}}}}"#));
        for lock in ["fore_theta2=0.3", "fore=0.3"] {
            let locked = told(&["--lock", lock]);
            assert!(locked.contains(held), "{locked}");
            assert!(!locked.contains("speed"), "{locked}");
        }
    }
    project.write("state.json", r#"{"q": {}, "tau": {"fore": 1}}"#);
    let asked = ["eval", "arm.toml", "--function", "mass_matrix_solve"];
    let lock = ["--state", "state.json", "--lock", "fore=0.3"];
    let of_force = project.kane(&[&asked[..], &lock].concat()).err;
    assert!(
        of_force.contains("holds it at 0.3, so that it has no speed"),
        "{of_force}"
    );
    project.write("state.json", r#"{"q": {"fore_theta1": 1}}"#);
    let other = told(&["--lock", "fore_theta2=0.3"]);
    assert!(!other.contains(held), "{other}");
    project.write("state.json", r#"{"q": {"fore": 1}}"#);
    let removed = told(&["--remove", "fore"]);
    assert!(removed.contains("`remove` fixes it at zero"), "{removed}");
}

#[test]
fn what_is_missing_can_be_all_zero() {
    let needs = arm("loaded_inverse_dynamics", "{}");
    let names = ["q", "u", "u_dot", "loads"];
    for name in names {
        let help = format!("= help: `\"{name}\": {{}}` means that all are zero\n");
        assert!((needs.err.clone() + "\n").contains(&help), "{}", needs.err);
    }
    let empty = names.map(|name| format!("\"{name}\": {{}}")).join(", ");
    let ran = arm("loaded_inverse_dynamics", &format!("{{{empty}}}"));
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn several_functions_are_joined_by_a_plus() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    for asked in [
        &["-f", "bias,mass_matrix"][..],
        &["-f", "bias", "-f", "mass_matrix"],
    ] {
        let ran = project.kane(&[&["eval", "arm.toml"], asked].concat());
        assert_eq!(ran.code, 2);
        insta::allow_duplicates! {
            insta::assert_snapshot!(ran.err, @"error: 2 functions are asked for; expected one: join them with `+`, `bias+mass_matrix`");
        }
    }
    // Commas in brackets separate none.
    let ran = arm("d(bias)/d(q,u)", r#"{"q": {}, "u": {}}"#);
    assert_eq!(ran.code, 0, "{}", ran.err);
    // What cannot be joined, and what is one function, have no such advice.
    let ran = project.kane(&["eval", "arm.toml", "-f", "bias", "-f", "all"]);
    assert_eq!(ran.err, "error: 2 functions are asked for; expected one\n");
    for one in [
        &["-f", "inertial_parameters,"][..],
        &["-f", "inertial_parameters", "-f", "inertial_parameters"],
    ] {
        let ran = project.kane(&[&["eval", "arm.toml"], one].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
    }
}

#[test]
fn angles_that_are_singular_are_told_by_their_joint() {
    let project = Project::empty();
    let hip = model("walker", "2.0").replace(
        "joint = [\"theta2\"]",
        "joint = [\"theta1\", \"theta2\", \"theta3\"]\njoint_name = \"hip\"",
    );
    let spinning = hip.replace("joint_name", "speeds = \"angular_velocity\"\njoint_name");
    project.write("hip.toml", &hip);
    project.write("spinning.toml", &spinning);
    let told = |model: &str, function: &str, angle: f64| {
        let state = json!({
            "q": [0.1, 0.2, 0.3, angle, 0.4],
            "u": [0.1, 0.2, 0.3, 0.4, 0.5],
            "tau": [0.1, 0.2, 0.3, 0.4, 0.5],
            "u_dot": [0.1, 0.2, 0.3, 0.4, 0.5],
        });
        let mut arguments = vec!["eval", model, "--state", "-", "--function"];
        arguments.extend(function.split(' '));
        let ran = project.kane_given(&arguments, &state.to_string());
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.err
    };
    let right = std::f64::consts::FRAC_PI_2;
    let said = "warning: `hip` is at its singularity, |cos(theta2)| is 6.1e-17: results that divide by it are inaccurate\n";
    assert_eq!(told("hip.toml", "forward_dynamics", right), said);
    assert_eq!(told("hip.toml", "forward_dynamics", 1.5), "");
    // What divides by nothing is right there too.
    assert_eq!(told("hip.toml", "bias", right), "");
    // Speeds that are an angular velocity have no singularity, rates of the angles have.
    assert_eq!(told("spinning.toml", "forward_dynamics", right), "");
    assert_eq!(told("spinning.toml", "q_dot", right), said);
    // Pivots of a small body are small, and do not vanish.
    let small = spinning
        .replace("= 0.1", "= 1e-7")
        .replace("= 0.02", "= 1e-7");
    let small = small
        .replace("= 0.01", "= 0")
        .replace("mass = 1.5", "mass = 0");
    project.write("small.toml", &small);
    assert_eq!(told("small.toml", "forward_dynamics", right), "");
    // Where the hip's accelerations are given, nothing is divided by its pivots.
    let hybrid = "hybrid_dynamics --prescribed hip";
    assert_eq!(told("hip.toml", hybrid, right), "");
}

#[test]
fn a_mass_matrix_that_is_singular_is_told_by_the_speed() {
    let project = Project::empty();
    // A point that slides along the arm of a massless hinge.
    let text = r#"
name = "slide"
lower_bodies = [0, 1]

[[body]]
name = "crank"
attachment = [0, 0, 0]
joint = "revolute"
axis = [0, 0, 1]
mass = 0.0
mass_center = [0, 0, 0]
inertia = { xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0 }

[[body]]
name = "bead"
attachment = [0, 0, 0]
joint = "prismatic"
axis = [1, 0, 0]
mass = 1.0
mass_center = [0, 0, 0]
inertia = { xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0 }
"#;
    project.write("slide.toml", text);
    let told = |function: &str, place: f64| {
        let state = json!({ "q": [0.3, place], "u": [1.0, 0.5], "tau": [0.1, 0.2] });
        let arguments = ["eval", "slide.toml", "--function", function, "--state", "-"];
        let ran = project.kane_given(&arguments, &state.to_string());
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.err
    };
    assert_eq!(
        told("forward_dynamics", 0.0),
        "warning: the mass matrix is not positive definite: its pivot at `crank_theta3_dot` is 0.0\n\
         warning: 1 of 2 numbers are not finite; they are shown as null\n"
    );
    assert_eq!(told("forward_dynamics", 0.1), "");
    assert_eq!(told("mass_matrix", 0.0), "");
}

#[test]
fn mass_matrices_that_are_nearly_singular_are_told_by_the_speed() {
    let project = Project::empty();
    let body = |name: &str, axis: &str, mass: &str, inertia: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nattachment = [0, 0, 0]\njoint = \"revolute\"\naxis = {axis}\nmass = {mass}\n\
             mass_center = [0, 0, 0]\ninertia = {{ xx = {inertia}, yy = {inertia}, zz = {inertia}, xy = 0, xz = 0, yz = 0 }}\n"
        )
    };
    // The outer axis of three gimbals turns towards the inner one.
    let gimbals = [
        body("outer", "[0, 0, 1]", "0", "0"),
        body("middle", "[1, 0, 0]", "0", "0"),
        body("inner", "[0, 0, 1]", "2", "0.1"),
    ];
    let frame = "[[frame]]\nname = \"tip\"\nbody = \"inner\"\nposition = [0.1, 0.2, 0.3]\n";
    let gimbals = format!(
        "name = \"gimbals\"\nlower_bodies = [0, 1, 2]\n{}{frame}",
        gimbals.concat()
    );
    project.write("gimbals.toml", &gimbals);
    let told = |function: &str, angle: f64| {
        let some = [0.1, 0.2, 0.3];
        let state = json!({ "q": [0.3, angle, 0.4], "u": some, "u_dot": some, "tau": some });
        let mut arguments = vec!["eval", "gimbals.toml", "--state", "-", "--function"];
        arguments.extend(function.split(' '));
        let ran = project.kane_given(&arguments, &state.to_string());
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.err
    };
    let said = "warning: the mass matrix is nearly singular: its pivot at `outer_theta3_dot` is ";
    for function in [
        "forward_dynamics",
        "mass_matrix_inverse",
        "forward_dynamics(sin_cos)",
        "d(forward_dynamics)/d(q)",
        "operational_inverse_inertia(tip)",
    ] {
        let told = told(function, 1e-7);
        assert!(told.starts_with(said), "{function}: {told}");
    }
    // Ten digits are lost here, and fewer there.
    assert_eq!(told("forward_dynamics", 1e-5), "");
    assert_eq!(told("forward_dynamics", 1.0), "");
    // What is not solved for is right.
    for function in ["mass_matrix", "bias", "hybrid_dynamics --prescribed outer"] {
        assert_eq!(told(function, 1e-7), "", "{function}");
    }
}
