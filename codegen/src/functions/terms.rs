//! How many terms the notes' sums over bodies have.

use super::subject::{Subject, View};
use crate::tree::{Body, NamedFrame, Tree};

/// What the notes' sums of a function are.
#[derive(Clone, Copy, Debug)]
pub(super) enum Terms {
    /// Of so few terms that they are always derived.
    Few,
    /// Those of a vector, a term for each speed that moves a body.
    OfVector,
    /// Those of a matrix, a term for each pair of them.
    OfMatrix,
    /// Those along the path of a frame.
    OfPath,
}

impl Terms {
    /// How many there are at least.
    pub(super) fn least(self, tree: &Tree, subject: Option<&Subject>) -> usize {
        match self {
            Self::Few => 0,
            Self::OfVector => of_vector(tree),
            Self::OfMatrix => of_matrix(tree),
            Self::OfPath => subject.map_or(0, |subject| of_path(tree, subject)),
        }
    }
}

/// Eq. (42): for every body, one term for each pair of speeds that move it; those that others follow
/// count once.
fn of_matrix(tree: &Tree) -> usize {
    let pairs = |motions: usize| motions * (motions + 1) / 2;
    moving(tree).into_iter().map(pairs).sum()
}

/// Eqs. (36), (43): for every body, one term for each speed that moves it.
pub(super) fn of_vector(tree: &Tree) -> usize {
    moving(tree).into_iter().sum()
}

/// Eqs. (15), (28) along the path of a frame: for every body that turns, one term for each speed below it; of several frames the most.
/// None where a frame is seen from another, for what carries both is left out.
fn of_path(tree: &Tree, subject: &Subject) -> usize {
    let of_frame = |frame: NamedFrame| {
        let body = tree.frame_body(frame).into_iter();
        let path: Vec<_> = body.flat_map(|body| tree.path(body)).collect();
        let (mut below, mut terms) = (0, 0);
        for body in path.into_iter().rev().map(|body| tree.body(body)) {
            if body.joint.turns().iter().any(Option::is_some) {
                terms += below;
            }
            below += n_speeds(body);
        }
        terms
    };
    if subject.view == View::Other {
        return 0;
    }
    let frames = subject.frames.iter();
    frames.map(|own| of_frame(own.frame)).max().unwrap_or(0)
}

/// The pairs of speeds that move a body in common, each once.
pub(super) fn pairs(tree: &Tree) -> usize {
    let of_body = |(body, moving): (&Body, usize)| {
        let own = body.joint.speeds().len();
        (moving - own..moving).map(|below| below + 1).sum::<usize>()
    };
    tree.bodies.iter().zip(moving(tree)).map(of_body).sum()
}

/// The pairs of speeds of one tree at the root, each once.
pub(super) fn pairs_of_trees(tree: &Tree) -> usize {
    let mut roots: Vec<usize> = Vec::with_capacity(tree.bodies.len());
    let mut speeds = vec![0; tree.bodies.len()];
    for (place, body) in tree.bodies.iter().enumerate() {
        let root = body.lower.map_or(place, |lower| roots[lower.index()]);
        roots.push(root);
        speeds[root] += n_speeds(body);
    }
    speeds.into_iter().map(|n| n * (n + 1) / 2).sum()
}

fn n_speeds(body: &Body) -> usize {
    body.joint.speeds().len()
}

/// For every body the number of joints' own speeds on its path.
fn moving(tree: &Tree) -> Vec<usize> {
    let mut moving: Vec<usize> = Vec::with_capacity(tree.bodies.len());
    for body in &tree.bodies {
        let below = body.lower.map_or(0, |lower| moving[lower.index()]);
        moving.push(below + n_speeds(body));
    }
    moving
}
