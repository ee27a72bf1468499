//! Every quantity of `tests/reference`, from compiled text, in both formulations and two scalars.
//!
//! The references come from a 60-digit evaluation of the notes' equations that shares no code with this repository.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

use std::fs;

use kane_test_support::{
    compare::{largest, relative, relative_to},
    errors::Errors,
    json::flat,
    numeric::{Matrix, condition},
};
use kane_test_systems::{Call, REFERENCES, Reference, call::State};
use serde_json::Value;

/// Relative to a quantity's largest entry: sums of some hundred terms of like size, rounded to 1e-16 each.
const F64: f64 = 1e-12;
/// As [`F64`], rounded to 6e-8 each; and the state itself is rounded to that.
const F32: f64 = 1e-4;
/// The rounding of a solution in `f32`, relative to its largest entry and to the condition number of the mass matrix.
const F32_SOLUTION: f64 = 1e-7;

/// The functions that have two formulations and the references' name for them.
const DYNAMICS: [(&str, &str); 3] = [
    ("mass_matrix", "A"),
    ("forcing", "f"),
    ("forward_dynamics", "y_dot"),
];

const PER_BODY: [(&str, &str); 14] = [
    ("relative_rotation", "R_rel"),
    ("rotation", "R"),
    ("angular_velocity", "omega"),
    ("relative_angular_velocity", "omega_rel"),
    ("partial_angular_velocity", "omega_y"),
    ("partial_angular_velocity_dot", "omega_y_dot"),
    ("origin_position", "p_O"),
    ("mass_center_position", "p_G"),
    ("origin_velocity", "v_O"),
    ("mass_center_velocity", "v_G"),
    ("partial_velocity_origin", "v_O_y"),
    ("partial_velocity_origin_dot", "v_O_y_dot"),
    ("partial_velocity", "v_G_y"),
    ("partial_velocity_dot", "v_G_y_dot"),
];

fn cases(name: &str) -> Vec<Value> {
    let path = format!("{}/../reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(path).expect("the reference is there");
    let values: Value = serde_json::from_str(&text).expect("the reference is JSON");
    values["cases"].as_array().expect("it has cases").clone()
}

/// The state in the notes' order, Eq. (1): all angles, then all translations.
fn state(case: &Value) -> State {
    let both = |angles: &str, translations: &str| {
        [
            flat(&case["state"][angles]),
            flat(&case["state"][translations]),
        ]
        .concat()
    };
    let [forces, moments] = ["F", "M"].map(|key| flat(&case["state"][key]));
    let loads = forces.chunks_exact(3).zip(moments.chunks_exact(3));
    State {
        q: both("theta", "s"),
        u: both("theta_dot", "s_dot"),
        u_dot: flat(&case["expect"]["y_dot"]),
        // Until it is known what the loads make of it.
        tau: Vec::new(),
        loads: loads
            .map(|(f, m)| [f[0], f[1], f[2], m[0], m[1], m[2]])
            .collect(),
        w_rel: per_body(case, "omega_rel")
            .chunks_exact(3)
            .map(|w| [w[0], w[1], w[2]])
            .collect(),
    }
}

fn per_body(case: &Value, key: &str) -> Vec<f64> {
    let bodies = case["expect"]["bodies"].as_array().expect("bodies");
    bodies.iter().flat_map(|body| flat(&body[key])).collect()
}

fn check(name: &str) {
    let reference = REFERENCES
        .iter()
        .copied()
        .find(|reference| reference.name == name)
        .expect("it is compiled");
    let mut errors = Errors::default();
    for case in cases(name) {
        check_case(reference, &case, &mut errors);
    }
    errors.show(name);
}

fn check_case(reference: Reference, case: &Value, errors: &mut Errors) {
    let Reference {
        name,
        model: _,
        f64,
        f32,
        notes_f64,
        notes_f32,
    } = reference;
    let expect = &case["expect"];
    let mut state = state(case);
    let expected_f = flat(&expect["f"]);
    state.tau.resize(expected_f.len(), 0.0);
    let condition = condition(&Matrix::new(expected_f.len(), flat(&expect["A"])));
    println!("{name}: condition number {condition:.1e}");
    let all: [(Call, Call, &str); 2] = [(f64, f32, "recursive"), (notes_f64, notes_f32, "notes")];
    for (f64, f32, formulation) in all {
        for (function, key) in DYNAMICS {
            let solution = if function == "forward_dynamics" {
                F32_SOLUTION * condition
            } else {
                F32
            };
            for (call, scalar, tolerance) in [(f64, "f64", F64), (f32, "f32", solution)] {
                // With the generalized forces of the loads as tau, forward dynamics gives the reference's y_dot.
                state.tau = call("generalized_forces", &state);
                let found = call(function, &state);
                let at = format!("{name} {function} {formulation} {scalar}");
                errors.add(at, relative(&found, &flat(&expect[key])), tolerance);
            }
        }
        // Not in the reference by themselves: with the reference's y_dot the forces are those of the loads, and the bias is
        // what f has beside them.
        for (call, scalar, tolerance) in [(f64, "f64", F64), (f32, "f32", F32)] {
            let loads = call("generalized_forces", &state);
            let tau = call("inverse_dynamics", &state);
            let bias = call("bias", &state);
            let f: Vec<f64> = loads
                .iter()
                .zip(&bias)
                .map(|(load, bias)| load - bias)
                .collect();
            // Sums of terms of the size of A y_dot.
            let scale = relative_scale(&flat(&expect["A"]), &state.u_dot);
            let error = relative_to(scale, &tau, &loads);
            errors.add(
                format!("{name} inverse_dynamics {formulation} {scalar}"),
                error,
                tolerance,
            );
            errors.add(
                format!("{name} bias {formulation} {scalar}"),
                relative(&f, &expected_f),
                tolerance,
            );
        }
    }
    for (call, scalar, tolerance) in [(f64, "f64", F64), (f32, "f32", F32)] {
        for (function, key) in PER_BODY {
            let error = relative(&call(function, &state), &per_body(case, key));
            errors.add(format!("{name} {function} {scalar}"), error, tolerance);
        }
        let rates = flat(&case["state"]["theta_dot"]);
        let error = relative(&call("angle_rates", &state), &rates);
        errors.add(format!("{name} angle_rates {scalar}"), error, tolerance);
    }
}

/// The largest sum of magnitudes in `A y_dot`.
fn relative_scale(a: &[f64], y_dot: &[f64]) -> f64 {
    let sum = |row: &[f64]| row.iter().zip(y_dot).map(|(a, y)| (a * y).abs()).sum();
    largest(&a.chunks_exact(y_dot.len()).map(sum).collect::<Vec<f64>>())
}

macro_rules! agrees {
    ($($(#[$condition:meta])? $name:ident),+ $(,)?) => {$(
        $(#[$condition])?
        #[test]
        fn $name() {
            check(stringify!($name));
        }
    )+};
}

agrees!(
    one_body,
    chain3,
    star5,
    eight_body,
    two_roots,
    #[cfg(every_system)]
    tree12,
);
