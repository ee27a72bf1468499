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

/// Where which units stand: "Units by place: none at 0 to 3; m at 4 to 6; else rad". What most places have is said last.
pub(in crate::listing) fn by_place(units: &[&'static str]) -> String {
    let mut places: Vec<(&str, Vec<usize>)> = Vec::new();
    for (place, unit) in units.iter().enumerate() {
        let unit = if *unit == "1" { "none" } else { unit };
        match places.iter_mut().find(|(known, _)| *known == unit) {
            Some((_, places)) => places.push(place),
            None => places.push((unit, vec![place])),
        }
    }
    let most = places.iter().map(|(_, places)| places.len()).max();
    let Some(most) = places.iter().position(|(_, own)| Some(own.len()) == most) else {
        return "Unit: none".to_owned();
    };
    let (common, _) = places.remove(most);
    if places.is_empty() {
        return format!("Unit: {common}");
    }
    let others = places
        .iter()
        .map(|(unit, places)| format!("{unit} at {}", ranges(places)));
    let others: Vec<String> = others.collect();
    format!("Units by place: {}; else {common}", others.join("; "))
}

/// Increasing numbers, "0, 4 to 6" for 0, 4, 5 and 6.
fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|one, next| one + 1 == *next);
    let runs = runs.map(|run| match run {
        [only] => only.to_string(),
        [first, last] => format!("{first}, {last}"),
        [first, .., last] => format!("{first} to {last}"),
        [] => String::new(),
    });
    runs.collect::<Vec<String>>().join(", ")
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
