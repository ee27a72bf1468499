//! The motions that move no mass, at the state with the fewest.

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::Tree;
use crate::tree::mobility::following;
use crate::tree::mobility::response::moved_along;
use crate::tree::mobility::sweep::{SweptJoint, inward};
use crate::tree::mobility::units::Units;

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
