//! From descriptions to trees: numbers, names, orders, parameters, and what moves mass.

use kane_codegen::id::BodyId;
use kane_codegen::tree::{Coordinate, Tree, Value, canonical};

use kane_test_support::{
    models::{body, build, system},
    random::Random,
};

/// Lower bodies from 1, 0 for the inertial frame.
fn lower_bodies(tree: &Tree) -> Vec<usize> {
    tree.body_ids()
        .map(|body| tree.lower(body).map_or(0, |lower| lower.index() + 1))
        .collect()
}

/// For each body its six coordinates: the place of a free one, `-` for a locked one.
fn coordinates(tree: &Tree) -> Vec<String> {
    let shown = |coordinate: Option<Coordinate>| match coordinate {
        Some(Coordinate::Free { coordinate, speed }) => {
            assert_eq!(coordinate.index(), speed.index());
            format!("{}", coordinate.index())
        }
        Some(Coordinate::Locked(_)) => "-".to_owned(),
        Some(Coordinate::Mimic { coordinate, .. }) => format!("={}", coordinate.index()),
        None => "w".to_owned(),
    };
    let joint = |joint: &kane_codegen::tree::Joint| {
        let coordinates = (0..6).map(|motion| shown(joint.coordinate_of(motion)));
        coordinates.collect::<Vec<_>>().join(" ")
    };
    tree.bodies.iter().map(|body| joint(&body.joint)).collect()
}

#[test]
fn list_that_runs_outward_stays_as_it_is() {
    let names = ["a", "b", "c", "d", "e", "f", "g", "h"].map(|name| (name, "\"free\""));
    let checked = build(&system("[0, 1, 2, 1, 2, 1, 1, 7]", &names)).unwrap();
    assert_eq!(lower_bodies(&checked.tree), [0, 1, 2, 1, 2, 1, 1, 7]);
    assert!(checked.warnings.is_empty(), "{}", checked.warnings);
}

#[test]
fn bodies_are_renumbered_outward_lowest_first() {
    let names = ["foot", "shank", "arm", "trunk", "thigh"].map(|name| (name, "[\"theta1\"]"));
    let checked = build(&system("[2, 5, 4, 0, 4]", &names)).unwrap();
    let order: Vec<_> = checked
        .tree
        .bodies
        .iter()
        .map(|body| (body.name.as_str(), body.user_number))
        .collect();
    assert_eq!(
        order,
        [
            ("trunk", 4),
            ("arm", 3),
            ("thigh", 5),
            ("shank", 2),
            ("foot", 1)
        ]
    );
    assert_eq!(lower_bodies(&checked.tree), [0, 1, 1, 3, 4]);
    insta::assert_snapshot!(checked.warnings, @r#"
    note: the bodies are renumbered outward: body `trunk` from 4 to 1, body `arm` from 3 to 2, body `thigh` from 5 to 3, body `shank` from 2 to 4, body `foot` from 1 to 5
     --> model.toml:2:16
      |
    2 | lower_bodies = [2, 5, 4, 0, 4]
      |                ^^^^^^^^^^^^^^^ every array, loads included, uses the new order
    "#);
}

#[test]
fn bodies_on_a_body_are_listed_in_their_order_past_what_is_fixed_to_it() {
    let hinge = "[\"theta1\"]";
    let bodies = [
        ("trunk", hinge),
        ("plate", "\"fixed\""),
        ("arm", hinge),
        ("leg", hinge),
        ("hand", hinge),
    ];
    let tree = build(&system("[0, 1, 2, 1, 3]", &bodies)).unwrap().tree;
    let uppers = |body: usize| -> Vec<&str> {
        let uppers = tree.uppers(BodyId::new(body)).iter();
        uppers.map(|upper| &*tree.body(*upper).name).collect()
    };
    assert_eq!(uppers(0), ["arm", "leg"]);
    assert_eq!(uppers(1), ["hand"]);
    assert!(uppers(2).is_empty() && uppers(3).is_empty());
}

#[test]
fn several_bodies_may_hang_from_the_inertial_frame() {
    let names = ["a", "b", "c"].map(|name| (name, "[\"theta1\"]"));
    assert_eq!(
        lower_bodies(&build(&system("[3, 0, 0]", &names)).unwrap().tree),
        [0, 0, 2]
    );
}

#[test]
fn any_numbering_of_one_tree_keeps_its_edges() {
    let mut random = Random::new(7);
    for round in 0..50 {
        let n_bodies = 1 + random.below(12);
        let outward: Vec<usize> = (0..n_bodies).map(|body| random.below(body + 1)).collect();
        let mut places: Vec<usize> = (0..n_bodies).collect();
        random.shuffle(&mut places);
        let mut shuffled = vec![0; n_bodies];
        let mut names = vec![String::new(); n_bodies];
        for (body, lower) in outward.iter().enumerate() {
            shuffled[places[body]] = lower.checked_sub(1).map_or(0, |lower| places[lower] + 1);
            names[places[body]] = format!("b{}", body + 1);
        }
        let bodies: Vec<(&str, &str)> = names
            .iter()
            .map(|name| (name.as_str(), "\"free\""))
            .collect();
        let tree = build(&system(&format!("{shuffled:?}"), &bodies))
            .unwrap()
            .tree;
        for body in tree.body_ids() {
            let lower = tree.lower(body);
            assert!(
                lower.is_none_or(|lower| lower < body),
                "round {round}: {shuffled:?}"
            );
            let number: usize = tree.body(body).name[1..].parse().unwrap();
            let expected = outward[number - 1]
                .checked_sub(1)
                .map(|lower| format!("b{}", lower + 1));
            assert_eq!(
                lower.map(|lower| tree.body(lower).name.clone()),
                expected,
                "round {round}: {shuffled:?}"
            );
            assert_eq!(names[tree.body(body).user_number - 1], tree.body(body).name);
        }
    }
}

#[test]
fn body_order_counts_body_after_body() {
    let bodies = [
        ("a", "[\"s2\", \"theta1\"]"),
        ("b", "\"free\""),
        ("c", "[\"theta3\"]"),
    ];
    let tree = build(&system("[0, 1, 2]", &bodies)).unwrap().tree;
    assert_eq!(
        coordinates(&tree),
        ["0 - - - 1 -", "2 3 4 5 6 7", "- - 8 - - -"]
    );
    assert_eq!((tree.n_coordinates, tree.n_speeds), (9, 9));
}

#[test]
fn notes_order_counts_all_angles_first() {
    let bodies = [
        ("a", "[\"s2\", \"theta1\"]"),
        ("b", "\"free\""),
        ("c", "[\"theta3\"]"),
    ];
    let tree = build(&format!(
        "order = \"notes\"\n{}",
        system("[0, 1, 2]", &bodies)
    ))
    .unwrap()
    .tree;
    assert_eq!(
        coordinates(&tree),
        ["0 - - - 5 -", "1 2 3 6 7 8", "- - 4 - - -"]
    );
}

#[test]
fn locked_coordinates_keep_their_values() {
    let text = system("[0]", &[("a", "[\"theta1\"]")]) + "locked = { s3 = -2, theta2 = 0.5 }\n";
    let tree = build(&text).unwrap().tree;
    let joint = &tree.bodies[0].joint;
    let values = [0, 1, 2, 3, 4, 5].map(|motion| match joint.coordinate_of(motion) {
        Some(Coordinate::Locked(value)) => value,
        _ => f64::NAN,
    });
    assert_eq!(values[1..], [0.5, 0.0, 0.0, 0.0, -2.0]);
}

#[test]
fn fixed_bodies_are_part_of_what_they_are_fixed_to() {
    let text = system(
        "[0, 1, 2, 0]",
        &[
            ("a", "[\"theta1\"]"),
            ("b", "[]"),
            ("c", "[\"s2\"]"),
            ("ground", "[]"),
        ],
    );
    let checked = build(&text).unwrap();
    let tree = &checked.tree;
    assert_eq!(coordinates(tree), ["0 - - - - -", "- - - - 1 -"]);
    assert_eq!(lower_bodies(tree), [0, 1]);
    assert_eq!(tree.bodies[0].parts.len(), 2);
    let frames: Vec<_> = tree
        .frames
        .iter()
        .map(|frame| (frame.name.as_str(), frame.body.map(BodyId::index)))
        .collect();
    assert_eq!(frames, [("b", Some(0)), ("ground", None)]);
    assert_eq!(
        checked.warnings.list()[0].message,
        "bodies that are fixed are part of what they are fixed to: `b` of `a`, `ground` of the inertial frame"
    );
}

#[test]
fn parameters_are_gravity_then_body_by_body_in_the_new_order() {
    let tip = body("Tip", "[\"theta1\"]")
        .replace("mass = 2.0", "mass = { runtime = 2 }")
        .replace("0.1, 0.3", "{ runtime = 0.25 }, 0.3");
    let base = body("base", "[\"theta1\"]")
        .replace("xy = 0.01", "xy = { runtime = 0.0 }")
        .replace("-0.5", "{ runtime = -0.5 }");
    let text = format!(
        "name = \"s\"\ngravity = [0, 0, {{ runtime = -9.81 }}]\nlower_bodies = [2, 0]\n{tip}{base}"
    );
    let tree = build(&text).unwrap().tree;
    let parameters: Vec<_> = tree
        .parameters
        .iter()
        .map(|parameter| {
            (
                parameter.name.as_str(),
                parameter.body.map(BodyId::index),
                parameter.nominal,
                parameter.unit,
            )
        })
        .collect();
    let expected = [
        ("gravity_z", None, -9.81, "m/s^2"),
        ("base_mass_center_z", Some(0), -0.5, "m"),
        ("base_inertia_xy", Some(0), 0.0, "kg m^2"),
        ("tip_mass", Some(1), 2.0, "kg"),
        ("tip_attachment_y", Some(1), 0.25, "m"),
    ];
    assert_eq!(parameters, expected);
    assert!(
        matches!(tree.bodies[1].parts[0].mass, Value::Runtime(parameter) if parameter.index() == 3)
    );
}

#[test]
fn names_become_identifiers() {
    let names = [
        "LeftHand",
        "IMUMount",
        "type",
        "7th",
        "Körper",
        "天宫",
        "a--b",
        "_x_",
        "plain_name",
        "Plain Name",
        "plain_name_2",
        "a  b",
    ];
    let bodies = names.map(|name| (name, "[\"theta1\"]"));
    let lower: Vec<usize> = (0..names.len()).collect();
    let checked = build(&system(&format!("{lower:?}"), &bodies)).unwrap();
    let identifiers: Vec<_> = checked
        .tree
        .bodies
        .iter()
        .map(|body| body.identifier.as_str())
        .collect();
    let expected = [
        "left_hand",
        "imu_mount",
        "body_type",
        "body_7th",
        "k_rper",
        "body",
        "a_b",
        "x",
        "plain_name",
        "plain_name_3",
        "plain_name_2",
        "a_b_2",
    ];
    assert_eq!(identifiers, expected);
    assert_eq!(checked.tree.bodies[0].name, "LeftHand");
}

#[test]
fn every_name_is_mapped_to_an_identifier_of_its_own() {
    let alphabet = ['a', 'B', '_', '2', ' ', 'é', '-', 'x'];
    let mut random = Random::new(3);
    let mut names: Vec<String> = Vec::new();
    while names.len() < 300 {
        let name: String = (0..=random.below(4))
            .map(|_| alphabet[random.below(alphabet.len())])
            .collect();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let bodies: Vec<(&str, &str)> = names
        .iter()
        .map(|name| (name.as_str(), "[\"theta1\"]"))
        .collect();
    let tree = build(&system(&format!("{:?}", vec![0; names.len()]), &bodies))
        .unwrap()
        .tree;
    let mut identifiers: Vec<&str> = tree
        .bodies
        .iter()
        .map(|body| body.identifier.as_str())
        .collect();
    for identifier in &identifiers {
        assert!(
            identifier.starts_with(|c: char| c.is_ascii_lowercase()),
            "{identifier}"
        );
        assert!(
            identifier
                .chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'),
            "{identifier}"
        );
    }
    identifiers.sort_unstable();
    identifiers.dedup();
    assert_eq!(identifiers.len(), names.len());
}

#[test]
fn changed_names_and_numbers_are_notes() {
    let bodies = [("Tip", "[\"theta1\"]"), ("base", "[\"theta1\"]")];
    insta::assert_snapshot!(build(&system("[2, 0]", &bodies)).unwrap().warnings, @r#"
    note: the bodies are renumbered outward: body `base` from 2 to 1, body `Tip` from 1 to 2
     --> model.toml:2:16
      |
    2 | lower_bodies = [2, 0]
      |                ^^^^^^ every array, loads included, uses the new order

    note: body `Tip` is called `tip` in generated code
     --> model.toml:5:8
      |
    5 | name = "Tip"
      |        ^^^^^ no lower snake case identifier of its own
    "#);
}

#[test]
fn joint_that_moves_and_is_called_otherwise_is_told() {
    let bodies = [
        ("one", "[\"theta1\"]"),
        ("two", "\"fixed\""),
        ("three", "[\"s1\"]"),
    ];
    let mut text = system("[0, 1, 2]", &bodies);
    for (body, joint) in [("one", "J"), ("two", "K"), ("three", "j")] {
        let name = format!("name = \"{body}\"\n");
        text = text.replace(&name, &format!("{name}joint_name = \"{joint}\"\n"));
    }
    let notes = build(&text).unwrap().warnings.to_string();
    let told = |joint: &str| notes.contains(&format!("note: joint `{joint}` is called"));
    assert_eq!(["J", "K", "j"].map(told), [true, false, false]);
    assert!(notes.contains("joint `J` is called `j_2` in generated code"));
}

#[test]
fn frames_that_are_identifiers_keep_their_names_wherever_they_stand() {
    let frame = |name: &str| format!("\n[[frame]]\nname = \"{name}\"\nbody = \"arm\"\n");
    let frames = ["grip-L", "o'brien", "grip_l"].map(frame).concat();
    let text = system("[0]", &[("arm", "[\"theta1\"]")]) + &frames;
    let built = build(&text).unwrap();
    let identifiers = built.tree.markers.iter();
    let identifiers: Vec<&str> = identifiers.map(|one| one.identifier.as_str()).collect();
    assert_eq!(identifiers, ["grip_l_2", "o_brien", "grip_l"]);
    let notes = built.warnings.to_string();
    for note in [
        "frame `grip-L` is called `grip_l_2`",
        "frame `o'brien` is called `o_brien`",
    ] {
        assert!(notes.contains(note), "{notes}");
    }
}

#[test]
fn thousands_of_bodies_are_numbered() {
    let n_bodies = 3000;
    let names: Vec<String> = (0..n_bodies).map(|body| format!("b{body}")).collect();
    let bodies: Vec<(&str, &str)> = names
        .iter()
        .map(|name| (name.as_str(), "\"free\""))
        .collect();
    let chain: Vec<usize> = (0..n_bodies).collect();
    assert_eq!(
        build(&system(&format!("{chain:?}"), &bodies))
            .unwrap()
            .tree
            .n_speeds,
        6 * n_bodies
    );
}

#[test]
fn canonical_text_holds_every_value() {
    let text = system(
        "[2, 0]",
        &[("Tip", "[\"theta1\"]"), ("base", "[\"s1\", \"theta3\"]")],
    );
    let text =
        text.replace("mass = 2.0", "mass = { runtime = 2.5e0 }") + "locked = { theta1 = 5e-1 }\n";
    insta::assert_snapshot!(canonical(&build(&text).unwrap().tree), @r#"
    system "system" order body
    gravity 0.0 0.0 0.0
    parameter base_mass 2.5
    parameter tip_mass 2.5
    body 1 on 0 "base" as base
    mass runtime 2.5
    mass_center 0.01 0.02 -0.5
    inertia 0.1 0.1 0.02 0.01 0.0 0.0
    pose
    joint "base" body's as base 0.0 0.1 0.3
    coordinates 0.5 0.0 q0 u0 q1 u1 0.0 0.0
    body 2 on 1 "Tip" as tip
    mass runtime 2.5
    mass_center 0.01 0.02 -0.5
    inertia 0.1 0.1 0.02 0.01 0.0 0.0
    pose
    joint "Tip" body's as tip 0.0 0.1 0.3
    coordinates q2 u2 0.0 0.0 0.0 0.0 0.0
    "#);
}
