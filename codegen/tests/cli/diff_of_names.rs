//! What `kane diff` tells of bodies that came or went, of other names, and of axes.

use serde_json::Value;

use super::project::{Project, Ran, model, repository};

/// The URDF of the tutorials and the same after edits.
fn edited(edits: &[[&str; 2]], options: &[&str]) -> Ran {
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    let edit = |text: String, [from, to]: &[&str; 2]| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    };
    let new = edits.iter().fold(text.clone(), edit);
    told(&text, &new, "urdf", options)
}

fn told(old: &str, new: &str, ending: &str, options: &[&str]) -> Ran {
    let project = Project::empty();
    let files = ["old", "new"].map(|name| format!("{name}.{ending}"));
    project.write(&files[0], old);
    project.write(&files[1], new);
    project.kane(&[&["diff", &files[0], &files[1]], options].concat())
}

fn value(ran: &Ran) -> Value {
    serde_json::from_str(&ran.out).unwrap()
}

#[test]
fn body_that_is_fixed_comes_and_goes_with_its_mass_and_place() {
    let text = std::fs::read_to_string(repository("models/arm.urdf")).unwrap();
    let camera = "<link name=\"cam\"><inertial><mass value=\"0.1\"/><inertia ixx=\"1e-4\" ixy=\"0\" ixz=\"0\" iyy=\"1e-4\" iyz=\"0\" izz=\"1e-4\"/>\
                  </inertial></link><joint name=\"camj\" type=\"fixed\"><parent link=\"upper_arm\"/><child link=\"cam\"/>\
                  <origin xyz=\"0.1 0 0.05\"/></joint></robot>";
    let with_camera = text.replace("</robot>", camera);
    let place = "cam  on upper_arm, joint fixed, mass 0.1, at [0.1, 0.0, 0.05]\n";
    let ran = told(&text, &with_camera, "urdf", &["--functions", "bias"]);
    assert!(
        ran.out
            .starts_with(&format!("bodies and joints\n  added    {place}")),
        "{}",
        ran.out
    );
    let ran = told(&with_camera, &text, "urdf", &["--functions", "bias"]);
    assert!(
        ran.out
            .starts_with(&format!("bodies and joints\n  removed  {place}")),
        "{}",
        ran.out
    );
}

#[test]
fn renamed_link_that_is_fixed_is_told_and_its_values_under_both_names() {
    let rename = ["\"tool\"", "\"gripper\""];
    let ran = edited(&[rename], &["--functions", "bias"]);
    let said = "bodies and joints\n  renamed  tool -> gripper\ngenerated text (--lines shows it)\n";
    assert!(ran.out.starts_with(said), "{}", ran.out);
    assert!(
        ran.out.ends_with("; only names changed\n"),
        "only the name of a frame differs: {}",
        ran.out
    );
    let heavier = [rename, ["<mass value=\"0.5\"/>", "<mass value=\"0.75\"/>"]];
    let ran = edited(&heavier, &["--functions", "bias"]);
    let said = "values\n  changed  tool -> gripper: mass  0.5 -> 0.75\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    let told = value(&edited(&[rename], &["--format", "json"]));
    let renamed = serde_json::json!([{ "old": "tool", "new": "gripper" }]);
    assert_eq!(
        (&told["bodies"]["renamed"], &told["breaking"]),
        (&renamed, &Value::Bool(false))
    );
}

#[test]
fn flipped_axis_breaks_code() {
    let axis = "<axis xyz=\"0 1 0\"/>\n    <limit lower=\"-2.5\"";
    let ran = edited(&[[axis, &axis.replace("0 1 0", "0 -1 0.5")]], &[]);
    let said = "BREAKING: places that mean something else\n  changed  direction of q, u and tau of elbow  \
                axis [0.0, 1.0, 0.0] -> axis [0.0, -1.0, 0.5]\n";
    assert!(ran.out.starts_with(said), "{}", ran.out);
    let told = value(&edited(
        &[[axis, &axis.replace("0 1 0", "0 -1 0")]],
        &["--format", "json"],
    ));
    assert_eq!(told["breaking"], true);
    let told = value(&edited(
        &[[axis, &axis.replace("0 1 0", "0 1 0.5")]],
        &["--format", "json"],
    ));
    assert_eq!(told["breaking"], false);
}

#[test]
fn axis_that_is_flipped_with_the_axes_that_it_is_given_in_breaks_nothing() {
    let half_turn = "rotation = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]\n";
    let joint = |rotations: &str, axis: &str| {
        let joint = format!("{rotations}joint = \"revolute\"\naxis = {axis}");
        model("arm", "2.0").replace("joint = [\"theta2\"]", &joint)
    };
    let old = joint("", "[0, 1, 0]");
    // The body's own axes turn with those of the joint, or do not.
    for rotations in [
        format!("attachment_{half_turn}"),
        format!("attachment_{half_turn}body_{half_turn}"),
    ] {
        let new = joint(&rotations, "[0, -1, 0]");
        let told = value(&told(&old, &new, "toml", &["--format", "json"]));
        assert_eq!(told["breaking"], false, "{told}");
    }
}

#[test]
fn length_of_an_axis_is_no_difference() {
    let ran = edited(&[["<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 2 0\"/>"]], &[]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
}

#[test]
fn renamed_joint_breaks_code_that_finds_it_by_name() {
    let rename = ["\"elbow\"", "\"hinge\""];
    let told = value(&edited(&[rename], &["--format", "json"]));
    assert_eq!(told["breaking"], true);
    let renamed = serde_json::json!([{ "old": "elbow", "new": "hinge", "place": 2 }]);
    assert_eq!(told["layouts"][0]["renamed"], renamed);
    // What is no coordinate has no name that code finds.
    let rename = ["\"flange\"", "\"weld\""];
    let ran = edited(&[rename], &[]);
    assert_eq!(
        ran.out,
        "bodies and joints\n  changed  tool: joint_name  flange -> weld\ngenerated text is the same\n"
    );
}

#[test]
fn neighbours_that_moved_alike_are_one_line() {
    let old = model("arm", "2.0");
    let (head, fore) = old.split_once("[[body]]\nname = \"fore\"").unwrap();
    let chain = |names: &[&str]| -> String {
        let lower: Vec<String> = (0..=names.len()).map(|place| place.to_string()).collect();
        let head = head.replace("[0, 1]", &format!("[{}]", lower.join(", ")));
        let bodies = names.iter();
        let bodies = bodies.map(|name| format!("[[body]]\nname = \"{name}\"{fore}"));
        std::iter::once(head).chain(bodies).collect()
    };
    let ran = told(
        &chain(&["a", "b", "c"]),
        &chain(&["new", "a", "b", "c"]),
        "toml",
        &["--functions", "bias"],
    );
    let said = "BREAKING: the places in arrays over bodies changed\n  added    new     1\n  moved    a .. c  1..=3 -> 2..=4\n";
    assert!(ran.out.starts_with(said), "{}", ran.out);
    let ran = told(
        &chain(&["a", "b"]),
        &chain(&["new", "a", "b"]),
        "toml",
        &["--functions", "bias"],
    );
    let said = "  moved    a    1 -> 2\n  moved    b    2 -> 3\n";
    assert!(ran.out.contains(said), "{}", ran.out);
}
