//! Products with derivatives, against all derivatives.

use std::collections::BTreeMap;

use kane_codegen::{
    expr::Input,
    functions::{Argument, Formulation, Function, Of, Request},
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{compare::assert_within, dynamics::State, numeric::dot, systems::trees};

use crate::{
    derivatives::{EXACT, INVERTED, inverts, jumps, n_entries, values, variables, ways},
    evaluator::product,
    frames::{evaluate_by, names, relative, request, system},
};

/// The numbers that a direction or multiplier holds here.
fn given(tree: &Tree, argument: Argument) -> Vec<f64> {
    let inputs = argument.inputs(tree);
    let numbers = inputs.map(|input| match input {
        Input::Product(of, place) => product(of, place),
        other => unreachable!("{other:?} is of no product"),
    });
    numbers.collect()
}

/// All multipliers that a request is given, one after the other.
pub(crate) fn weights(tree: &Tree, request: &Request) -> Vec<f64> {
    let arguments = request.arguments().into_iter();
    let own = arguments.filter(|argument| matches!(argument, Argument::Multiplier(_)));
    own.flat_map(|argument| given(tree, argument)).collect()
}

/// A function, and variables with their directions.
type Case = (&'static str, &'static [&'static str], &'static [Argument]);

const PRODUCTS: [Case; 5] = [
    (
        "loaded_inverse_dynamics",
        &["u_dot", "q", "loads"],
        &[
            Argument::UDotDirection,
            Argument::QDirection,
            Argument::LoadsDirection,
        ],
    ),
    (
        "forward_dynamics",
        &["tau", "u", "parameters"],
        &[
            Argument::TauDirection,
            Argument::UDirection,
            Argument::ParametersDirection,
        ],
    ),
    ("mass_matrix", &["q"], &[Argument::QDirection]),
    ("center_of_mass", &["q"], &[Argument::QDirection]),
    (
        "q_dot",
        &["u", "q"],
        &[Argument::UDirection, Argument::QDirection],
    ),
];

#[test]
fn products_are_those_with_all_derivatives() {
    for seed in trees::tried(541..=552) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let has_values = !tree.parameters.is_empty();
        for (function, by, directions) in PRODUCTS {
            let by: Vec<&str> = by
                .iter()
                .copied()
                .filter(|name| has_values || *name != "parameters")
                .collect();
            let by_all = by.join(", ");
            for (formulation, plan) in ways(&tree) {
                let numbers = |text: String| {
                    evaluate_by(&tree, &request(&tree, &text), formulation, &plan, &state)
                };
                let values = numbers(function.to_owned());
                let weights = weights(
                    &tree,
                    &request(&tree, &format!("vjp({function}; {by_all})")),
                );
                assert_eq!(weights.len(), values.len());
                let (mut along, mut back) = (vec![0.0; values.len()], Vec::new());
                for (&direction, name) in directions.iter().zip(&by) {
                    let matrix = numbers(format!("d({function})/d({name})"));
                    let direction = given(&tree, direction);
                    let rows: Vec<&[f64]> = matrix.chunks(direction.len()).collect();
                    for (sum, row) in along.iter_mut().zip(&rows) {
                        *sum += dot(row, &direction);
                    }
                    back.extend((0..direction.len()).map(|column| {
                        let column: Vec<f64> = rows.iter().map(|row| row[column]).collect();
                        dot(&column, &weights)
                    }));
                }
                for (found, expected) in [("jvp", along), ("vjp", back)].map(|(name, expected)| {
                    (numbers(format!("{name}({function}; {by_all})")), expected)
                }) {
                    let allowed = if inverts(function) { INVERTED } else { EXACT };
                    let what = format!("{seed}, {function}");
                    assert_within(what, relative(&found, &expected), allowed);
                }
            }
        }
    }
}

#[test]
fn products_of_accelerations_by_forces_are_those_by_a_sweep_through_the_solution() {
    for seed in trees::tried(553..=564) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let by_values = if tree.parameters.is_empty() {
            ""
        } else {
            ", parameters"
        };
        let by_forces = Plan::full(&tree);
        let by_factors = by_forces.with(Technique::Articulated, false);
        let swept = by_forces.with(Technique::DirectDerivatives, false);
        for (function, by) in [
            ("forward_dynamics", "q, u, tau"),
            ("loaded_forward_dynamics", "loads, tau, u, q"),
        ] {
            for kind in ["jvp", "vjp"] {
                let text = format!("{kind}({function}; {by}{by_values})");
                let request = request(&tree, &text);
                let numbers =
                    |plan| evaluate_by(&tree, &request, Formulation::Recursive, plan, &state);
                let expected = numbers(&swept);
                for plan in [&by_forces, &by_factors] {
                    let error = relative(&numbers(plan), &expected);
                    assert_within(format!("{seed}, {text}"), error, INVERTED);
                }
            }
        }
    }
}

/// Every function but those with compact outputs, as it is asked for.
pub(crate) fn every_function(tree: &Tree) -> Vec<(&'static Function, String)> {
    let frame = names(tree).pop().expect("a tree has bodies");
    let all = Function::all().filter(|function| !function.is_compact());
    all.map(|function| match function.of {
        Of::System => (function, function.name.to_owned()),
        Of::Frame(_) | Of::Frames(_) => (function, format!("{}({frame})", function.name)),
    })
    .collect()
}

/// The functions and variables that this of three trees tries, of those that do not jump.
pub(crate) fn third(tree: &Tree, seed: u64) -> Vec<(String, String)> {
    let all = every_function(tree).into_iter().zip(0..);
    let own = all.filter(|(_, place)| place % 3 == seed % 3);
    let pairs = own.flat_map(|((function, name), _)| {
        let variables = variables(tree, function).into_iter();
        variables.map(move |variable| (name.clone(), variable))
    });
    pairs
        .filter(|(name, variable)| !jumps(name, variable))
        .collect()
}

#[test]
fn every_function_has_its_gradient() {
    for seed in trees::tried(553..=555) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let numbers = |text: &str| values(&tree, &request(&tree, text), &Plan::full(&tree), &state);
        for (function, name) in every_function(&tree) {
            for variable in variables(&tree, function) {
                let text = format!("vjp({name}; {variable})");
                let weights = weights(&tree, &request(&tree, &text));
                let all = numbers(&format!("d({name})/d({variable})"));
                assert_eq!(weights.len(), numbers(&name).len(), "{text}");
                let n = n_entries(&tree, &variable);
                let column =
                    |at: usize| -> Vec<f64> { all.iter().skip(at).step_by(n).copied().collect() };
                let expected: Vec<f64> = (0..n).map(|at| dot(&column(at), &weights)).collect();
                let allowed = if inverts(&name) { INVERTED } else { EXACT };
                let what = format!("{seed}, {text}");
                assert_within(what, relative(&numbers(&text), &expected), allowed);
            }
        }
    }
}

#[test]
fn multipliers_of_one_name_belong_to_one_place() {
    let mut known = BTreeMap::new();
    for function in Function::all().filter(|function| function.outputs.len() > 1) {
        for (place, output) in function.outputs.iter().enumerate() {
            let first = *known.entry(output.name.clone()).or_insert(place);
            assert_eq!(first, place, "{}, {}", function.name, output.name);
        }
    }
}

#[test]
fn arguments_are_listed_in_their_order() {
    assert!(Argument::ALL.is_sorted());
}
