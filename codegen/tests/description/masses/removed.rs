//! Motions that move no mass, held where that is asked for.

use kane_codegen::{
    description::{Reading, toml, urdf},
    diagnostic::{Diagnostics, Source},
    tree::{Changes, Checked, build_with},
};
use kane_test_support::random::Random;

use crate::mobility::mass_matrix::MassMatrices;

fn changes() -> Changes {
    Changes {
        remove_massless: true,
        ..Changes::default()
    }
}

fn build(text: &str) -> Result<Checked, Diagnostics> {
    build_with(&toml::parse(&Source::new("model.toml", text)), &changes())
}

fn body(name: &str, mass: &str, center: &str, moments: [&str; 3], joint: &str) -> String {
    let [xx, yy, zz] = moments;
    format!(
        "[[body]]\nname = \"{name}\"\nmass = {mass}\nmass_center = {center}\nattachment = [0.1, 0.2, 0.3]\n\
         inertia = {{ xx = {xx}, yy = {yy}, zz = {zz}, xy = 0.0, xz = 0.0, yz = 0.0 }}\n{joint}\n"
    )
}

fn system(lower: &str, bodies: &[String]) -> String {
    format!("name = \"s\"\nlower_bodies = {lower}\n{}", bodies.concat())
}

/// What was said of motions that were held.
fn told(checked: &Checked) -> Vec<&str> {
    let messages = checked.warnings.list().iter();
    let messages = messages.map(|finding| finding.message.as_str());
    messages
        .filter(|message| message.starts_with("held at zero"))
        .collect()
}

const BALL: [&str; 3] = ["0.1"; 3];
const NONE: [&str; 3] = ["0.0"; 3];

#[test]
fn massless_tips_are_held_one_after_another_and_told_on_one_line() {
    let center = "[0.0, 0.0, 0.0]";
    let text = system(
        "[0, 1, 2]",
        &[
            body("arm", "1.0", center, BALL, "joint = [\"theta1\"]"),
            body(
                "wrist",
                "0.0",
                center,
                NONE,
                "joint = [\"theta2\"]\njoint_name = \"turn\"",
            ),
            body("tip", "0.0", center, NONE, "joint = [\"s1\", \"theta3\"]"),
        ],
    );
    let checked = build(&text).unwrap();
    assert_eq!(checked.tree.n_speeds, 1);
    assert_eq!(
        told(&checked),
        ["held at zero, for it moves no mass: `turn`, `theta3`, `s1` of body `tip`"]
    );
}

#[test]
fn a_leader_that_moves_no_mass_is_held_with_all_that_follow_it() {
    let center = "[0.0, 0.0, 0.0]";
    let follower =
        "joint = [\"theta2\"]\nmimic = { joint = \"left\", multiplier = 2.0, offset = 0.25 }";
    let text = system(
        "[0, 1, 1]",
        &[
            body("arm", "1.0", center, BALL, "joint = [\"theta1\"]"),
            body("left", "0.0", center, NONE, "joint = [\"theta2\"]"),
            body("right", "0.0", center, NONE, follower),
        ],
    );
    let tree = build(&text).unwrap().tree;
    assert_eq!((tree.n_speeds, tree.bodies.len()), (1, 1));
    // Held at zero means 0.25 for what follows with an offset.
    let right = tree
        .frames
        .iter()
        .find(|frame| frame.name == "right")
        .unwrap();
    let cosine = right.pose.rotation[0][0];
    assert!((cosine - libm::cos(0.25)).abs() < 1e-15, "{cosine}");
}

#[test]
fn a_mass_that_is_set_at_run_time_keeps_its_motion() {
    let of_tip = |mass: &str, center: &str| {
        let tip = body("tip", mass, center, NONE, "joint = [\"theta1\"]");
        let arm = body(
            "arm",
            "1.0",
            "[0.0, 0.0, 0.0]",
            BALL,
            "joint = [\"theta2\"]",
        );
        build(&system("[0, 1]", &[arm, tip])).map(|checked| checked.tree.n_speeds)
    };
    // With some mass it moves: the fault stays, and says nothing of the option that was taken.
    let faults = of_tip("{ runtime = 0.0 }", "[0.0, 0.1, 0.0]").unwrap_err();
    assert!(
        faults
            .to_string()
            .starts_with("error: `theta1` of body `tip` moves no mass"),
        "{faults}"
    );
    assert!(
        !faults.to_string().contains("--remove-massless"),
        "{faults}"
    );
    assert_eq!(of_tip("{ runtime = 1.0 }", "[0.0, 0.1, 0.0]").unwrap(), 2);
    // On its axis it moves none, whatever the mass.
    assert_eq!(of_tip("{ runtime = 1.0 }", "[0.1, 0.0, 0.0]").unwrap(), 1);
    // And off its axis it may be set at run time, too.
    let faults = of_tip("1.0", "[0.1, { runtime = 0.0 }, 0.0]").unwrap_err();
    assert!(faults.to_string().contains("moves no mass"), "{faults}");
}

#[test]
fn all_angles_of_a_quaternion_are_held_together_or_not_at_all() {
    let free = "joint = \"free\"\nchart = \"quaternion\"";
    let arm = body(
        "arm",
        "1.0",
        "[0.0, 0.0, 0.0]",
        BALL,
        "joint = [\"theta1\"]",
    );
    let point = body("point", "1.0", "[0.0, 0.0, 0.0]", NONE, free);
    let checked = build(&system("[0, 1]", &[arm.clone(), point])).unwrap();
    assert_eq!(checked.tree.n_speeds, 4);
    let rod = body("rod", "1.0", "[0.0, 0.0, 0.0]", ["0.1", "0.1", "0.0"], free);
    let faults = build(&system("[0, 1]", &[arm, rod])).unwrap_err();
    assert!(faults.to_string().contains("moves no mass"), "{faults}");
}

#[test]
fn what_is_left_of_random_trees_has_a_mass_matrix_of_full_rank() {
    let mut random = Random::new(7);
    let mut pick = |list: &[&'static str]| {
        let place = random.bits() % u64::try_from(list.len()).unwrap();
        list[usize::try_from(place).unwrap()]
    };
    let (mut n_built, mut n_held) = (0, 0);
    for _ in 0..150 {
        let n_bodies: usize = pick(&["2", "3", "4", "5"]).parse().unwrap();
        let mut lower = vec!["0"];
        let mut bodies = Vec::new();
        for index in 0..n_bodies {
            if index > 0 {
                lower.push(pick(&["0", "1", "2", "3", "4"][..=index]));
            }
            let mass = pick(&["0.0", "0.0", "1.5"]);
            let center = pick(&["[0.0, 0.0, 0.0]", "[0.0, 0.0, 0.4]", "[0.1, 0.2, 0.3]"]);
            let rod = ["0.1", "0.1", "0.0"];
            let moments = match pick(&["none", "none", "rod", "ball"]) {
                "none" => NONE,
                "rod" => rod,
                _ => BALL,
            };
            let joint = pick(&[
                "joint = [\"theta1\"]",
                "joint = [\"theta3\"]",
                "joint = [\"s2\"]",
                "joint = [\"theta2\", \"s1\"]",
                "joint = [\"theta1\", \"theta2\", \"theta3\"]",
            ]);
            bodies.push(body(&format!("b{index}"), mass, center, moments, joint));
        }
        let text = system(&format!("[{}]", lower.join(", ")), &bodies);
        match build(&text) {
            Ok(checked) => {
                n_built += 1;
                n_held += told(&checked).len();
                let rank = MassMatrices::of(&checked.tree, 1).rank();
                assert_eq!(rank, checked.tree.n_speeds, "{text}");
            }
            Err(faults) => {
                let none = ["nothing that moves has", "no body has a free coordinate"];
                let message = &faults.list()[0].message;
                assert!(
                    none.iter().any(|none| message.starts_with(none)),
                    "{text}\n{faults}"
                );
            }
        }
    }
    assert!(
        n_built > 100 && n_held > 50,
        "{n_built} built, {n_held} with motions held"
    );
}

#[test]
fn a_robot_without_mass_keeps_its_message() {
    let text = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\
                <joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>";
    let description = urdf::parse(&Source::new("r.urdf", text), &Reading::default());
    let faults = build_with(&description, &changes()).unwrap_err();
    assert_eq!(faults.list().len(), 1, "{faults}");
    assert!(
        faults.list()[0]
            .message
            .starts_with("nothing that moves has a mass")
    );
}
