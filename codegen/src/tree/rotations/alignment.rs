//! Axes that have a joint's axis among them.

use crate::geometry::{IDENTITY, Rotation, Vector, cross, dot, length};

/// An axis that leans less from a coordinate axis has the directions of this one.
const ALONG: f64 = 1e-9;

/// Axes of which one is that of a joint.
#[derive(Clone, Copy, Debug)]
pub struct Alignment {
    /// From the joint's axes, as written, to these.
    pub rotation: Rotation,
    /// Which of these the joint's axis is.
    pub place: usize,
}

impl Alignment {
    /// Axes with `axis` (of any length) among them, as few of them turned as possible, and by how much snapping changed an
    /// entry of the axis. About a coordinate axis, or its opposite, its place is its own.
    pub fn of(axis: Vector, tolerance: f64) -> (Self, f64) {
        let given = unit(axis);
        let unit = snapped_unit(given, tolerance);
        let change = largest_change(given, unit);
        // What is 1 may be rounded: the others must be zero.
        let is_along = |place: usize| (0..3).all(|i| (i == place) != (unit[i] == 0.0));
        if let Some(place) = (0..3).find(|&place| is_along(place)) {
            let mut turned = IDENTITY;
            if unit[place] < 0.0 {
                // Half a turn about the next axis.
                turned[place][place] = -1.0;
                turned[(place + 2) % 3][(place + 2) % 3] = -1.0;
            }
            return (
                Self {
                    rotation: turned,
                    place,
                },
                change,
            );
        }
        // The other two: normal to the axis and to the coordinate axis along which it has least, and normal to both.
        let least = (0..3).fold(0, |least, i| {
            if unit[i].abs() < unit[least].abs() {
                i
            } else {
                least
            }
        });
        let mut along = [0.0; 3];
        along[least] = 1.0;
        let first = cross(along, unit);
        let size = length(first);
        let first = first.map(|part| part / size);
        let rotation = [first, cross(unit, first), unit];
        (Self { rotation, place: 2 }, change)
    }

    /// The same of an axis across which two directions count: whatever the tolerance, they follow from what the axis is within
    /// 1e-9.
    pub fn with_directions(axis: Vector, tolerance: f64) -> (Self, f64) {
        let (along, _) = Self::of(axis, ALONG);
        let given = unit(axis);
        let unit = snapped_unit(given, tolerance);
        let change = largest_change(given, unit);
        let Self {
            mut rotation,
            place,
        } = along;
        if rotation[place] != unit {
            let (next, last) = ((place + 1) % 3, (place + 2) % 3);
            let lean = dot(rotation[next], unit);
            let across = std::array::from_fn(|i| rotation[next][i] - lean * unit[i]);
            let size = length(across);
            rotation[place] = unit;
            rotation[next] = across.map(|part| part / size);
            rotation[last] = cross(unit, rotation[next]);
        }
        (Self { rotation, place }, change)
    }
}

/// A vector of any length but zero, of length one.
fn unit(vector: Vector) -> Vector {
    let parts = vector.iter();
    let largest = parts.fold(0.0, |most: f64, part| most.max(part.abs()));
    // Scaled first, so that no square overflows or vanishes.
    let scaled = vector.map(|part| part / largest);
    let size = length(scaled);
    scaled.map(|part| part / size)
}

/// A unit vector with its entries near zero made exact.
fn snapped_unit(unit: Vector, tolerance: f64) -> Vector {
    let pinned = unit.map(|part| if part.abs() < tolerance { 0.0 } else { part });
    if pinned == unit {
        return unit;
    }
    let size = length(pinned);
    pinned.map(|part| part / size)
}

/// The largest change of an entry.
fn largest_change(old: Vector, new: Vector) -> f64 {
    (0..3).fold(0.0, |most: f64, i| most.max((new[i] - old[i]).abs()))
}
