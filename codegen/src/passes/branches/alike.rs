//! Which branches of the tree are alike.

use std::collections::BTreeMap;

use crate::{
    id::BodyId,
    tree::{Joint, Tree},
};

/// Of fewer branches compilers make no vectors, and what moves between them costs as much as is saved.
const FEWEST: usize = 3;

/// More branches are split among several helpers: longer vectors are rare.
const MOST: usize = 8;

/// Branches on one body, or on the inertial frame, that are alike.
pub(super) struct Branches {
    /// How many.
    pub(super) lanes: usize,
    /// For each of their bodies, on which branch it is, and where there.
    places: BTreeMap<BodyId, (usize, usize)>,
}

impl Branches {
    /// All that are alike; those further inward first.
    pub(super) fn of(tree: &Tree) -> Vec<Self> {
        let lowers = std::iter::once(None).chain(tree.body_ids().map(Some));
        let mut found = Vec::new();
        for lower in lowers {
            let uppers = tree.body_ids().filter(|&body| tree.lower(body) == lower);
            let uppers: Vec<BodyId> = uppers.collect();
            if uppers.len() < FEWEST {
                continue;
            }
            let mut kinds: BTreeMap<Vec<String>, Vec<Vec<BodyId>>> = BTreeMap::new();
            for upper in uppers {
                let mut bodies = Vec::new();
                let mut kind = Vec::new();
                branch(tree, upper, &mut bodies, &mut kind);
                kinds.entry(kind).or_default().push(bodies);
            }
            let mut alike: Vec<Vec<Vec<BodyId>>> = kinds.into_values().collect();
            alike.sort();
            alike.retain(|own| own.len() >= FEWEST);
            for own in &alike {
                let n_helpers = own.len().div_ceil(MOST);
                let start = |helper: usize| helper * own.len() / n_helpers;
                let helpers = (0..n_helpers).map(|helper| &own[start(helper)..start(helper + 1)]);
                found.extend(helpers.map(Self::those));
            }
        }
        found
    }

    fn those(branches: &[Vec<BodyId>]) -> Self {
        let mut places = BTreeMap::new();
        for (lane, bodies) in branches.iter().enumerate() {
            let bodies = bodies.iter().enumerate();
            places.extend(bodies.map(|(place, &body)| (body, (lane, place))));
        }
        Self {
            lanes: branches.len(),
            places,
        }
    }

    /// On which branch a body is, and where there.
    pub(super) fn place(&self, body: BodyId) -> Option<(usize, usize)> {
        self.places.get(&body).copied()
    }
}

/// The bodies of a branch, and what kind it is.
fn branch(tree: &Tree, body: BodyId, bodies: &mut Vec<BodyId>, kind: &mut Vec<String>) {
    bodies.push(body);
    let uppers = tree.uppers(body);
    kind.push(format!(
        "{} {}",
        moves(&tree.body(body).joint),
        uppers.len()
    ));
    for &upper in uppers {
        branch(tree, upper, bodies, kind);
    }
}

/// By which coordinates and speeds a joint moves.
fn moves(joint: &Joint) -> String {
    let coordinates = joint.coordinates().into_iter().map(|(name, _)| name);
    let motions = joint
        .speeds()
        .into_iter()
        .map(|(motion, _)| joint.motion_names()[motion]);
    coordinates.chain(motions).collect::<Vec<_>>().join(" ")
}
