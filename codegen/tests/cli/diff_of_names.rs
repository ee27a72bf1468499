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
                axis [0.0, 1.0, 0.0] -> axis [0.0, -0.894, 0.447] in the axes of upper_arm\n";
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
    let half_turn = HALF_TURN;
    let joint = |rotations: &str, axis: &str| {
        jointed(&format!("{rotations}joint = \"revolute\"\naxis = {axis}"))
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

/// Half a turn about x, of one key or another.
const HALF_TURN: &str = "rotation = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]\n";

/// The arm with another joint of its last body, `fore`.
fn jointed(joint: &str) -> String {
    let text = model("arm", "2.0");
    let own = "joint = [\"theta2\"]";
    assert!(text.contains(own), "{text}");
    text.replace(own, joint)
}

#[test]
fn slides_that_a_planar_joint_chooses_otherwise_break_code() {
    let planar = |axis: &str| jointed(&format!("joint = \"planar\"\naxis = {axis}"));
    let functions = ["--functions", "bias"];
    let told = |old: &str, new: &str| told(&planar(old), &planar(new), "toml", &functions).out;
    let turned = told("[0.3, 0.2999, 1]", "[0.2999, 0.3, 1]");
    let said = "  changed  direction of q, u and tau of fore_s1, fore_s2  \
                axes [0.958, 0.0, -0.287], [-0.079, 0.961, -0.264] -> axes [0.0, -0.958, 0.287], [0.961, -0.079, -0.264] in the axes of ";
    assert!(turned.contains(said), "{turned}");
    // The hinge turned too, but one slide did not.
    let reversed = told("[0, 0, 1]", "[0, 0, -1]");
    let said = "direction of q, u and tau of fore_theta3, fore_s2  ";
    assert!(reversed.contains(said), "{reversed}");
    let leant = told("[0.3, 0.2, 1]", "[0.3, 0.1, 1]");
    assert!(!leant.contains("direction"), "{leant}");
}

#[test]
fn mounting_that_turns_a_joint_around_breaks_code() {
    let hinge = "joint = \"revolute\"\naxis = [0, 0, 1]";
    for joint in [hinge, "joint = [\"theta3\"]"] {
        for keys in [
            format!("attachment_{HALF_TURN}"),
            format!("attachment_{HALF_TURN}body_{HALF_TURN}"),
        ] {
            let new = jointed(&format!("{keys}{joint}"));
            let ran = told(&jointed(joint), &new, "toml", &["--functions", "bias"]);
            let said = "  changed  direction of q, u and tau of fore_theta3  \
                        axis [0.0, 0.0, 1.0] -> axis [0.0, 0.0, -1.0] in the axes of upper\n";
            assert!(ran.out.contains(said), "{}", ran.out);
        }
        // The body's own axes alone are others.
        let new = jointed(&format!("body_{HALF_TURN}{joint}"));
        let ran = told(&jointed(joint), &new, "toml", &["--functions", "bias"]);
        assert!(!ran.out.contains("direction"), "{}", ran.out);
    }
}

#[test]
fn angle_that_is_held_turns_the_axis_of_a_later_one() {
    let held = |angle: &str| {
        jointed(&format!(
            "joint = [\"theta3\"]\nlocked = {{ theta1 = {angle} }}"
        ))
    };
    let functions = ["--functions", "bias"];
    let ran = told(&held("0.1"), &held("3.1"), "toml", &functions);
    assert!(
        ran.out.contains("direction of q, u and tau of fore_theta3"),
        "{}",
        ran.out
    );
    let ran = told(&held("0.1"), &held("0.2"), "toml", &functions);
    assert!(!ran.out.contains("direction"), "{}", ran.out);
}

#[test]
fn axes_in_which_a_lower_body_is_described_turn_no_joint() {
    let hinge = "joint = \"revolute\"\naxis = [0, 0, 1]";
    let old = jointed(hinge);
    let name = "[[body]]\nname = ";
    let (first, _) = old.match_indices(name).next().unwrap();
    let turned = jointed(&format!("attachment_{HALF_TURN}{hinge}"));
    let line = turned[first..].find("joint = ").unwrap() + first;
    let new = format!("{}body_{HALF_TURN}{}", &turned[..line], &turned[line..]);
    let ran = told(&old, &new, "toml", &["--functions", "bias"]);
    assert!(!ran.out.contains("direction"), "{}", ran.out);
    let ran = told(&old, &turned, "toml", &["--functions", "bias"]);
    assert!(ran.out.contains("direction"), "{}", ran.out);
}

#[test]
fn an_axis_that_turns_by_a_right_angle_at_most_keeps_its_direction() {
    let hinge = |axis: &str| jointed(&format!("joint = \"revolute\"\naxis = {axis}"));
    let old = hinge("[1, 0.1, 0.3]");
    // Perpendicular, with products that rounding makes positive or negative.
    for axis in [
        "[-0.3, 0, 1]",
        "[0.1, -1, 0]",
        "[0.3, 3, -2]",
        "[0.3, 0, -1]",
        "[-0.1, 1, 0]",
    ] {
        let ran = told(&old, &hinge(axis), "toml", &["--functions", "bias"]);
        assert!(!ran.out.contains("direction"), "{axis}: {}", ran.out);
    }
}

#[test]
fn axes_over_another_lower_body_are_not_compared() {
    let hinge = |axis: &str| jointed(&format!("joint = \"revolute\"\naxis = {axis}"));
    let (old, new) = (hinge("[0, 0, 1]"), hinge("[0, 0, -1]"));
    let moved = new.replace("lower_bodies = [0, 1]", "lower_bodies = [0, 0]");
    assert_ne!(moved, new);
    let ran = told(&old, &moved, "toml", &["--functions", "bias"]);
    assert!(!ran.out.contains("direction"), "{}", ran.out);
    assert!(ran.out.contains("lower"), "{}", ran.out);
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
