//! Joints that are locked or removed when a tree is built.

use kane_codegen::description::{Description, toml};
use kane_codegen::diagnostic::{Severity, Source};
use kane_codegen::tree::{self, Changes, Tree};

use kane_test_support::models::body;

/// Three bodies on one another, with these joints.
fn chain(joints: [&str; 3]) -> Description {
    let bodies = ["a", "b", "c"].map(|name| body(name, "[]"));
    let bodies = bodies
        .iter()
        .zip(joints)
        .map(|(body, joint)| body.replace("joint = []", joint));
    let text = format!(
        "name = \"s\"\nlower_bodies = [0, 1, 2]\n{}",
        bodies.collect::<String>()
    );
    toml::parse(&Source::new("model.toml", text))
}

/// The tree of three bodies on one another, with these joints, changed.
fn changed(joints: [&str; 3], changes: &Changes) -> Result<Tree, String> {
    match tree::build_with(&chain(joints), changes) {
        Ok(checked) => Ok(checked.tree),
        Err(faults) => Err(faults.to_string()),
    }
}

fn lock(name: &str, value: f64) -> Changes {
    Changes {
        lock: vec![(name.to_owned(), value)],
        ..Changes::default()
    }
}

#[test]
fn joint_that_is_locked_beyond_its_limits_is_told() {
    let limits = "joint = [\"theta1\"]\nlimits = { lower = -2.5, upper = 2.5 }";
    let free = "joint = [\"theta1\"]";
    let description = chain([limits, free, free]);
    for (value, expected) in [
        (
            2.5,
            "note: model.toml: `theta1` of body `a` is locked at 2.5 rad",
        ),
        (
            90.0,
            "warning: model.toml: `theta1` of body `a` is locked at 90.0 rad, beyond its limits -2.5 and 2.5 rad",
        ),
    ] {
        let checked = tree::build_with(&description, &lock("a", value)).unwrap();
        let brief = checked.warnings.brief();
        assert_eq!(brief.lines[0].1, expected);
    }
}

#[test]
fn joint_that_is_locked_at_what_looks_like_degrees_is_told_by_its_name() {
    let free = "joint = [\"theta1\"]";
    let named = "joint = [\"theta1\"]\njoint_name = \"elbow\"";
    let slide = "joint = [\"s1\"]\njoint_name = \"rail\"";
    let description = chain([named, slide, free]);
    for (name, expected) in [
        (
            "elbow",
            "warning: model.toml: joint `elbow` is locked at 90.0 rad; is it in degrees?",
        ),
        (
            "c",
            "warning: model.toml: `theta1` of body `c` is locked at 90.0 rad; is it in degrees?",
        ),
        ("rail", "note: model.toml: joint `rail` is locked at 90.0 m"),
    ] {
        let checked = tree::build_with(&description, &lock(name, 90.0)).unwrap();
        assert_eq!(checked.warnings.brief().lines[0].1, expected);
    }
}

#[test]
fn joint_that_follows_another_and_is_locked_is_told() {
    let free = "joint = [\"theta1\"]";
    let follower =
        "joint = [\"theta1\"]\nmimic = { joint = \"a\", multiplier = 2.0, offset = 0.1 }";
    let description = chain([free, follower, free]);
    let checked = tree::build_with(&description, &lock("b", 0.2)).unwrap();
    let brief = checked.warnings.brief();
    assert_eq!(
        brief.lines[0].1,
        "warning: model.toml: `theta1` of body `b` is locked at 0.2 rad, and follows no other joint any more"
    );
    // What it followed stays free.
    assert_eq!(checked.tree.n_speeds, 2);
    let limited = format!("{follower}\nlimits = {{ lower = -0.1, upper = 0.1 }}");
    let checked = tree::build_with(&chain([free, &limited, free]), &lock("b", 0.2)).unwrap();
    let line = &checked.warnings.brief().lines[0].1;
    assert!(
        line.ends_with("0.1 rad, and follows no other joint any more"),
        "{line}"
    );
}

#[test]
fn joints_that_are_all_locked_are_told_why_nothing_moves() {
    let fixed = "joint = []";
    let description = chain(["joint = [\"theta1\"]", fixed, fixed]);
    let found = tree::build_with(&description, &lock("a", 0.2)).unwrap_err();
    let errors = found
        .list()
        .iter()
        .filter(|one| one.severity == Severity::Error);
    let helps: Vec<Option<&str>> = errors.map(|one| one.help.as_deref()).collect();
    assert_eq!(
        helps,
        [Some("`lock` and `remove` hold all that could move")]
    );
}

#[test]
fn what_follows_a_locked_joint_holds_at_the_locked_coordinate() {
    let joints = [
        "joint = [\"theta3\"]\nlocked = { theta1 = 0.5 }",
        "joint = [\"theta1\"]\nmimic = { joint = \"a\", multiplier = 2.0, offset = 0.1 }",
        "joint = [\"theta1\", \"theta2\"]",
    ];
    // Only `c` moves: the others are parts of the inertial frame, turned by 0.5 and 0.2, and by 2 * 0.2 + 0.1.
    let tree = changed(joints, &lock("a", 0.2)).unwrap();
    assert_eq!(tree.bodies.len(), 1);
    let turn = |angle: f64| {
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        [[1.0, 0.0, 0.0], [0.0, c, s], [0.0, -s, c]]
    };
    let (s, c) = (libm::sin(0.2), libm::cos(0.2));
    let about_z = [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
    let product = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    };
    // About x by 0.5, about z by 0.2; then about x by 0.5.
    let expected = product(turn(0.5), product(about_z, turn(0.5)));
    let found = tree.frames[1].rotation.iter().flatten();
    for (found, expected) in found.zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-15);
    }
}

#[test]
fn coordinates_are_locked_by_the_names_that_they_are_listed_under() {
    let joints = [
        "joint = [\"theta1\"]\njoint_name = \"hip\"",
        "joint = [\"theta2\"]\njoint_name = \"hip_theta1\"",
        "joint = [\"theta1\"]\njoint_name = \"Hip\"",
    ];
    let plain = changed(joints, &Changes::default()).unwrap();
    assert_eq!(plain.coordinate_names(), ["hip", "hip_theta1", "hip_2"]);
    for (name, left) in [
        ("hip", ["hip_theta1", "hip_2"]),
        ("hip_theta1", ["hip", "hip_2"]),
        ("hip_2", ["hip", "hip_theta1"]),
        ("Hip", ["hip", "hip_theta1"]),
    ] {
        let tree = changed(joints, &lock(name, 0.1)).unwrap();
        assert_eq!(tree.coordinate_names(), left, "{name}");
    }
}

#[test]
fn the_last_free_coordinate_is_locked_by_the_name_that_it_has_then() {
    let hinge = "joint = [\"theta1\"]";
    let sliding = "joint = [\"theta3\", \"s3\"]\njoint_name = \"slide\"";
    let joints = [sliding, hinge, hinge];
    let left = changed(joints, &lock("slide_s3", 0.1)).unwrap();
    assert_eq!(left.coordinate_names()[0], "slide");
    for name in ["slide", "slide_theta3"] {
        let mut changes = lock("slide_s3", 0.1);
        changes.lock.push((name.to_owned(), 0.2));
        let tree = changed(joints, &changes).unwrap();
        assert_eq!(tree.coordinate_names().len(), 2, "{name}");
    }
    // Which of both is meant is not said.
    assert!(changed(joints, &lock("slide", 0.2)).is_err());
}

#[test]
fn a_joint_is_not_both_locked_and_removed() {
    let joints = ["joint = [\"theta1\"]"; 3];
    let changes = Changes {
        remove: vec!["b".to_owned()],
        ..lock("b_theta1", 0.3)
    };
    let faults = changed(joints, &changes).unwrap_err();
    assert!(
        faults.starts_with("error: the joint of body `b` is both locked and removed"),
        "{faults}"
    );
}

#[test]
fn a_joint_that_is_fixed_is_removed_in_vain() {
    let joints = [
        "joint = [\"theta1\"]",
        "joint = \"fixed\"",
        "joint = [\"theta2\"]",
    ];
    let changes = Changes {
        remove: vec!["b".to_owned()],
        ..Changes::default()
    };
    let told = tree::build_with(&chain(joints), &changes)
        .unwrap()
        .warnings
        .to_string();
    assert!(told.contains("is fixed already"), "{told}");
}

#[test]
fn a_quaternion_is_told_to_be_removed_where_it_cannot_be_locked() {
    let hinge = "joint = [\"theta1\"]";
    for joint in ["spherical", "free"] {
        let turning = format!("joint = \"{joint}\"\nchart = \"quaternion\"");
        let faults = changed([&turning, hinge, hinge], &lock("a", 0.1)).unwrap_err();
        let advice = "a quaternion cannot be locked: `--remove a`, or `remove` in `kane.toml`, fixes the joint at zero";
        assert!(faults.contains(advice), "{faults}");
    }
    let faults = changed(
        ["joint = [\"theta1\", \"theta2\"]", hinge, hinge],
        &lock("a", 0.1),
    );
    let faults = faults.unwrap_err();
    assert!(!faults.contains("cannot be locked"), "{faults}");
}
