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
        let (lower, upper) = ranges(tree).into_iter().unzip();
        let mut velocity = along_speeds(tree, |mechanics| mechanics.velocity);
        for (Motion { speed, factor }, mechanics) in following(tree) {
            // Files say zero where they say nothing.
            if mechanics.velocity > 0.0 {
                let own = &mut velocity[speed.index()];
                *own = own.min(mechanics.velocity / factor.abs());
            }
        }
        Self {
            lower,
            upper,
            velocity,
            effort: along_speeds(tree, |mechanics| mechanics.effort),
            friction: friction(tree),
        }
    }
}

/// The least and the greatest value of each coordinate at which no joint that it moves passes a limit. Those that follow count, unless
/// no motion would be left; files say zero to zero where they say nothing.
fn ranges(tree: &Tree) -> Vec<(f64, f64)> {
    let mut own = vec![(f64::NEG_INFINITY, f64::INFINITY); tree.n_coordinates];
    let mut all = own.clone();
    for joint in tree.bodies.iter().map(|body| &body.joint) {
        let angles = joint.angles().into_iter().flatten();
        let angles = angles.zip(&joint.mechanics);
        let translations = joint.translations.into_iter().zip(&joint.mechanics[3..]);
        for (coordinate, mechanics) in angles.chain(translations) {
            let [lower, upper] = mechanics.range;
            match coordinate {
                Coordinate::Free { coordinate, .. } => {
                    own[coordinate.index()] = (lower, upper);
                    let all = &mut all[coordinate.index()];
                    *all = (all.0.max(lower), all.1.min(upper));
                }
                Coordinate::Mimic {
                    coordinate,
                    multiplier,
                    offset,
                    ..
                } if lower < upper => {
                    let [a, b] = [lower, upper].map(|limit| (limit - offset) / multiplier);
                    let all = &mut all[coordinate.index()];
                    *all = (all.0.max(a.min(b)), all.1.min(a.max(b)));
                }
                Coordinate::Mimic { .. } | Coordinate::Locked(_) => {}
            }
        }
    }
    let pairs = own.into_iter().zip(all);
    let ranges = pairs.map(|(own, all)| if all.0 < all.1 { all } else { own });
    ranges.collect()
}

/// The motions of joints that follow others.
fn following(tree: &Tree) -> impl Iterator<Item = (Motion, &Mechanics)> {
    tree.bodies.iter().flat_map(|body| {
        let joint = &body.joint;
        (0..6).filter_map(|place| match joint.coordinate_of(place) {
            Some(Coordinate::Mimic { .. }) => {
                Some((joint.motions()[place]?, &joint.mechanics[place]))
            }
            _ => None,
        })
    })
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
