//! The graph's own meaning of every function against values from a 60-digit evaluation of the notes' equations.
//!
//! `tests/reference/` holds six systems with three states each; nothing there shares code with this crate.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;

use kane_codegen::{
    description::toml,
    diagnostic::Source,
    expr::Input,
    functions::{CompactBlock, Formulation, Function},
    tree::{self, Tree},
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    json::flat,
};
use serde_json::Value;

/// The largest error relative to the largest entry of a quantity. The reference is rounded to 17 digits, and the longest
/// sums here have some hundred terms of like size: 1e-13 would do for all but `y_dot`, which is a solution.
const TOLERANCE: Tolerance = Tolerance::relative(1e-12);

struct Reference {
    tree: Tree,
    cases: Vec<Value>,
}

fn reference(name: &str) -> Reference {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let model = if name == "eight_body" {
        "models/eight_body.toml".to_owned()
    } else {
        format!("tests/reference/{name}.toml")
    };
    let text = fs::read_to_string(format!("{root}/{model}")).unwrap();
    let tree = tree::build(&toml::parse(&Source::new(model, text)))
        .unwrap()
        .tree;
    let values = fs::read_to_string(format!("{root}/tests/reference/{name}.json")).unwrap();
    let values: Value = serde_json::from_str(&values).unwrap();
    Reference {
        tree,
        cases: values["cases"].as_array().unwrap().clone(),
    }
}

/// The inputs of a state, in the notes' order, Eq. (1): all angles, then all translations.
fn input(case: &Value, tree: &Tree, input: Input) -> f64 {
    let state = &case["state"];
    let both = |angles: &str, translations: &str| {
        [flat(&state[angles]), flat(&state[translations])].concat()
    };
    match input {
        Input::Q(id) => both("theta", "s")[id.index()],
        Input::U(id) => both("theta_dot", "s_dot")[id.index()],
        Input::UDot(id) => flat(&case["expect"]["y_dot"])[id.index()],
        // With the generalized forces of the loads as tau, forward dynamics gives the reference's y_dot.
        Input::Tau(id) => {
            evaluate(case, tree, "generalized_forces", Formulation::Notes)[id.index()]
        }
        Input::Force(body, axis) => state["F"][body.index()][axis].as_f64().unwrap(),
        Input::Moment(body, axis) => state["M"][body.index()][axis].as_f64().unwrap(),
        Input::RelativeAngularVelocity(body, axis) => {
            case["expect"]["bodies"][body.index()]["omega_rel"][axis]
                .as_f64()
                .unwrap()
        }
        Input::Parameter(_) | Input::Prepared(_) | Input::Sine(_) | Input::Cosine(_) => {
            unreachable!("the references have no parameters, nor are sines given")
        }
        Input::Shared(_)
        | Input::Side(_)
        | Input::CallResult(_)
        | Input::Point(_)
        | Input::FrameForce(_)
        | Input::FrameMoment(_)
        | Input::Product(..) => {
            unreachable!("no function here is of a frame, nor a product")
        }
    }
}

fn evaluate(case: &Value, tree: &Tree, function: &str, formulation: Formulation) -> Vec<f64> {
    let derived = Function::find(function).unwrap().derive(
        tree,
        formulation,
        &kane_codegen::recursive::Plan::full(tree),
    );
    let mut known = std::collections::BTreeMap::new();
    derived.graph.evaluate(&derived.roots, |given| {
        *known
            .entry(given)
            .or_insert_with(|| input(case, tree, given))
    })
}

/// Compact columns as dense 3 x 6N matrices, one a body.
fn expand(tree: &Tree, blocks: &[CompactBlock], columns: &[f64]) -> Vec<f64> {
    let width = tree.n_speeds;
    let mut dense = vec![0.0; tree.bodies.len() * 3 * width];
    for block in blocks {
        for column in 0..block.columns {
            for row in 0..3 {
                let place = (block.body * 3 + row) * width + block.speed + column;
                dense[place] = columns[3 * (block.first + column) + row];
            }
        }
    }
    dense
}

fn check(name: &str) {
    let Reference { tree, cases } = reference(name);
    for case in &cases {
        let expect = &case["expect"];
        let bodies = |key: &str| -> Vec<f64> {
            expect["bodies"]
                .as_array()
                .unwrap()
                .iter()
                .flat_map(|body| flat(&body[key]))
                .collect()
        };
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let check = |function: &str, expected: &[f64]| {
                let found = evaluate(case, &tree, function, formulation);
                assert_close(
                    format!("{name} {function} {formulation:?}"),
                    &found,
                    expected,
                    TOLERANCE,
                );
            };
            check("mass_matrix", &flat(&expect["A"]));
            check("forcing", &flat(&expect["f"]));
            check("forward_dynamics", &flat(&expect["y_dot"]));
        }
        let per_body = [
            ("relative_rotation", "R_rel"),
            ("rotation", "R"),
            ("relative_angular_velocity", "omega_rel"),
            ("angular_velocity", "omega"),
            ("origin_position", "p_O"),
            ("mass_center_position", "p_G"),
            ("origin_velocity", "v_O"),
            ("mass_center_velocity", "v_G"),
        ];
        for (function, key) in per_body {
            let found = evaluate(case, &tree, function, Formulation::Notes);
            assert_close(
                format!("{name} {function}"),
                &found,
                &bodies(key),
                TOLERANCE,
            );
        }
        let partials = [
            ("partial_angular_velocity", "omega_y"),
            ("partial_angular_velocity_dot", "omega_y_dot"),
            ("partial_velocity_origin", "v_O_y"),
            ("partial_velocity_origin_dot", "v_O_y_dot"),
            ("partial_velocity", "v_G_y"),
            ("partial_velocity_dot", "v_G_y_dot"),
        ];
        for (function, key) in partials {
            let derived = Function::find(function).unwrap().derive(
                &tree,
                Formulation::Notes,
                &kane_codegen::recursive::Plan::full(&tree),
            );
            let columns = derived
                .graph
                .evaluate(&derived.roots, |given| input(case, &tree, given));
            assert_close(
                format!("{name} {function}"),
                &expand(&tree, &derived.blocks, &columns),
                &bodies(key),
                TOLERANCE,
            );
        }
        let rates = evaluate(case, &tree, "angle_rates", Formulation::Notes);
        assert_close(
            format!("{name} angle_rates"),
            &rates,
            &flat(&case["state"]["theta_dot"]),
            TOLERANCE,
        );
    }
}

macro_rules! agrees {
    ($($name:ident),+ $(,)?) => {$(
        #[test]
        fn $name() {
            check(stringify!($name));
        }
    )+};
}

agrees!(one_body, chain3, star5, eight_body, two_roots, tree12);
