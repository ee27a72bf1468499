//! How many terms the notes' sums over bodies have.

use crate::{id::BodyId, tree::Tree};

/// Eq. (42): for every body, one term for each pair of speeds that move it.
pub(super) fn of_matrix(tree: &Tree) -> usize {
    tree.body_ids()
        .map(|body| moving(tree, body))
        .map(|speeds| speeds * (speeds + 1) / 2)
        .sum()
}

/// Eqs. (36), (43): for every body, one term for each speed that moves it.
pub(super) fn of_vector(tree: &Tree) -> usize {
    tree.body_ids().map(|body| moving(tree, body)).sum()
}

/// The number of speeds on a body's path.
fn moving(tree: &Tree, body: BodyId) -> usize {
    let free = |body| {
        tree.body(body)
            .joint
            .motions()
            .into_iter()
            .flatten()
            .count()
    };
    tree.path(body).map(free).sum()
}
