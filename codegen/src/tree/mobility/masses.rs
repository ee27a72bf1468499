//! What masses do with a twist: rows whose squares on it sum to twice the energy.

use crate::geometry::{self, Vector, cross};
use crate::id::BodyId;
use crate::principal::principal;
use crate::tree::body::RigidPart;
use crate::tree::mobility::rows::{Twist, dot};
use crate::tree::mobility::units::Units;
use crate::tree::system::Tree;

/// The mass of a body, and of what is beyond it: rows K whose squares on the twist sum to twice the energy, and bounds of them.
#[derive(Clone, Default)]
pub(crate) struct Masses {
    pub(crate) rows: Vec<Twist>,
    pub(super) mass: f64,
    /// The most that a unit angular velocity about the origin could move.
    pub(super) turning: f64,
}

/// The rows of a body's own mass and inertia.
pub(crate) fn own(tree: &Tree, units: &Units, body: BodyId) -> Masses {
    let mut all = Masses::default();
    for part in &tree.body(body).parts {
        let one = own_part(tree, units, part);
        all.rows.extend(one.rows);
        all.mass += one.mass;
        all.turning = (all.turning * all.turning + one.turning * one.turning).sqrt();
    }
    all
}

fn own_part(tree: &Tree, units: &Units, part: &RigidPart) -> Masses {
    let mass = tree.nominal(part.mass) / units.mass;
    let center = part
        .mass_center
        .nominal(&tree.parameters)
        .map(|part| part / units.length);
    let mut rows = Vec::with_capacity(6);
    for axis in 0..3 {
        // Component `axis` of v + w x r, which is v + r . (axis x w).
        let mut unit = [0.0; 3];
        unit[axis] = mass.sqrt();
        let [wx, wy, wz] = cross(center, unit);
        rows.push([wx, wy, wz, unit[0], unit[1], unit[2]]);
    }
    let turning = turning(tree, units, part);
    rows.extend(turning.map(|(moment, axis)| turned(moment, axis)));
    let trace: f64 = turning.iter().map(|(moment, _)| moment.max(0.0)).sum();
    Masses {
        rows,
        mass,
        turning: (trace + mass * dot(&center, &center)).sqrt(),
    }
}

/// The principal moments and axes of a part, in the internal axes of its body.
fn turning(tree: &Tree, units: &Units, part: &RigidPart) -> [(f64, Vector); 3] {
    let tensor = part.inertia;
    let tensor = [
        tensor.xx, tensor.yy, tensor.zz, tensor.xy, tensor.xz, tensor.yz,
    ];
    let tensor = tensor.map(|value| tree.nominal(value) / units.mass / units.length / units.length);
    let (moments, axes) = principal(tensor);
    let back = geometry::transposed(&part.axes);
    std::array::from_fn(|i| (moments[i], geometry::apply(&back, axes[i])))
}

/// The row of a principal moment; zero for one below zero.
fn turned(moment: f64, axis: Vector) -> Twist {
    let root = moment.max(0.0).sqrt();
    let [x, y, z] = axis.map(|component| root * component);
    [x, y, z, 0.0, 0.0, 0.0]
}

/// The rows of what a body lacks: principal moments below zero, whose squares on a twist are taken from twice the energy.
pub(super) fn debts(tree: &Tree, units: &Units, body: BodyId) -> Vec<Twist> {
    let parts = tree.body(body).parts.iter();
    let moments = parts.flat_map(|part| turning(tree, units, part));
    let below_zero = moments.filter(|(moment, _)| *moment < 0.0);
    below_zero
        .map(|(moment, axis)| turned(-moment, axis))
        .collect()
}
