//! The inverse of the mass matrix of trees whose roots float, by every way that it can be derived.

use std::fmt::Write as _;

use kane_codegen::{
    functions::{Formulation, Request},
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    dynamics::State,
    models,
    random::Random,
    rotation,
    systems::trees,
};

use crate::frames::evaluate_by;

/// Joints of one motion for the most part, some with rotors; every second body is on the one before it, so that branches are on
/// roots, on what is next to them and farther out. Two roots float, one as the seed says.
fn floating(seed: u64) -> Tree {
    let mut random = Random::new(seed);
    let n_bodies = 4 + random.below(9);
    let mut lower = vec![0];
    for body in 1..n_bodies {
        let before = if random.chance(0.5) {
            body
        } else {
            1 + random.below(body)
        };
        lower.push(if body == 2 { 0 } else { before });
    }
    let mut text =
        format!("name = \"floating\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = {lower:?}\n");
    let charts = [
        "joint = \"free\"\nchart = \"quaternion\"",
        "joint = \"free\"\nspeeds = \"angular_velocity\"",
        "joint = \"free\"",
    ];
    let joints = [
        "joint = [\"theta1\"]",
        "joint = [\"theta3\"]\narmature = 0.03",
        "joint = [\"theta2\"]",
        "joint = [\"s2\"]",
        "joint = [\"s3\"]\narmature = 0.2",
        "joint = [\"theta1\", \"theta2\"]",
        "joint = [\"theta3\"]",
    ];
    for (body, lower) in lower.iter().enumerate() {
        let joint = match (body, lower) {
            (0, _) => charts[usize::try_from(seed % 3).expect("less than 3")],
            (_, 0) => charts[random.below(2)],
            _ => joints[random.below(joints.len())],
        };
        let [a, b, c, d] = [0; 4].map(|_| random.written(0.1, 0.3));
        // Half of the axes along those of the lower body, and half of the joints' centres on its first axis.
        let turned = random.chance(0.5);
        let attachment = if random.chance(0.5) {
            [a, -b, c]
        } else {
            [a, 0.0, 0.0]
        };
        write!(
            text,
            "\n[[body]]\nname = \"b{body}\"\nmass = {:?}\nmass_center = [{a}, {b}, {c}]\n\
             inertia = {{ xx = {:?}, yy = {:?}, zz = {:?}, xy = 0.01, xz = 0.02, yz = 0.03 }}\n\
             attachment = {attachment:?}\n{joint}\n",
            1.0 + a,
            a + 0.3,
            b + 0.3,
            c + 0.3,
        )
        .expect("a String takes any text");
        if turned {
            let rotation = rotation::angles_123([a, b, d]);
            writeln!(text, "attachment_rotation = {rotation:?}").expect("a String takes any text");
        }
    }
    let built = models::build(&text);
    built.expect("a right description").tree
}

/// True where carriers change how the inverse is derived.
fn has_carriers(tree: &Tree, request: &Request) -> bool {
    let [with, without] = [true, false].map(|is_used| {
        let plan = Plan::full(tree).with(Technique::Carriers, is_used);
        let derived = request.derive(tree, Formulation::Recursive, &plan);
        derived.graph.len()
    });
    with != without
}

/// Of random trees, with each of the techniques by which ways differ used and left out.
#[test]
fn the_inverse_of_a_floating_tree_is_that_of_the_notes_by_every_way() {
    let request = Request::parse("mass_matrix_inverse").expect("the catalogue has it");
    let ways = [
        Technique::Articulated,
        Technique::Carriers,
        Technique::LinkAxes,
        Technique::Slide,
    ];
    let mut n_with_carriers = 0;
    for seed in trees::tried(1..=60) {
        let tree = floating(seed);
        let state = State::random(&tree, seed);
        n_with_carriers += usize::from(has_carriers(&tree, &request));
        let values =
            |formulation, plan: &Plan| evaluate_by(&tree, &request, formulation, plan, &state);
        let expected = values(Formulation::Notes, &Plan::plain(&tree));
        for choice in 0..1 << ways.len() {
            let used = |plan: Plan, (place, way): (usize, &Technique)| {
                plan.with(*way, choice & (1 << place) != 0)
            };
            let plan = ways.iter().enumerate().fold(Plan::full(&tree), used);
            let found = values(Formulation::Recursive, &plan);
            let what = format!("seed {seed}, choice {choice}");
            // A hundred roundings of sums, and a condition below ten thousand.
            assert_close(what, &found, &expected, Tolerance::relative(1e-10));
        }
    }
    assert!(n_with_carriers > 5, "{n_with_carriers} trees have carriers");
}
