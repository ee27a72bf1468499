//! What branches share in one text, as a reader meets it.

use std::collections::BTreeMap;

use kane_codegen::{
    description::{Base, Reading},
    diagnostic::Source,
    options::Options,
};

use crate::module::{generate, named};

const ROBOT: &str = include_str!("../../../tests/robots/solo12/solo12.urdf");

fn module(text: &str, function: &str) -> String {
    let options = Options {
        functions: named(&[function]),
        reading: Reading {
            base: Some(Base::Free),
            ..Reading::default()
        },
        ..Options::default()
    };
    let source = Source::new("solo12.urdf", text);
    let generated = generate(&source, "solo12.urdf", &options);
    generated.expect("a right model").source
}

#[test]
fn what_a_helper_is_given_has_the_names_of_the_first_branch() {
    let text = module(ROBOT, "inverse_dynamics+vjp(inverse_dynamics; q, u)");
    for name in [
        "fl_shoulder_cos1",
        "fl_upper_leg_sin2",
        "fl_haa_dot",
        "fl_haa_ddot",
        "fl_upper_leg_a_at_joint_x",
    ] {
        let is_given = |line: &str| line.trim().starts_with(&format!("let {name} = sides["));
        assert!(text.lines().any(is_given), "{name}");
    }
    let is_shared = |line: &str| line.trim().starts_with("let root_joint_w2_dot = shared[");
    assert!(text.lines().any(is_shared));
    // What has none is counted body by body.
    let first = [
        "fl_shoulder_side1",
        "fl_upper_leg_side1",
        "fl_shoulder_shared1",
    ];
    assert!(first.iter().all(|name| text.contains(name)));
}

/// How many lines are new.
fn n_new(old: &str, new: &str) -> usize {
    let mut known: BTreeMap<&str, usize> = BTreeMap::new();
    for line in old.lines() {
        *known.entry(line).or_default() += 1;
    }
    let mut n_new = 0;
    for line in new.lines() {
        match known.get_mut(line) {
            Some(count @ 1..) => *count -= 1,
            _ => n_new += 1,
        }
    }
    n_new
}

/// Two legs have this moment of inertia, two have another: one more number goes to the helper.
#[test]
fn a_number_in_which_legs_come_to_differ_changes_few_lines() {
    let changed = ROBOT.replacen("0.00041107", "0.00041108", 1);
    assert_ne!(ROBOT, changed);
    for (function, most) in [
        ("mass_matrix_inverse", 60),
        ("vjp(inverse_dynamics; q, u)", 110),
        ("d(forward_dynamics)/d(q, u, tau)", 110),
    ] {
        let [old, new] = [ROBOT, &changed].map(|text| module(text, function));
        let n_new = n_new(&old, &new);
        assert!((1..=most).contains(&n_new), "{function}: {n_new}");
    }
}
