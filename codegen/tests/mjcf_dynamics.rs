//! The models of `tests/mjcf` have MuJoCo's mass matrix, bias, inverse and forward dynamics.
//!
//! The graphs are evaluated as they were derived; what is written into modules has its own tests.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeMap;
use std::fs;

use kane_codegen::description::{Reading, mjcf};
use kane_codegen::diagnostic::Source;
use kane_codegen::expr::Input;
use kane_codegen::functions::{Formulation, Function};
use kane_codegen::tree::{self, Tree};
use serde_json::Value;

/// The largest error relative to the largest entry of a quantity, where nothing is solved.
const EXACT: f64 = 2e-14;
/// The same of forward dynamics: times the condition of the mass matrices, up to a hundred here.
const SOLVED: f64 = 1e-12;

/// A model, and where MuJoCo has each of our coordinates and speeds.
struct Reference {
    tree: Tree,
    values: Value,
    qpos: Vec<usize>,
    qvel: Vec<usize>,
}

fn reference(name: &str) -> Reference {
    let folder = format!("{}/../tests/mjcf/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(format!("{folder}/{name}.xml")).unwrap();
    let source = Source::new(format!("{name}.xml"), text);
    let include = |path: &str| fs::read_to_string(format!("{folder}/{path}"));
    let description = mjcf::parse(&source, &Reading::default(), &include);
    let tree = tree::build(&description).unwrap().tree;
    let values = fs::read_to_string(format!("{folder}/reference.json")).unwrap();
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
    assert_eq!(tree.n_speeds, qvel.len());
    Reference {
        tree,
        values,
        qpos,
        qvel,
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap();
    list.iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Some of the numbers, in the order of their places.
fn picked(value: &Value, places: &[usize]) -> Vec<f64> {
    let numbers = numbers(value);
    places.iter().map(|place| numbers[*place]).collect()
}

fn close(function: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{function}");
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let worst = found.iter().zip(expected);
    let worst = worst.fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    assert!(
        worst <= tolerance * largest,
        "{function}: off by {worst:e}, largest entry {largest:e}"
    );
}

fn check(reference: &Reference, state: &Value, formulation: Formulation) {
    let q = picked(&state["qpos"], &reference.qpos);
    let u = picked(&state["qvel"], &reference.qvel);
    let speeds = |value: &Value| picked(value, &reference.qvel);
    let tau = speeds(&state["forward"]["tau"]);
    let u_dot = speeds(&state["inverse"]["qacc"]);
    let evaluate = |function: &str| {
        let derived = Function::find(function)
            .unwrap()
            .derive(&reference.tree, formulation);
        let mut known = BTreeMap::new();
        derived.graph.evaluate(&derived.roots, |given| {
            *known.entry(given).or_insert_with(|| match given {
                Input::Q(id) => q[id.index()],
                Input::U(id) => u[id.index()],
                Input::UDot(id) => u_dot[id.index()],
                Input::Tau(id) => tau[id.index()],
                other => unreachable!("{other:?} is no argument of these functions"),
            })
        })
    };
    let rows = state["mass_matrix"].as_array().unwrap();
    let rows = reference.qvel.iter().map(|row| speeds(&rows[*row]));
    let mass_matrix: Vec<f64> = rows.flatten().collect();
    close("mass_matrix", &evaluate("mass_matrix"), &mass_matrix, EXACT);
    close("bias", &evaluate("bias"), &speeds(&state["bias"]), EXACT);
    let expected = speeds(&state["inverse"]["tau"]);
    close(
        "inverse_dynamics",
        &evaluate("inverse_dynamics"),
        &expected,
        EXACT,
    );
    let expected = speeds(&state["forward"]["qacc"]);
    close(
        "forward_dynamics",
        &evaluate("forward_dynamics"),
        &expected,
        SOLVED,
    );
}

fn agrees_with_mujoco(name: &str) {
    let reference = reference(name);
    for state in reference.values["states"].as_array().unwrap() {
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            check(&reference, state, formulation);
        }
    }
}

/// Makes a test of each model named.
macro_rules! models {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            agrees_with_mujoco(stringify!($name));
        })*
    };
}

models! {
    adjusted_inertias
    ant
    ball_joint_arm
    cart_with_springs
    cheetah
    extrinsic_angles
    frames
    free_bodies
    humanoid
    inertias
    legged
    mixed_angles
    no_gravity
    orientations
    several_joints
    two_link_arm
    walker
    welded
}
