//! Derivatives of dynamics against differences at 60 digits.
//!
//! `tests/reference/NAME.derivatives.json` holds, at states without loads, how `tau` and `u_dot` change with coordinates, speeds
//! and forces, by central differences with a step of 1e-20 of the notes' equations in the order of the notes: all angles, then
//! all translations.

use std::{collections::BTreeMap, fs};

use kane_codegen::{
    description::toml,
    diagnostic::Source,
    expr::Input,
    functions::{Argument, Formulation},
    recursive::{Plan, Technique},
    tree::{self, Tree},
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    json::flat,
    numeric::{Matrix, condition},
};
use serde_json::Value;

use crate::frames::request;

/// Relative to the largest entry of a matrix, of sums of some hundred terms; of solutions, times a ten-thousandth of the
/// condition number of the mass matrix where that is more.
const DIGITS: f64 = 1e-12;

/// All derivatives of inverse dynamics.
pub(crate) const INVERSE: &str = "d(inverse_dynamics)/d(q, u, u_dot)";
/// All derivatives of forward dynamics.
pub(crate) const FORWARD: &str = "d(forward_dynamics)/d(q, u, tau)";

/// A state.
pub(crate) type Inputs = BTreeMap<Input, f64>;

/// By composite bodies, as is emitted, and by a sweep.
fn plans(tree: &Tree) -> [Plan; 2] {
    let composite = Plan::full(tree);
    [
        composite.with(Technique::DirectDerivatives, false),
        composite,
    ]
}

/// The matrices that a function writes, by rows.
pub(crate) fn matrices(tree: &Tree, text: &str, plan: &Plan, inputs: &Inputs) -> [Vec<f64>; 3] {
    let derived = request(tree, text).derive(tree, Formulation::Recursive, plan);
    let values = derived
        .graph
        .evaluate(&derived.roots, |given| inputs[&given]);
    let size = tree.n_speeds * tree.n_speeds;
    assert_eq!(values.len(), 3 * size);
    [0, 1, 2].map(|place| values[place * size..][..size].to_vec())
}

/// The tolerance of what is solved with this mass matrix.
pub(crate) fn scaled(tolerance: f64, tree: &Tree, mass_matrix: Vec<f64>) -> f64 {
    let condition = condition(&Matrix::new(tree.n_speeds, mass_matrix));
    tolerance * larger(condition / 1e4, 1.0)
}

/// Compares with the largest entry of `expected`.
pub(crate) fn check(what: &str, tolerance: f64, found: &[f64], expected: &[f64]) {
    let error = relative_to(larger(largest(expected), 1e-300), found, expected);
    assert_within(what, error, tolerance);
}

fn notes(name: &str, model: &str) {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let read = |path: &str| fs::read_to_string(format!("{root}/{path}")).expect("it is there");
    let tree = tree::build(&toml::parse(&Source::new(model, read(model))))
        .expect("a right description")
        .tree;
    let text = read(&format!("tests/reference/{name}.derivatives.json"));
    let reference: Value = serde_json::from_str(&text).expect("it is JSON");
    let cases = reference["cases"].as_array().expect("it lists cases");
    assert!(!cases.is_empty());
    for case in cases {
        let (state, given, expect) = (&case["state"], &case["given"], &case["expect"]);
        let both = |a: &str, b: &str| [flat(&state[a]), flat(&state[b])].concat();
        let mut inputs = Inputs::new();
        inputs.extend(Argument::Q.inputs(&tree).zip(both("theta", "s")));
        inputs.extend(Argument::U.inputs(&tree).zip(both("theta_dot", "s_dot")));
        inputs.extend(Argument::UDot.inputs(&tree).zip(flat(&given["u_dot"])));
        inputs.extend(Argument::Tau.inputs(&tree).zip(flat(&given["tau"])));
        for plan in plans(&tree) {
            let [by_q, by_u, mass_matrix] = matrices(&tree, INVERSE, &plan, &inputs);
            check(name, DIGITS, &by_q, &flat(&expect["dtau_dq"]));
            check(name, DIGITS, &by_u, &flat(&expect["dtau_du"]));
            let solved = scaled(DIGITS, &tree, mass_matrix);
            let [by_q, by_u, by_tau] = matrices(&tree, FORWARD, &plan, &inputs);
            check(name, solved, &by_q, &flat(&expect["du_dot_dq"]));
            check(name, solved, &by_u, &flat(&expect["du_dot_du"]));
            check(name, solved, &by_tau, &flat(&expect["du_dot_dtau"]));
        }
    }
}

#[test]
fn a_body_changes_as_at_60_digits() {
    notes("one_body", "tests/reference/one_body.toml");
}

#[test]
fn a_chain_changes_as_at_60_digits() {
    notes("chain3", "tests/reference/chain3.toml");
}

#[test]
fn a_star_changes_as_at_60_digits() {
    notes("star5", "tests/reference/star5.toml");
}

#[test]
fn two_trees_change_as_at_60_digits() {
    notes("two_roots", "tests/reference/two_roots.toml");
}

#[test]
fn eight_bodies_change_as_at_60_digits() {
    notes("eight_body", "models/eight_body.toml");
}
