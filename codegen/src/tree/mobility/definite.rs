//! Whether the mass matrix can be positive definite where principal moments are below zero.
//!
//! What such moments take away, what else moves may outweigh: in all states, in some, or in none. Here the matrix is
//! written down at a few seeded states and factorised, which is cubic in the speeds; of a system of very many, nothing is
//! said. One state in which it is positive definite is enough.

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::limits::FOLLOWING;
use crate::random::Random;
use crate::tree::Tree;
use crate::tree::mobility::following::{Weighed, places, state, velocities};
use crate::tree::mobility::masses::debts;
use crate::tree::mobility::rows::dot;
use crate::tree::mobility::units::Units;

/// The states that are tried.
const STATES: u64 = 8;

/// A motion that has energy below zero when all others move with it as they like, in each of a few seeded states; `None`
/// where there is a state without.
pub(super) fn indefinite(tree: &Tree) -> Option<(BodyId, CoordinateName)> {
    let units = Units::of(tree);
    if tree.bodies.len().max(tree.n_speeds) > FOLLOWING
        || tree
            .body_ids()
            .all(|body| debts(tree, &units, body).is_empty())
    {
        return None;
    }
    let mut first = None;
    for seed in 1..=STATES {
        let speed = below_zero(mass_matrix(tree, &units, &mut Random::new(seed)))?;
        first.get_or_insert(speed);
    }
    Some(places(tree)[first?])
}

/// The mass matrix at a state that `random` chooses.
fn mass_matrix(tree: &Tree, units: &Units, random: &mut Random) -> Vec<Vec<f64>> {
    let q = state(tree, units, random);
    let [moved, lacking] = [Weighed::Masses, Weighed::Debts]
        .map(|weighed| velocities(tree, units, &q, weighed).columns);
    let entry = |i: usize, j: usize| dot(&moved[i], &moved[j]) - dot(&lacking[i], &lacking[j]);
    let row = |i: usize| (0..tree.n_speeds).map(|j| entry(i, j)).collect();
    (0..tree.n_speeds).map(row).collect()
}

/// The first speed, from the tips inward, whose pivot is not above zero.
fn below_zero(mut matrix: Vec<Vec<f64>>) -> Option<usize> {
    for pivot in (0..matrix.len()).rev() {
        let (before, after) = matrix.split_at_mut(pivot);
        let row = &after[0];
        if row[pivot] <= 0.0 {
            return Some(pivot);
        }
        for other in before {
            let factor = other[pivot] / row[pivot];
            let pairs = other.iter_mut().zip(row).take(pivot);
            pairs.for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    None
}
