//! Derivatives of dynamics against differences at 60 digits, and against Pinocchio's for robots, whose floating bases have
//! speeds along their own axes.
//!
//! `tests/reference/NAME.derivatives.json` holds, at states without loads, how `tau` and `u_dot` change with coordinates, speeds
//! and forces, by central differences with a step of 1e-20 of the notes' equations in the order of the notes: all angles, then
//! all translations.

use std::{collections::BTreeMap, fs, path::Path};

use kane_codegen::{
    description::{self, Base, Reading, no_includes, toml},
    diagnostic::Source,
    expr::Input,
    functions::{Argument, Formulation},
    recursive::{Plan, Technique},
    tree::{self, Changes, Orientation, Tree},
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    json::flat,
    numeric::{Matrix, condition},
    rotation::Rotation,
};
use serde_json::Value;

use crate::frames::request;

/// Relative to the largest entry of a matrix, of sums of some hundred terms; of solutions, times a ten-thousandth of the
/// condition number of the mass matrix where that is more.
const DIGITS: f64 = 1e-12;

/// The same against Pinocchio, whose values have been rounded on the way, too.
const PINOCCHIO: f64 = 1e-10;

const INVERSE: &str = "d(inverse_dynamics)/d(q, u, u_dot)";
const FORWARD: &str = "d(forward_dynamics)/d(q, u, tau)";

type Inputs = BTreeMap<Input, f64>;

/// By composite bodies, as is emitted, and by a sweep.
fn plans(tree: &Tree) -> [Plan; 2] {
    let composite = Plan::full(tree);
    [composite.with(Technique::Composite, false), composite]
}

/// The matrices that a function writes, by rows.
fn matrices(tree: &Tree, text: &str, plan: &Plan, inputs: &Inputs) -> [Vec<f64>; 3] {
    let derived = request(tree, text).derive(tree, Formulation::Recursive, plan);
    let values = derived
        .graph
        .evaluate(&derived.roots, |given| inputs[&given]);
    let size = tree.n_speeds * tree.n_speeds;
    assert_eq!(values.len(), 3 * size);
    [0, 1, 2].map(|place| values[place * size..][..size].to_vec())
}

fn scaled(tolerance: f64, tree: &Tree, mass_matrix: Vec<f64>) -> f64 {
    let condition = condition(&Matrix::new(tree.n_speeds, mass_matrix));
    tolerance * larger(condition / 1e4, 1.0)
}

fn check(what: &str, tolerance: f64, found: &[f64], expected: &[f64]) {
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

/// A robot beside Pinocchio's: of each of our speeds the place of Pinocchio's.
struct Robot {
    tree: Tree,
    reference: Value,
    places: Vec<usize>,
    floats: bool,
}

impl Robot {
    fn read(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../tests/robots")
            .join(name);
        let text = |file: &str| fs::read_to_string(folder.join(file)).expect("it is there");
        let reference: Value = serde_json::from_str(&text("reference.json")).expect("it is JSON");
        let floats = reference["base"] == "floating";
        let reading = Reading {
            base: floats.then_some(Base::Free),
            chart: None,
        };
        let source = Source::new("robot.urdf", text(&format!("{name}.urdf")));
        // Right angles written with ten digits are taken as they are there, too.
        let changes = Changes {
            snap: 0.0,
            ..Changes::default()
        };
        let described = description::read(&source, &reading, &no_includes);
        let tree = tree::build_with(&described, &changes)
            .expect("it is right")
            .tree;
        let joints = reference["joints"].as_array().expect("it lists joints");
        let mut places = vec![usize::MAX; tree.n_speeds];
        for body in &tree.bodies {
            let is_root = matches!(body.joint.orientation, Orientation::AngularVelocity { .. });
            for (motion, speed) in body.joint.speeds() {
                // Turns stand before shifts here, after them there.
                places[speed.index()] = if is_root {
                    (motion + 3) % 6
                } else {
                    let named = |joint: &&Value| joint["name"] == body.joint.name.as_str();
                    let joint = joints.iter().find(named).expect("it has this joint");
                    let place = joint["v_index"].as_u64().expect("a place");
                    usize::try_from(place).expect("a place")
                };
            }
        }
        Self {
            tree,
            reference,
            places,
            floats,
        }
    }

    fn inputs(&self, sample: &Value) -> Inputs {
        let [q, v, a, tau] = ["q", "v", "a", "tau"].map(|name| flat(&sample[name]));
        let (mut u, mut u_dot, mut forces) = (v.clone(), a.clone(), tau.clone());
        if self.floats {
            let r = base(&q);
            let (linear, w) = (vector(&v, 0), vector(&v, 3));
            let accelerated = sum(vector(&a, 0), cross(w, linear));
            u.splice(..3, times(&r, linear));
            u_dot.splice(..3, times(&r, accelerated));
            forces.splice(..3, times(&r, vector(&tau, 0)));
        }
        let mut inputs = Inputs::new();
        for (argument, values) in [
            (Argument::U, &u),
            (Argument::UDot, &u_dot),
            (Argument::Tau, &forces),
        ] {
            let own = self.places.iter().map(|&place| values[place]);
            inputs.extend(argument.inputs(&self.tree).zip(own));
        }
        for body in &self.tree.bodies {
            for (name, coordinate) in body.joint.coordinates() {
                let value = match name {
                    "e0" => q[6],
                    "e1" | "e2" | "e3" if self.floats => q[2 + place(name)],
                    "s1" | "s2" | "s3" if body.lower.is_none() && self.floats => q[place(name) - 1],
                    _ => {
                        let (_, speed) = body.joint.speeds()[0];
                        q[self.places[speed.index()] + usize::from(self.floats)]
                    }
                };
                inputs.insert(Input::Q(coordinate), value);
            }
        }
        inputs
    }

    /// A matrix over our speeds as one over Pinocchio's, in our components.
    fn ordered(&self, matrix: &[f64]) -> Vec<f64> {
        let n = self.places.len();
        let mut ordered = vec![0.0; n * n];
        for (i, &row) in self.places.iter().enumerate() {
            for (j, &column) in self.places.iter().enumerate() {
                ordered[row * n + column] = matrix[i * n + j];
            }
        }
        ordered
    }
}

/// The base's matrix from body components to inertial ones.
fn base(q: &[f64]) -> Rotation {
    let [x, y, z, w] = [q[3], q[4], q[5], q[6]];
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

fn place(name: &str) -> usize {
    name[1..].parse().expect("a digit")
}

fn vector(all: &[f64], first: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| all[first + axis])
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn times(m: &Rotation, v: [f64; 3]) -> Vec<f64> {
    m.iter()
        .map(|row| (0..3).map(|i| row[i] * v[i]).sum())
        .collect()
}

/// The matrix whose columns are these images of the axes.
fn by_columns(image: impl Fn([f64; 3]) -> Vec<f64>) -> Vec<Vec<f64>> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    axes.into_iter().map(image).collect()
}

/// Adds to columns of a matrix those of another times what makes the base's linear rows of it: `to += of[:, 0..3] map`.
fn add_moved(n: usize, to: &mut [f64], of: &[f64], (first, map): (usize, &[Vec<f64>])) {
    for row in 0..n {
        for (column, image) in map.iter().enumerate() {
            let moved: f64 = (0..3).map(|i| of[row * n + i] * image[i]).sum();
            to[row * n + first + column] += moved;
        }
    }
}

/// Derivatives of forces in Pinocchio's speeds: with `R` from the base's axes, `u = R v`, `u_dot = R (a + w × v)` and
/// `tau_there = R^T tau` for the base's linear parts.
fn of_forces(robot: &Robot, sample: &Value, [by_q, by_u, by_a]: [Vec<f64>; 3]) -> [Vec<f64>; 2] {
    let [mut by_q, mut by_u, by_a] = [by_q, by_u, by_a].map(|matrix| robot.ordered(&matrix));
    if !robot.floats {
        return [by_q, by_u];
    }
    let n = robot.places.len();
    let [q, v, a] = ["q", "v", "a"].map(|name| flat(&sample[name]));
    let r = base(&q);
    let (linear, w) = (vector(&v, 0), vector(&v, 3));
    let accelerated = sum(vector(&a, 0), cross(w, linear));
    let of_u = by_u.clone();
    // By the coordinates: displacements along the body's axes, then what turning the base makes of u and u_dot.
    let turned = [
        by_columns(|e| times(&r, cross(e, linear))),
        by_columns(|e| times(&r, cross(e, accelerated))),
    ];
    let of_q = by_q.clone();
    along_body(n, &mut by_q, &of_q, &r);
    add_moved(n, &mut by_q, &of_u, (3, &turned[0]));
    add_moved(n, &mut by_q, &by_a, (3, &turned[1]));
    along_body(n, &mut by_u, &of_u, &r);
    let swept = by_columns(|e| times(&r, cross(w, e)));
    add_moved(n, &mut by_u, &by_a, (0, &swept));
    let spun = by_columns(|e| times(&r, cross(e, linear)));
    add_moved(n, &mut by_u, &by_a, (3, &spun));
    // Rows: forces along the body's axes, which turn with the base.
    let tau = flat(&sample["inverse_dynamics"]);
    for matrix in [&mut by_q, &mut by_u] {
        for column in 0..n {
            let own = [0, 1, 2].map(|row| matrix[row * n + column]);
            for row in 0..3 {
                matrix[row * n + column] = (0..3).map(|i| r[i][row] * own[i]).sum();
            }
        }
    }
    for (axis, column) in by_columns(|e| cross(e, vector(&tau, 0)).to_vec())
        .iter()
        .enumerate()
    {
        for row in 0..3 {
            by_q[row * n + 3 + axis] -= column[row];
        }
    }
    [by_q, by_u]
}

/// The first three columns along the body's axes.
fn along_body(n: usize, to: &mut [f64], of: &[f64], r: &Rotation) {
    for row in 0..n {
        for column in 0..3 {
            to[row * n + column] = (0..3).map(|i| of[row * n + i] * r[i][column]).sum();
        }
    }
}

fn pinocchio(name: &str) {
    let robot = Robot::read(name);
    let tree = &robot.tree;
    let samples = robot.reference["samples"]
        .as_array()
        .expect("it lists samples");
    let mut n_compared = 0;
    // Some samples are of other quantities alone.
    for sample in samples
        .iter()
        .filter(|sample| sample["dtau_dq"].is_array())
        .take(2)
    {
        n_compared += 1;
        let inputs = robot.inputs(sample);
        let plan = Plan::full(tree);
        let forces = matrices(tree, INVERSE, &plan, &inputs);
        let mass_matrix = forces[2].clone();
        let [by_q, by_u] = of_forces(&robot, sample, forces);
        check(name, PINOCCHIO, &by_q, &flat(&sample["dtau_dq"]));
        check(name, PINOCCHIO, &by_u, &flat(&sample["dtau_dv"]));
        if robot.floats {
            continue;
        }
        let solved = scaled(PINOCCHIO, tree, mass_matrix);
        let found = matrices(tree, FORWARD, &plan, &inputs);
        let [by_q, by_u, by_tau] = found.map(|matrix| robot.ordered(&matrix));
        check(name, solved, &by_q, &flat(&sample["ddq_dq"]));
        check(name, solved, &by_u, &flat(&sample["ddq_dv"]));
        check(name, solved, &by_tau, &flat(&sample["ddq_dtau"]));
    }
    assert!(n_compared > 0, "nothing was compared");
}

#[test]
fn arms_change_as_pinocchio_says() {
    for name in ["double_pendulum", "cartpole", "ur5", "panda"] {
        pinocchio(name);
    }
}

#[test]
fn robots_that_float_change_as_pinocchio_says() {
    for name in ["solo12", "talos"] {
        pinocchio(name);
    }
}
