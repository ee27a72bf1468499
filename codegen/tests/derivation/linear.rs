//! Functions of frames' origins beside those of the whole frames.

use std::collections::BTreeSet;

use kane_codegen::{
    description::{Base, Reading},
    functions::Formulation,
    recursive::Technique,
    report,
    tree::Tree,
};
use kane_test_support::{
    compare::assert_within,
    dynamics::{State, state::FRAME_FORCE},
};

use crate::{
    compiled::read,
    frames::{EXACT, INVERTED, evaluate, names, relative, request, seeds, system},
    pages,
};

/// Without what is angular, with the places of these entries in the whole.
const HALVES: [(&str, &str, &[&str]); 6] = [
    ("position", "pose", &["", ", stand"]),
    ("linear_velocity", "velocity", &["", ", local"]),
    ("linear_acceleration", "acceleration", &["", ", local"]),
    ("linear_jacobian", "jacobian", &["", ", local", ", stand"]),
    (
        "linear_jacobian_packed",
        "jacobian_packed",
        &["", ", local", ", stand"],
    ),
    ("linear_jacobian_dot_u", "jacobian_dot_u", &["", ", local"]),
];

fn by(tree: &Tree, state: &State, text: &str, formulation: Formulation) -> Vec<f64> {
    evaluate(tree, &request(tree, text), formulation, state)
}

fn each_frame(check: impl Fn(&str, &Tree, &State, &str)) {
    for seed in seeds() {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for name in names(&tree) {
            check(&format!("{seed}, {name}"), &tree, &state, &name);
        }
    }
}

#[test]
fn they_are_the_linear_part_of_the_whole() {
    each_frame(|what, tree, state, name| {
        for (half, whole, views) in HALVES {
            for view in views {
                let text = format!("{half}({name}{view})");
                let found = by(tree, state, &text, Formulation::Recursive);
                let whole = by(
                    tree,
                    state,
                    &format!("{whole}({name}{view})"),
                    Formulation::Notes,
                );
                let expected = match half {
                    "position" => &whole[9..],
                    _ => &whole[..whole.len() / 2],
                };
                assert_eq!(found.len(), expected.len(), "{what}, {text}");
                assert_within(format!("{what}, {text}"), relative(&found, expected), EXACT);
            }
        }
    });
}

#[test]
fn forces_are_the_transposed_jacobian_s() {
    each_frame(|what, tree, state, name| {
        for own in ["", ", local"] {
            let jacobian = format!("linear_jacobian({name}{own})");
            let jacobian = by(tree, state, &jacobian, Formulation::Notes);
            let n = tree.n_speeds;
            let column = |speed| {
                (0..3)
                    .map(|row| jacobian[row * n + speed] * FRAME_FORCE[row])
                    .sum()
            };
            let expected: Vec<f64> = (0..n).map(column).collect();
            let text = format!("linear_generalized_force({name}{own})");
            let found = by(tree, state, &text, Formulation::Recursive);
            assert_within(format!("{what}{own}"), relative(&found, &expected), EXACT);
        }
    });
}

#[test]
fn inverse_inertias_are_blocks_of_the_whole() {
    each_frame(|what, tree, state, name| {
        for (rest, n) in [("", 1), (", local", 1), (", \"stand\", \"marker one\"", 3)] {
            // No frame may stand there twice.
            let again = format!(", {name}");
            let n = n - rest.matches(&again).count();
            let rest = rest.replace(&again, "");
            let whole = format!("operational_inverse_inertia({name}{rest})");
            let whole = by(tree, state, &whole, Formulation::Notes);
            let linear = (0..6 * n).filter(|row| row % 6 < 3);
            let entries = linear
                .clone()
                .flat_map(|i| linear.clone().map(move |j| (i, j)));
            let expected: Vec<f64> = entries.map(|(i, j)| whole[6 * n * i + j]).collect();
            let text = format!("linear_operational_inverse_inertia({name}{rest})");
            let found = by(tree, state, &text, Formulation::Recursive);
            let error = relative(&found, &expected);
            assert_within(format!("{what}, {text}"), error, INVERTED);
        }
    });
}

/// The operations of requests, each in the cheapest way.
fn counts(tree: &Tree, texts: &[String]) -> Vec<usize> {
    counts_without(tree, texts, &BTreeSet::new())
}

fn counts_without(tree: &Tree, texts: &[String], without: &BTreeSet<Technique>) -> Vec<usize> {
    let requests: Vec<_> = texts.iter().map(|text| request(tree, text)).collect();
    let counts = report::count(tree, &requests, without).into_iter();
    let least = counts.map(|counts| {
        let counts = counts.formulations.iter();
        counts.map(|(_, operations)| operations.total()).min()
    });
    least.map(Option::unwrap).collect()
}

#[test]
fn they_take_no_more_operations_than_the_whole() {
    for seed in seeds() {
        let (_, tree) = system(seed);
        let name = names(&tree).pop().unwrap();
        let pairs = HALVES.iter().flat_map(|(half, whole, views)| {
            views
                .iter()
                .map(move |view| [*half, *whole].map(|own| (own, *view)))
        });
        for pair in pairs {
            let texts = pair.map(|(function, view)| format!("{function}({name}{view})"));
            let [half, whole] = counts(&tree, &texts)[..] else {
                unreachable!("{texts:?}")
            };
            assert!(half <= whole, "{seed}: {texts:?}: {half} of {whole}");
        }
    }
}

fn solo12() -> Tree {
    let free = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    read("tests/robots/solo12/solo12.urdf", &free)
}

#[test]
fn the_page_of_techniques_has_the_count_of_a_jacobian_by_steps() {
    let jacobian = ["jacobian(FL_FOOT)".to_owned()];
    let [with] = counts(&solo12(), &jacobian)[..] else {
        unreachable!()
    };
    let others = BTreeSet::from([Technique::Inward, Technique::Levers]);
    let [steps] = counts_without(&solo12(), &jacobian, &others)[..] else {
        unreachable!()
    };
    pages::performance().says(&format!(
        "the Jacobian of solo12's foot takes {steps} operations instead of {with}."
    ));
}

#[test]
fn the_page_of_functions_has_their_counts() {
    let panda = read("tests/robots/panda/panda.urdf", &Reading::default());
    let solo12 = solo12();
    let of_hand = ["pose", "position"].map(|own| format!("{own}(panda_hand_tcp)"));
    let [pose, position] = counts(&panda, &of_hand)[..] else {
        unreachable!()
    };
    let feet = "(FL_FOOT, FR_FOOT, HL_FOOT, HR_FOOT)";
    let of_feet = ["", "linear_"].map(|own| format!("{own}operational_inverse_inertia{feet}"));
    let [whole, linear] = counts(&solo12, &of_feet)[..] else {
        unreachable!()
    };
    let page = pages::functions();
    page.says(&format!(
        "The position of a Panda's hand takes {position} operations, its pose {pose}."
    ));
    page.says(&format!(
        "Of the four feet of solo12, the linear inverse inertia takes {linear}, the whole {whole}."
    ));
}
