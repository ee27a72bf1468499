//! What `kane diff` tells of arrays whose entries the tree or its numbers decide.

use serde_json::Value;

use super::project::{Project, model};

/// What differs for programs between a model with these functions and the same after edits.
fn told(old: &str, functions: &str, edits: &[[&str; 2]]) -> Value {
    let project = Project::empty();
    let edit = |text: String, [from, to]: &[&str; 2]| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    };
    let new = edits.iter().fold(old.to_owned(), edit);
    project.write("old.toml", old);
    project.write("new.toml", &new);
    let arguments = ["diff", "old.toml", "new.toml", "--functions", functions];
    let ran = project.kane(&[&arguments[..], &["--format", "json"]].concat());
    serde_json::from_str(&ran.out).unwrap()
}

/// The arrays that mean something else, with what they meant and mean.
fn meanings(told: &Value) -> Vec<[&str; 3]> {
    let all = told["meanings"].as_array().unwrap().iter();
    all.map(|one| ["name", "old", "new"].map(|key| one[key].as_str().unwrap()))
        .collect()
}

/// The arm on an upright axis.
fn upright() -> String {
    model("arm", "2.0").replace("[\"theta1\", \"s2\"]", "[\"theta3\"]")
}

#[test]
fn base_parameters_that_come_break_code() {
    let functions = "base_regressor,base_parameters";
    let tilted = ["[0.0, 0.0, -9.81]", "[1.0, 2.0, -9.81]"];
    let leaning = told(&upright(), functions, &[tilted]);
    assert_eq!(leaning["breaking"], true);
    // The second body has seven; of the first only the moment about its axis is felt, and once weight turns it two first moments too.
    let expected = ["BASE_PARAMETERS", "8 entries", "10 entries"];
    assert_eq!(meanings(&leaning), [expected]);
    // Numbers of the model, and names, change what no place means; names are told as such.
    let numbers = [["mass = 1.5", "mass = 1.25"], ["0.0, -1.0]", "0.0, -0.9]"]];
    let names = [["\"fore\"", "\"hand\""], ["\"upper\"", "\"arm\""]];
    for (edits, breaking) in [(numbers, false), (names, true)] {
        let told = told(&upright(), functions, &edits);
        assert_eq!(
            (&told["same"], &told["breaking"]),
            (&Value::Bool(false), &Value::Bool(breaking))
        );
        assert!(meanings(&told).is_empty(), "{told}");
    }
}

#[test]
fn entries_of_packed_arrays_that_go_or_move_break_code() {
    let frame = "[[frame]]\nname = \"tip\"\nbody = \"fore\"\nposition = [0.0, 0.0, 0.1]\n";
    let old = model("arm", "2.0") + frame;
    let functions = "mass_matrix_packed,jacobian_packed(tip)";
    let apart = told(&old, functions, &[["[0, 1]", "[0, 0]"]]);
    assert_eq!(apart["breaking"], true);
    let expected = [
        ["MASS_MATRIX_PACKED_PLACES", "6 entries", "4 entries"],
        ["TIP_SPEEDS", "3 entries", "1 entry"],
    ];
    assert_eq!(meanings(&apart), expected);
    let moved = told(
        &(old + "\n"),
        functions,
        &[
            ["[0, 1]", "[0, 0]"],
            ["body = \"fore\"", "body = \"upper\""],
        ],
    );
    assert_eq!(
        meanings(&moved)[1],
        ["TIP_SPEEDS", "3 entries", "2 entries"]
    );
}

#[test]
fn options_are_told_to_programs() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    for (file, options) in [("old.rs", &["--snap", "1e-5"][..]), ("new.rs", &["--fma"])] {
        let generate = [
            "generate",
            "arm.toml",
            "--functions",
            "bias",
            "--output",
            file,
        ];
        assert_eq!(project.kane(&[&generate[..], options].concat()).code, 0);
    }
    let ran = project.kane(&["diff", "old.rs", "new.rs", "--format", "json"]);
    let told: Value = serde_json::from_str(&ran.out).unwrap();
    let expected = serde_json::json!([
        { "key": "fma", "old": null, "new": "true" },
        { "key": "snap", "old": "1e-5", "new": "1e-9" },
    ]);
    assert_eq!(told["options"], expected);
}
