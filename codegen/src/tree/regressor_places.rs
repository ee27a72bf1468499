//! Where the entries of a regressor stand, which has a row for each speed and ten columns for each body.

use std::collections::BTreeMap;

use super::{
    inertial::{InertialParameter, N_INERTIAL},
    system::Tree,
};
use crate::id::{BodyId, SpeedId};

/// Where the entry of a speed, a body and a parameter stands in a whole regressor.
pub fn regressor_place(tree: &Tree, speed: usize, body: BodyId, parameter: usize) -> usize {
    let own = InertialParameter {
        body,
        place: parameter,
    };
    speed * tree.bodies.len() * N_INERTIAL + own.column()
}

/// The row and the column, `10 body + parameter`, of each entry that the tree does not make zero, column after column: those of
/// the speeds that move a body, and of those that turn none of its joints in the columns of mass and first moment alone.
pub fn regressor_places(tree: &Tree) -> Vec<[usize; 2]> {
    let mut places = Vec::new();
    // Of each body the speeds that move it, and whether they turn it.
    let mut moving: Vec<BTreeMap<SpeedId, bool>> = Vec::with_capacity(tree.bodies.len());
    for (place, body) in tree.bodies.iter().enumerate() {
        let below = body.lower.map(|lower| moving[lower.index()].clone());
        let mut speeds = below.unwrap_or_default();
        for (motion, own) in body.joint.motions().into_iter().enumerate() {
            if let Some(own) = own {
                *speeds.entry(own.speed).or_default() |= motion < 3;
            }
        }
        for parameter in 0..N_INERTIAL {
            let column = place * N_INERTIAL + parameter;
            // A moment alone moves nothing that does not turn.
            let is_of_inertia = InertialParameter::INERTIAS.contains(&parameter);
            let felt = speeds.iter().filter(|&(_, turns)| *turns || !is_of_inertia);
            places.extend(felt.map(|(speed, _)| [speed.index(), column]));
        }
        moving.push(speeds);
    }
    places
}
