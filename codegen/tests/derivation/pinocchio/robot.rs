//! A robot whose reference is Pinocchio's, and its states in our coordinates and speeds.

use std::{fs, path::Path};

use kane_codegen::{
    description::{self, Base, Reading, no_includes},
    diagnostic::Source,
    expr::Input,
    functions::Argument,
    tree::{self, Changes, CoordinateKind, Orientation, Tree},
};
use kane_test_support::{json::flat, numeric::Matrix, rotation::Rotation};
use serde_json::Value;

use crate::derivative_references::Inputs;

/// A robot beside Pinocchio's: of each of our speeds the place of Pinocchio's.
pub(super) struct Robot {
    pub(super) tree: Tree,
    pub(super) reference: Value,
    places: Vec<usize>,
    pub(super) floats: bool,
}

impl Robot {
    pub(super) fn read(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../tests/robots")
            .join(name);
        let text = |file: &str| fs::read_to_string(folder.join(file)).expect("it is there");
        let reference: Value = serde_json::from_str(&text("reference.json")).expect("it is JSON");
        let floats = reference["base"] == "floating";
        let reading = Reading {
            base: floats.then_some(Base::Free),
            ..Reading::default()
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

    pub(super) fn inputs(&self, sample: &Value) -> Inputs {
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
            for (kind, coordinate) in body.joint.coordinates() {
                let value = match kind {
                    CoordinateKind::EulerParameter(0) => q[6],
                    CoordinateKind::EulerParameter(i) if self.floats => q[2 + i],
                    CoordinateKind::Translation(i) if body.lower.is_none() && self.floats => q[i],
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
    pub(super) fn ordered(&self, matrix: &[f64]) -> Matrix {
        let n = self.places.len();
        let mut ordered = vec![0.0; n * n];
        for (i, &row) in self.places.iter().enumerate() {
            for (j, &column) in self.places.iter().enumerate() {
                ordered[row * n + column] = matrix[i * n + j];
            }
        }
        Matrix::new(n, ordered)
    }
}

/// The base's matrix from body components to inertial ones.
pub(super) fn base(q: &[f64]) -> Rotation {
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

pub(super) fn vector(all: &[f64], first: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| all[first + axis])
}

pub(super) fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn times(m: &Rotation, v: [f64; 3]) -> Vec<f64> {
    m.iter()
        .map(|row| (0..3).map(|i| row[i] * v[i]).sum())
        .collect()
}
