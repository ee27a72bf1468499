//! The centre of all mass, of which a module tells only the parts' places.

use std::fs;

use kane_codegen::{
    description::{self, Base, Reading},
    diagnostic::Source,
    tree::{self, Changes},
};
use kane_test_robots::Robot;

use super::{reference::path, times, transposed};

/// The mass centre of all bodies, inertial components.
pub(crate) fn mass_center(robot: &dyn Robot, q: &[f64], masses: &[f64]) -> [f64; 3] {
    let total: f64 = masses.iter().sum();
    let (rotations, centers) = (robot.rotation(q), robot.mass_center_position(q));
    assert_eq!(centers.len(), masses.len());
    let mut sum = [0.0; 3];
    for ((rotation, center), mass) in rotations.iter().zip(centers).zip(masses) {
        let center = times(&transposed(rotation), center);
        for (sum, entry) in sum.iter_mut().zip(center) {
            *sum += mass / total * entry;
        }
    }
    sum
}

/// The bodies' masses with all that is fixed to them, which a module does not tell: from the model.
pub(crate) fn masses(name: &str, is_floating: bool) -> Vec<f64> {
    let file = format!("{name}.urdf");
    let text = fs::read_to_string(path(name, &file)).expect("the model is there");
    let reading = Reading {
        base: is_floating.then_some(Base::Free),
        ..Reading::default()
    };
    let source = Source::new(file, text);
    let description = description::read(&source, &reading, &description::no_includes);
    let checked = tree::build_with(&description, &Changes::default()).expect("it was generated");
    let bodies = checked.tree.bodies.iter();
    let masses = bodies.map(|body| body.parts.iter().map(|part| nominal(part.mass)).sum());
    masses.collect()
}

fn nominal(value: tree::Value) -> f64 {
    match value {
        tree::Value::Baked(number) => number,
        tree::Value::Runtime(_) => unreachable!("a URDF has no runtime values"),
    }
}
