//! Units of coordinates, speeds and forces.

use super::joint::Joint;
use crate::functions::{FORCE, SPEED, Unit};

/// Units, each list as long as what it is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Units {
    /// Of each coordinate: "rad", "m", or "1" in a quaternion.
    pub coordinates: Vec<&'static str>,
    /// Of each speed: "rad/s" or "m/s".
    pub speeds: Vec<&'static str>,
    /// Of each generalized force: "N m" or "N".
    pub forces: Vec<&'static str>,
}

impl Units {
    /// Those of so many coordinates and speeds, each of which stands in one of the joints.
    pub(super) fn of(joints: &[Joint], n_coordinates: usize, n_speeds: usize) -> Self {
        let mut units = Self {
            coordinates: vec![""; n_coordinates],
            speeds: vec![""; n_speeds],
            forces: vec![""; n_speeds],
        };
        for joint in joints {
            for (place, coordinate) in joint.q.into_iter().enumerate() {
                let kind = joint.chart.coordinate(place);
                if let (Some(coordinate), Some(kind)) = (coordinate, kind) {
                    units.coordinates[coordinate] = kind.unit();
                }
            }
            for (motion, speed) in joint.u.into_iter().enumerate() {
                let Some(speed) = speed else { continue };
                // Three rotations, then three translations.
                let kind = motion / 3;
                (units.speeds[speed], units.forces[speed]) = (SPEED[kind], FORCE[kind]);
            }
        }
        units
    }

    /// Those of a unit that the model has.
    pub(crate) fn among(&self, unit: &Unit) -> Vec<String> {
        unit.among(&self.coordinates, &self.speeds)
    }
}
