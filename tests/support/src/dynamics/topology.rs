//! What a tree is like, as far as identities depend on it.

use kane_codegen::tree::{Body, Coordinate, Tree};

use super::composition::Composition;

/// True for a tree that nothing holds: every body on the inertial frame has six free coordinates, and no rotor.
pub fn floats(composition: &Composition) -> bool {
    let tree = composition.tree();
    let is_free = roots(tree).all(|body| body.joint.speeds().len() == 6);
    let on_root = |speed| root_speeds(tree).any(|own| own == speed);
    is_free
        && !composition
            .acting()
            .iter()
            .any(|acting| acting.has_rotor() && on_root(acting.speed()))
}

fn roots(tree: &Tree) -> impl Iterator<Item = &Body> {
    tree.bodies.iter().filter(|body| body.lower.is_none())
}

/// The speeds of the bodies on the inertial frame.
pub fn root_speeds(tree: &Tree) -> impl Iterator<Item = usize> + '_ {
    roots(tree).flat_map(|body| {
        let speeds = body.joint.speeds().into_iter();
        speeds.map(|(_, speed)| speed.index())
    })
}

/// True where the coordinate of some joint follows another.
pub fn has_mimics(tree: &Tree) -> bool {
    tree.bodies.iter().any(|body| {
        (0..6).any(|motion| {
            let coordinate = body.joint.coordinate_of(motion);
            matches!(coordinate, Some(Coordinate::Mimic { .. }))
        })
    })
}
