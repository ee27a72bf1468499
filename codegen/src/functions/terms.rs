//! How many terms the notes' sums over bodies have.

use crate::tree::{Body, Tree};

/// Eq. (42): for every body, one term for each pair of speeds that move it; those that others follow
/// count once.
pub(super) fn of_matrix(tree: &Tree) -> usize {
    let pairs = |motions: usize| motions * (motions + 1) / 2;
    moving(tree).into_iter().map(pairs).sum()
}

/// Eqs. (36), (43): for every body, one term for each speed that moves it.
pub(super) fn of_vector(tree: &Tree) -> usize {
    moving(tree).into_iter().sum()
}

/// The pairs of speeds that move a body in common, each once.
pub(super) fn pairs(tree: &Tree) -> usize {
    let of_body = |(body, moving): (&Body, usize)| {
        let own = body.joint.speeds().len();
        (moving - own..moving).map(|below| below + 1).sum::<usize>()
    };
    tree.bodies.iter().zip(moving(tree)).map(of_body).sum()
}

/// For every body the number of joints' own speeds on its path.
fn moving(tree: &Tree) -> Vec<usize> {
    let mut moving: Vec<usize> = Vec::with_capacity(tree.bodies.len());
    for body in &tree.bodies {
        let below = body.lower.map_or(0, |lower| moving[lower.index()]);
        moving.push(below + body.joint.speeds().len());
    }
    moving
}
