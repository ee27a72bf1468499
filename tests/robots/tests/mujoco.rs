//! The models of `tests/mjcf`, compiled, have MuJoCo's mass matrix, bias, inverse and forward dynamics, with springs,
//! dampers and rotors.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;

use kane_test_robots::{Dynamics, mjcf};
use kane_test_support::compare::{Tolerance, assert_close};
use serde_json::Value;

/// The largest error relative to the largest entry of a quantity, where nothing is solved: a hundred roundings.
const EXACT: Tolerance = Tolerance::relative(2e-14);
/// The same of forward dynamics: times the condition of the mass matrices, up to a hundred here.
const SOLVED: Tolerance = Tolerance::relative(1e-12);

/// What MuJoCo has, and where it has each of our coordinates and speeds.
struct Reference {
    values: Value,
    qpos: Vec<usize>,
    qvel: Vec<usize>,
}

fn reference(name: &str) -> Reference {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../mjcf");
    let values = fs::read_to_string(format!("{folder}/{name}/reference.json")).unwrap();
    let values: Value = serde_json::from_str(&values).unwrap();
    let (mut qpos, mut qvel) = (Vec::new(), Vec::new());
    for joint in values["joints"].as_array().unwrap() {
        let place = |key: &str| usize::try_from(joint[key].as_u64().unwrap()).unwrap();
        let (q, u) = (place("qpos"), place("qvel"));
        match joint["type"].as_str().unwrap() {
            // Orientation before position, where MuJoCo has it behind.
            "free" => {
                qpos.extend((q + 3..q + 7).chain(q..q + 3));
                qvel.extend((u + 3..u + 6).chain(u..u + 3));
            }
            "ball" => {
                qpos.extend(q..q + 4);
                qvel.extend(u..u + 3);
            }
            _ => {
                qpos.push(q);
                qvel.push(u);
            }
        }
    }
    Reference { values, qpos, qvel }
}

/// Some of the numbers, in the order of their places.
fn picked(value: &Value, places: &[usize]) -> Vec<f64> {
    let numbers = value.as_array().unwrap();
    let number = |place: &usize| numbers[*place].as_f64().unwrap();
    places.iter().map(number).collect()
}

fn check(name: &str, model: &dyn Dynamics, reference: &Reference, state: &Value) {
    let close = |what: &str, found: &[f64], expected: &[f64], tolerance| {
        assert_close(format!("{what} of {name}"), found, expected, tolerance);
    };
    let speeds = |value: &Value| picked(value, &reference.qvel);
    let (q, u) = (
        picked(&state["qpos"], &reference.qpos),
        speeds(&state["qvel"]),
    );
    let rows = state["mass_matrix"].as_array().unwrap();
    let rows = reference.qvel.iter().map(|row| speeds(&rows[*row]));
    let m: Vec<f64> = rows.flatten().collect();
    close("mass_matrix", &model.mass_matrix(&q), &m, EXACT);
    close("bias", &model.bias(&q, &u), &speeds(&state["bias"]), EXACT);
    let (given, expected) = (&state["inverse"]["qacc"], &state["inverse"]["tau"]);
    let found = model.inverse_dynamics(&q, &u, &speeds(given));
    close("inverse_dynamics", &found, &speeds(expected), EXACT);
    let (given, expected) = (&state["forward"]["tau"], &state["forward"]["qacc"]);
    let found = model.forward_dynamics(&q, &u, &speeds(given));
    close("forward_dynamics", &found, &speeds(expected), SOLVED);
}

fn agrees(name: &str) {
    let mut models = mjcf::MODELS.iter();
    let (_, model) = models.find(|(known, _)| *known == name).unwrap();
    let reference = reference(name);
    let states = reference.values["states"].as_array().unwrap();
    assert!(states.len() >= 4);
    for state in states {
        check(name, &*model(), &reference, state);
    }
}

macro_rules! agree {
    ($($name:ident)+) => {
        $(
            #[test]
            fn $name() {
                agrees(stringify!($name));
            }
        )+

        #[test]
        fn every_model_is_listed() {
            let compiled: Vec<&str> = mjcf::MODELS.iter().map(|(name, _)| *name).collect();
            assert_eq!(compiled, [$(stringify!($name)),+]);
        }
    };
}

kane_test_support::mjcf_models!(agree);
