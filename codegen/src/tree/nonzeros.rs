//! How much of a tree is neither zero nor one: what makes operations.
//!
//! In: a tree. Out: a count, for one tree beside another of the same bodies. Does not: count operations.

use crate::geometry::{self, Rotation};
use crate::tree::body::RigidPart;
use crate::tree::system::Tree;

/// Part of a body's largest component of an inertia, below which one is a crumb of rounding.
const ROUNDING: f64 = 1e-15;

/// How many entries of constant rotations are not 0, 1 or -1, and how many components of offsets and inertias are not zero.
pub(crate) fn count(tree: &Tree) -> usize {
    let not_zero = |vector: [f64; 3]| vector.into_iter().filter(|part| *part != 0.0).count();
    let bodies = tree.bodies.iter().map(|body| {
        let offset = not_zero(body.joint.attachment.nominal(&tree.parameters));
        let parts = body.parts.iter().map(|part| {
            not_zero(part.mass_center.nominal(&tree.parameters)) + of_inertia(tree, part)
        });
        of_rotation(&body.joint.rotation) + offset + parts.sum::<usize>()
    });
    let frames = tree.frames.iter().chain(&tree.markers);
    let frames = frames.map(|frame| of_rotation(&frame.pose.rotation));
    bodies.sum::<usize>() + frames.sum::<usize>()
}

fn of_rotation(rotation: &Rotation) -> usize {
    let entries = rotation.iter().flatten();
    entries
        .filter(|entry| **entry != 0.0 && entry.abs() != 1.0)
        .count()
}

/// Components along the internal axes of the body.
fn of_inertia(tree: &Tree, part: &RigidPart) -> usize {
    let own = &part.inertia;
    let rows = [
        [own.xx, own.xy, own.xz],
        [own.xy, own.yy, own.yz],
        [own.xz, own.yz, own.zz],
    ];
    let tensor = rows.map(|row| row.map(|value| tree.nominal(value)));
    let turned = geometry::then(
        &part.axes,
        &geometry::then(&tensor, &geometry::transposed(&part.axes)),
    );
    let largest = turned
        .iter()
        .flatten()
        .fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let entries = turned.iter().flatten();
    entries
        .filter(|entry| entry.abs() > ROUNDING * largest)
        .count()
}
