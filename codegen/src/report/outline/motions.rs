//! About and along which axes bodies move, as the tree has them: kinds of joints choose some of these.

use std::collections::BTreeMap;

use super::system::{INERTIAL, Motion, Motions};
use crate::{
    geometry::{Vector, apply, body_fixed_123, transposed},
    tree::{Body, Coordinate, Joint, Tree},
};

/// The motions of each body that has some, by its name; what follows another joint moves as that one says.
pub(super) fn by_body(tree: &Tree) -> BTreeMap<String, Motions> {
    let names = [tree.coordinate_names(), tree.speed_names()];
    let own = tree.bodies.iter().filter_map(|body| {
        let motions = motions(tree, body, &names)?;
        Some((body.name.clone(), motions))
    });
    own.collect()
}

fn motions(tree: &Tree, body: &Body, names: &[Vec<String>; 2]) -> Option<Motions> {
    let joint = &body.joint;
    let base = tree.user_pose(body.lower).rotation;
    let to_base = transposed(&joint.rotation);
    let own = joint.speeds().into_iter().map(|(place, speed)| {
        let axis = apply(&to_base, axis(joint, place));
        let motion = Motion {
            name: match joint.coordinate_of(place) {
                Some(Coordinate::Free { coordinate, .. }) => names[0][coordinate.index()].clone(),
                _ => names[1][speed.index()].clone(),
            },
            place: place % 3,
            axis: [apply(&base, axis), axis],
        };
        (place < 3, motion)
    });
    let (turns, slides): (Vec<_>, Vec<_>) = own.partition(|(is_turn, _)| *is_turn);
    let only = |motions: Vec<(bool, Motion)>| motions.into_iter().map(|(_, own)| own).collect();
    let base = body.lower.map(|lower| tree.body(lower).name.clone());
    (turns.len() + slides.len() > 0).then(|| Motions {
        base: base.unwrap_or_else(|| INERTIAL.to_owned()),
        turns: only(turns),
        slides: only(slides),
    })
}

/// About or along what a motion is, in the joint's axes: angles that are held before one turn what it turns about.
fn axis(joint: &Joint, place: usize) -> Vector {
    let held = |turn: usize| match joint.coordinate_of(turn) {
        Some(Coordinate::Locked(angle)) if turn < place && place < 3 => angle,
        _ => 0.0,
    };
    body_fixed_123([0, 1, 2].map(held))[place % 3]
}
