//! The motions that move no mass, at the state with the fewest.

use std::collections::BTreeSet;

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::mobility::following;
use crate::tree::mobility::response::moved_along;
use crate::tree::mobility::sweep::{SweptJoint, inward};
use crate::tree::mobility::units::Units;
use crate::tree::system::Tree;
use crate::tree::value::Parameter;

/// The states that are tried.
const STATES: u64 = 3;

/// Coordinates that move together.
pub(super) type Combination = Vec<(BodyId, CoordinateName)>;

/// The motions that move no mass in any of a few seeded states, each as the free coordinates that take part; at most `most`.
///
/// There are as many as the mass matrix lacks in rank, and none has a coordinate too many. A tree that [`build`](crate::tree::build)
/// made has none; one whose values were changed since may have some.
pub fn idle_motions(tree: &Tree, most: usize) -> Vec<Vec<(BodyId, CoordinateName)>> {
    let units = Units::of(tree);
    if tree.has_followers() {
        let tried = (1..=STATES).map(|seed| following::idle(tree, &units, &mut Random::new(seed)));
        let mut fewest = tried.min_by_key(Vec::len).unwrap_or_default();
        fewest.truncate(most);
        return fewest;
    }
    let sweeps = (1..=STATES).map(|seed| inward(tree, &units, &mut Random::new(seed)));
    let n_idle =
        |joints: &Vec<SweptJoint>| joints.iter().map(|joint| joint.idle.len()).sum::<usize>();
    let joints = sweeps.min_by_key(n_idle).unwrap_or_default();
    let of_body = |body: BodyId| {
        let n_idle = joints.get(body.index()).map_or(0, |joint| joint.idle.len());
        (0..n_idle).map(move |idle| (body, idle))
    };
    let motions = tree.body_ids().flat_map(of_body).take(most);
    motions
        .map(|(body, idle)| moved_along(tree, &joints, body, idle))
        .collect()
}

/// What can be held so that fewer motions move no mass, whatever is set at run time: of each of these motions the coordinate
/// that stands furthest out; none twice.
pub(crate) fn holdable(tree: &Tree, most: usize) -> Vec<(BodyId, CoordinateName)> {
    let mut holdable = Vec::new();
    let mut known = BTreeSet::new();
    for motion in idle_motions(&with_other_nominals(tree), most) {
        let is_new = |(body, coordinate): &&(BodyId, CoordinateName)| {
            !known.contains(&(*body, coordinate.index()))
        };
        let outmost = motion.iter().rev().find(is_new);
        if let Some(&(body, coordinate)) = outmost {
            known.insert((body, coordinate.index()));
            holdable.push((body, coordinate));
        }
    }
    holdable
}

/// The tree with other values, none of them zero, of what is set at run time.
fn with_other_nominals(tree: &Tree) -> Tree {
    let units = Units::of(tree);
    let mut random = Random::new(1);
    let parameters = tree.parameters.iter().map(|parameter| {
        let unit = match parameter.unit {
            "kg" => units.mass,
            "m" => units.length,
            "kg m^2" => units.mass * units.length * units.length,
            _ => 1.0,
        };
        Parameter {
            nominal: unit * (0.25 + random.signed().abs()),
            ..parameter.clone()
        }
    });
    Tree {
        parameters: parameters.collect(),
        ..tree.clone()
    }
}
