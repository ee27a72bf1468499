//! The angles among a tree's coordinates: of which sines and cosines may be given.

use crate::id::{BodyId, CoordinateId};
use crate::tree::joint::CoordinateKind;
use crate::tree::system::Tree;

/// An angle among the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle {
    /// Its place in `q`.
    pub coordinate: CoordinateId,
    /// The body that it turns.
    pub body: BodyId,
    /// Which of the three, from 0.
    pub axis: usize,
}

impl Tree {
    /// The angles among the coordinates, in the order of `q`: each has the place of its sine and cosine.
    pub fn angles(&self) -> Vec<Angle> {
        let mut angles = Vec::new();
        for body in self.body_ids() {
            let own = self.body(body).joint.coordinates().into_iter();
            angles.extend(own.filter_map(|(kind, coordinate)| match kind {
                CoordinateKind::Angle(axis) => Some(Angle {
                    coordinate,
                    body,
                    axis,
                }),
                CoordinateKind::EulerParameter(_) | CoordinateKind::Translation(_) => None,
            }));
        }
        angles.sort_by_key(|angle| angle.coordinate);
        angles
    }
}
