//! Limits of coordinates, speeds and forces, and friction: data that no function reads.

use crate::tree::{Coordinate, Mechanics, Motion, Tree};

/// Limits, each as long as what it limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The least value of each coordinate, rad, m.
    pub lower: Vec<f64>,
    /// The greatest.
    pub upper: Vec<f64>,
    /// The greatest magnitude of each speed, rad/s, m/s.
    pub velocity: Vec<f64>,
    /// The greatest magnitude of each generalized force, N m, N.
    pub effort: Vec<f64>,
    /// Coulomb friction along each speed, N m, N: of the joint's own, and of those that follow times the size of their multiplier.
    pub friction: Vec<f64>,
}

impl Limits {
    /// Those of a tree.
    pub fn of(tree: &Tree) -> Self {
        Self {
            lower: along_coordinates(tree, |mechanics| mechanics.range[0], f64::NEG_INFINITY),
            upper: along_coordinates(tree, |mechanics| mechanics.range[1], f64::INFINITY),
            velocity: along_speeds(tree, |mechanics| mechanics.velocity),
            effort: along_speeds(tree, |mechanics| mechanics.effort),
            friction: friction(tree),
        }
    }
}

fn along_coordinates(tree: &Tree, of: impl Fn(&Mechanics) -> f64, none: f64) -> Vec<f64> {
    let mut values = vec![none; tree.n_coordinates];
    for body in &tree.bodies {
        let joint = &body.joint;
        let angles = joint.angles().into_iter().flatten();
        let angles = angles.zip(&joint.mechanics);
        let translations = joint.translations.iter().copied();
        let translations = translations.zip(&joint.mechanics[3..]);
        for (coordinate, mechanics) in angles.chain(translations) {
            if let Coordinate::Free { coordinate, .. } = coordinate {
                values[coordinate.index()] = of(mechanics);
            }
        }
    }
    values
}

fn along_speeds(tree: &Tree, of: impl Fn(&Mechanics) -> f64) -> Vec<f64> {
    let mut values = vec![0.0; tree.n_speeds];
    for body in &tree.bodies {
        for (motion, speed) in body.joint.speeds() {
            values[speed.index()] = of(&body.joint.mechanics[motion]);
        }
    }
    values
}

/// What each speed feels of the friction of all joints that it moves.
fn friction(tree: &Tree) -> Vec<f64> {
    let mut values = vec![0.0; tree.n_speeds];
    for joint in tree.bodies.iter().map(|body| &body.joint) {
        for (motion, mechanics) in joint.motions().into_iter().zip(&joint.mechanics) {
            if let Some(Motion { speed, factor }) = motion {
                values[speed.index()] += factor.abs() * mechanics.friction;
            }
        }
    }
    values
}
