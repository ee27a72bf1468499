//! `kane info`.

use serde_json::Value;

use super::project::{Project, model, repository};

fn info(arguments: &[&str]) -> String {
    let path = repository("models/eight_body.toml");
    let ran = Project::empty().kane(&[&["info", path.to_str().unwrap()], arguments].concat());
    assert_eq!(ran.code, 0, "{ran:?}");
    ran.out
}

/// The text below a heading, up to the next one.
pub(crate) fn section(text: &str, heading: &str) -> String {
    let from = text.find(heading).unwrap();
    let paragraphs: Vec<&str> = text[from..].splitn(3, "\n\n").collect();
    paragraphs[1].to_owned()
}

#[test]
fn tree_of_the_example_is_drawn() {
    insta::assert_snapshot!(section(&info(&[]), "eight_body"), @"
    0 inertial frame
    `-- 1 hub: theta1 theta2 theta3 s1 s2 s3
        |-- 2 shoulder: theta1 theta2 theta3 s1 s2 s3
        |   |-- 3 forearm: theta1 theta2 theta3 s1 s2 s3
        |   `-- 5 left_tip: theta1 theta2 theta3 s1 s2 s3
        |-- 4 left_panel: theta1 theta2 theta3 s1 s2 s3
        |-- 6 antenna: theta1 theta2 theta3 s1 s2 s3
        `-- 7 boom: theta1 theta2 theta3 s1 s2 s3
            `-- 8 camera: theta1 theta2 theta3 s1 s2 s3
    ");
}

#[test]
fn axes_of_joints_with_names_are_shown_along_those_of_their_bodies() {
    let project = Project::empty();
    let link = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"0 0.1 0.2\"/><mass value=\"1\"/>\
             <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
        )
    };
    let joint = |name: &str, kind: &str, ends: [&str; 2], inside: &str| {
        let [parent, child] = ends;
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>{inside}</joint>"
        )
    };
    let robot = [
        "<robot name=\"hand\">".to_owned(),
        ["base", "palm", "left", "right"].map(link).concat(),
        joint(
            "wrist",
            "continuous",
            ["base", "palm"],
            "<axis xyz=\"1 1 0\"/>",
        ),
        joint(
            "finger",
            "prismatic",
            ["palm", "left"],
            "<axis xyz=\"0 -1 0\"/><limit lower=\"0\" upper=\"1\"/>",
        ),
        joint(
            "thumb",
            "prismatic",
            ["palm", "right"],
            "<axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"1\"/><mimic joint=\"finger\"/>",
        ),
        "</robot>".to_owned(),
    ];
    project.write("hand.urdf", &robot.concat());
    let ran = project.kane(&["info", "hand.urdf"]);
    insta::assert_snapshot!(section(&ran.out, "hand: "), @"
    0 inertial frame
    `-- 1 palm by wrist: about (0.707, 0.707, 0)
        |-- 2 left by finger: along (0, -1, 0)
        `-- 3 right by thumb: along (0, 1, 0), as 1.0 finger
    ");
}

#[test]
fn axes_of_joints_without_names_are_shown_where_they_are_turned() {
    let project = Project::empty();
    let turned = model("arm", "2.0").replace(
        "joint = [\"theta2\"]",
        "joint = \"revolute\"\naxis = [0.0, 1.0, 1.0]\nlimits = { lower = -1.0, effort = 5.0 }",
    );
    project.write("arm.toml", &turned);
    let ran = project.kane(&["info", "arm.toml"]);
    assert!(
        ran.out.contains(": theta3 about (0, 0.707, 0.707)\n"),
        "{}",
        ran.out
    );
    let sliding = model("arm", "2.0").replace(
        "joint = [\"theta2\"]",
        "joint = \"planar\"\naxis = [0.0, -1.0, 0.0]",
    );
    project.write("sliding.toml", &sliding);
    let ran = project.kane(&["info", "sliding.toml"]);
    assert!(
        ran.out.contains(": theta2 about (0, -1, 0) s1 s3\n"),
        "{}",
        ran.out
    );
    let ran = project.kane(&["info", "arm.toml", "--json"]);
    let report: Value = serde_json::from_str(&ran.out).unwrap();
    let limits = &report["limits"];
    assert_eq!(limits["lower"][2], -1.0);
    assert_eq!(limits["upper"][2], Value::Null);
    assert_eq!(limits["effort"][2], 5.0);
}

#[test]
fn partitions_of_the_example_are_drawn() {
    insta::assert_snapshot!(section(&info(&["--partitions"]), "Partitions"));
}

/// Eqs. (16) and (30): `W_K` has path(K); `V_O_K` has path(L(K)) among the first N and path(K) among the last N; `V_G_K` has
/// path(K) in both.
#[test]
fn partitions_of_the_example_are_the_paths_of_the_notes() {
    let report: Value = serde_json::from_str(&info(&["--json"])).unwrap();
    let lower = [0, 1, 2, 1, 2, 1, 1, 7];
    let path = |body: usize, from: usize| {
        let mut path = Vec::new();
        let mut body = body;
        while body != 0 {
            path.push(from + body);
            body = lower[body - 1];
        }
        path.reverse();
        path
    };
    for body in 1..=8 {
        let row = &report["partitions"][body - 1];
        assert_eq!(row["body"], body);
        assert_eq!(row["W"], Value::from(path(body, 0)));
        assert_eq!(
            row["V_O"],
            Value::from([path(lower[body - 1], 0), path(body, 8)].concat())
        );
        assert_eq!(
            row["V_G"],
            Value::from([path(body, 0), path(body, 8)].concat())
        );
    }
}

#[test]
fn everything_of_a_small_system_is_shown() {
    let project = Project::empty();
    // The user's second body is the root, one angle is locked, two values are left to run time.
    let text = model("arm", "{ runtime = 2.0 }")
        .replace("lower_bodies = [0, 1]", "lower_bodies = [2, 0]")
        .replace(
            "joint = [\"theta2\"]",
            "joint = [\"theta2\"]\nlocked = { theta3 = 0.5 }",
        )
        .replace("-9.81", "{ runtime = -9.81 }");
    project.write("arm.toml", &text);
    let ran = project.kane(&["info", "arm.toml", "--partitions"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let verbose = project.kane(&["info", "arm.toml", "--verbose"]);
    assert!(verbose.err.contains("renumbered outward"), "{verbose:?}");
    let (description, _) = ran.out.split_once("Operations by formulation").unwrap();
    insta::assert_snapshot!(description);
}

#[test]
fn json_has_the_documented_keys() {
    let report: Value = serde_json::from_str(&info(&["--json"])).unwrap();
    let keys = |value: &Value| {
        value
            .as_object()
            .unwrap()
            .keys()
            .cloned()
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(
        keys(&report),
        "bodies coordinates frames functions gravity limits name order parameters partitions speeds"
    );
    assert_eq!(
        keys(&report["bodies"][0]),
        "free identifier joint locked lower_body mimics name number user_number"
    );
    assert_eq!(keys(&report["coordinates"][0]), "body kind name place unit");
    assert_eq!(keys(&report["partitions"][0]), "V_G V_O W body");
    assert_eq!(
        keys(&report["functions"][0]),
        "cheapest default formulations name"
    );
    assert_eq!(report["coordinates"][47]["name"], "camera_s3");
    assert_eq!(report["coordinates"][47]["place"], 47);
    assert_eq!(report["order"], "notes");
    assert_eq!(
        keys(&report["limits"]),
        "effort friction lower upper velocity"
    );
}

#[test]
fn counts_are_those_of_the_generated_functions() {
    let report: Value = serde_json::from_str(&info(&["--json"])).unwrap();
    let path = repository("models/eight_body.toml");
    let project = Project::empty();
    let functions = report["functions"].as_array().unwrap();
    let mass_matrix = functions
        .iter()
        .find(|function| function["name"] == "mass_matrix");
    for formulation in ["notes", "recursive"] {
        let arguments = [
            "generate",
            path.to_str().unwrap(),
            "--output",
            "-",
            "--formulation",
            formulation,
            "--functions",
            "mass_matrix",
        ];
        let source = project.kane(&arguments).out;
        let counts = &mass_matrix.unwrap()["formulations"][formulation];
        let [total, mul, add, div, trig] =
            ["total", "mul", "add", "div", "trig"].map(|key| &counts[key]);
        let line = format!(
            "/// Operations: {total} = {mul} mul + {add} add + {div} div + {trig} trig; formulation: {formulation}."
        );
        assert!(source.contains(&line), "no {line}");
    }
}

#[test]
fn functions_that_are_named_are_counted_alone() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "{ runtime = 2.0 }"));
    let functions = "bias,mass_matrix+bias";
    let ran = project.kane(&["info", "arm.toml", "--functions", functions]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (_, counts) = ran.out.split_once("Operations by formulation").unwrap();
    let names = counts.lines().skip(3);
    let names: Vec<&str> = names
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert_eq!(names, ["bias", "mass_matrix+bias"]);
    let ran = project.kane(&["info", "arm.toml", "--functions", "bias+mass"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("`mass` is no function"), "{}", ran.err);
}

#[test]
fn what_is_too_large_is_said_where_it_has_no_count() {
    let project = Project::empty();
    let talos = repository("tests/robots/talos/talos.urdf");
    let function = "hessian(forward_dynamics; q, u, tau)";
    let ran = project.kane(&[
        "info",
        talos.to_str().unwrap(),
        "--base",
        "free",
        "--functions",
        function,
        "--without",
        "composite",
    ]);
    assert_eq!(ran.code, 0);
    let note = format!("note: `{function}`, by 114 variables, builds about ");
    assert!(ran.err.contains(&note), "{}", ran.err);
}

#[test]
fn the_formulation_that_is_emitted_is_marked() {
    let project = Project::empty();
    for (model, function) in [
        ("models/eight_body.toml", "mass_matrix"),
        ("models/cart_pole.toml", "bias"),
        ("models/cart_pole.toml", "hessian(linear_momentum; q)"),
        ("models/cart_pole.toml", "hessian(angular_momentum; q)"),
        ("models/arm.urdf", "hessian(angular_momentum; q, u)"),
        (
            "models/arm.urdf",
            "kinetic_energy+centroidal_momentum_matrix",
        ),
    ] {
        let path = repository(model);
        let path = path.to_str().unwrap();
        let ran = project.kane(&["info", path, "--json", "--functions", function]);
        let report: Value = serde_json::from_str(&ran.out).unwrap();
        let count = &report["functions"][0];
        let formulation = count["cheapest"].as_str().unwrap();
        let total = &count["formulations"][formulation]["total"];
        let arguments = ["generate", path, "--output", "-", "--functions", function];
        let source = project.kane(&arguments).out;
        let mut lines = source.lines();
        let line = lines.find(|line| {
            line.contains(&format!("Operations: {total} = "))
                && line.ends_with(&format!("; formulation: {formulation}."))
        });
        assert!(line.is_some(), "{model}, {function}: {count}");
    }
}

#[test]
fn sets_of_functions_are_counted_whole_and_all_holds_the_default_one() {
    let names = |functions: &str| -> Vec<String> {
        let text = info(&["--functions", functions]);
        let (_, counts) = text.split_once("Operations by formulation").unwrap();
        let lines = counts.lines().skip(3);
        let names = lines.filter_map(|line| line.split_whitespace().next());
        names.map(str::to_owned).collect()
    };
    let (default, more) = (names("default"), names("default,rotation,linear_momentum"));
    assert_eq!(default.len(), 9);
    assert_eq!(
        more,
        [&default[..], &["linear_momentum".to_owned()]].concat()
    );
    let all = names("all");
    assert!(default.iter().all(|name| all.contains(name)));
    assert!(all.contains(&"regressor".to_owned()), "{all:?}");
}

#[test]
fn pattern_of_the_mass_matrix_is_that_of_its_numbers() {
    let project = Project::empty();
    // Two arms on one hub: neither moves the other.
    let hub = model("tree", "2.0");
    let (_, fore) = hub.split_once("[[body]]\nname = \"fore\"").unwrap();
    let text = hub.replace("[0, 1]", "[0, 1, 1]");
    let text = format!("{text}\n[[body]]\nname = \"other\"{fore}");
    project.write("tree.toml", &text);
    let ran = project.kane(&["info", "tree.toml"]);
    let (_, pattern) = ran.out.split_once("Mass matrix").unwrap();
    let rows = pattern.lines().skip(2).take_while(|line| !line.is_empty());
    let rows: Vec<Vec<bool>> = rows
        .map(|row| row.split_whitespace().map(|entry| entry == "x").collect())
        .collect();
    let count = rows.len();
    let state = serde_json::json!({ "q": vec![0.3; count], "u": vec![0.0; count] });
    project.write("state.json", &state.to_string());
    let arguments = ["eval", "tree.toml", "-f", "mass_matrix", "-s", "state.json"];
    let value: Value = serde_json::from_str(&project.kane(&arguments).out).unwrap();
    let matrix = value.as_array().unwrap();
    assert_eq!(rows.len(), matrix.len());
    for (row, numbers) in rows.iter().zip(matrix) {
        let numbers = numbers.as_array().unwrap().iter();
        let numbers: Vec<bool> = numbers.map(|entry| entry.as_f64() != Some(0.0)).collect();
        assert_eq!(*row, numbers);
    }
    assert!(rows.iter().flatten().any(|entry| !entry));
}

#[test]
fn drawing_is_xml_with_every_body_and_an_entry_of_the_pattern_each() {
    let drawing = info(&["--svg"]);
    let document = roxmltree::Document::parse(&drawing).unwrap();
    let texts = document.descendants().filter(roxmltree::Node::is_text);
    let texts = texts.filter_map(|node| node.text());
    let texts: Vec<&str> = texts
        .map(str::trim)
        .filter(|text| !text.is_empty())
        .collect();
    assert_eq!(texts[..3], ["inertial frame", "1 hub", "2 shoulder"]);
    let text = info(&["--partitions"]);
    let (_, pattern) = text.split_once("Mass matrix").unwrap();
    let pattern = pattern.split("\n\n").nth(1).unwrap();
    let entries = pattern.matches('x').count();
    assert_eq!(texts[9], format!("mass matrix: {entries} of {}", 48 * 48));
    let paths = document
        .descendants()
        .filter_map(|node| node.attribute("d"));
    let squares = paths.map(|path| path.matches("h10").count());
    assert_eq!(squares.sum::<usize>(), entries);
}

#[test]
fn faults_of_the_model_are_2() {
    let project = Project::empty();
    project.write(
        "arm.toml",
        &model("arm", "-2.0").replace("theta2", "theta4"),
    );
    let ran = project.kane(&["info", "arm.toml"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(
        ran.err.contains("arm.toml:7:8") && ran.err.contains("arm.toml:19:10"),
        "{}",
        ran.err
    );
}

#[test]
fn a_floating_robot_shows_its_joints_speeds_and_what_is_fixed() {
    let project = Project::empty();
    let robot = "<robot name=\"drone\">
        <link name=\"hull\"><inertial><mass value=\"1\"/>
        <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
        <link name=\"camera\"/><link name=\"rotor\"><inertial><mass value=\"0.1\"/>
        <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
        <link name=\"other\"><inertial><mass value=\"0.1\"/>
        <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
        <joint name=\"mount\" type=\"fixed\"><parent link=\"hull\"/><child link=\"camera\"/></joint>
        <joint name=\"shaft\" type=\"continuous\"><parent link=\"hull\"/><child link=\"rotor\"/><axis xyz=\"0 0 1\"/></joint>
        <joint name=\"twin\" type=\"continuous\"><parent link=\"hull\"/><child link=\"other\"/><axis xyz=\"0 0 -1\"/>
        <mimic joint=\"shaft\" multiplier=\"-1\" offset=\"0.5\"/></joint>
        </robot>";
    project.write("drone.urdf", robot);
    let ran = project.kane(&["info", "drone.urdf", "--base", "free"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (description, _) = ran.out.split_once("Operations by formulation").unwrap();
    insta::assert_snapshot!(description);
}

#[test]
fn weights_that_are_lifted_are_shown() {
    let shown = |name: &str| {
        let path = repository(&format!("tests/mjcf/{name}/{name}.xml"));
        let ran = Project::empty().kane(&["info", path.to_str().unwrap(), "--quiet"]);
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.out
    };
    let text = shown("weightless");
    assert!(
        text.contains("\nGravity compensation: 0.75 of all weights\n"),
        "{text}"
    );
    let text = shown("lifted");
    let expected = "Gravity compensation, in parts of the weights\n\n  base 0.300, shoulder 0.885, wrist 1.000, head 1.500\n";
    assert!(text.contains(expected), "{text}");
}

#[test]
fn a_long_sum_is_counted_under_the_name_that_it_was_given() {
    let sum = "mass_matrix+bias+inverse_dynamics+kinetic_energy+potential_energy";
    let named = format!("all_of_it = {sum}");
    let project = Project::arm();
    let counted = |functions: &str| {
        let ran = project.kane(&["info", "models/arm.toml", "--functions", functions]);
        assert_eq!(ran.code, 0, "{ran:?}");
        ran.out
    };
    assert!(counted(&named).contains("\n  all_of_it = ..  "));
    assert!(counted(sum).contains(&format!("\n  {sum}  ")));
}
