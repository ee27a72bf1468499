//! Rotations and axes that are nearly exact, but not so nearly as is asked for: what rounded right angles leave.
//!
//! In: a description, and the tolerance that it is read with. Out: the tolerance that would take them, and what it would
//! change. Does not: change anything.

use crate::description::Description;
use crate::geometry::{Rotation, Vector, cross, dot, length, transposed};
use crate::tree::rotations::exact::{ConstantRotations, exact};

/// The tolerances that are proposed: the greatest covers what three digits after the point leave of a right angle.
const TOLERANCES: [f64; 5] = [1e-8, 1e-7, 1e-6, 1e-5, 1e-4];

/// A tolerance that makes more exact, and what it turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearlyExact {
    /// The tolerance.
    pub snap: f64,
    /// The largest angle by which it turns an axis, rad.
    pub angle: f64,
}

/// The least tolerance, of powers of ten up to 1e-4, that makes exact all that 1e-4 does; `None` where `snap` does already.
pub fn nearly_exact(description: &Description, snap: f64) -> Option<NearlyExact> {
    let [.., most] = TOLERANCES;
    if snap >= most {
        return None;
    }
    let at = |tolerance: f64| exact(description, tolerance).0;
    let all = at(most);
    let angle = turned(&at(snap), &all);
    let is_as_all = |tolerance: &f64| *tolerance > snap && turned(&at(*tolerance), &all) == 0.0;
    let snap = TOLERANCES.into_iter().find(is_as_all)?;
    (angle > 0.0).then_some(NearlyExact { snap, angle })
}

/// The largest angle between rotations, or axes, of one and the other.
fn turned(one: &[ConstantRotations], other: &[ConstantRotations]) -> f64 {
    let angles = one.iter().zip(other).map(|(one, other)| {
        let axes = one.axis.iter().zip(&other.axis);
        let axes =
            axes.map(|(one, other)| between(one.rotation[one.place], other.rotation[other.place]));
        let rotations = [
            (&one.inertia, &other.inertia),
            (&one.attachment, &other.attachment),
            (&one.body, &other.body),
        ];
        let rotations = rotations.map(|(one, other)| about(one, other));
        axes.chain(rotations).fold(0.0, f64::max)
    });
    angles.fold(0.0, f64::max)
}

/// The angle between two unit vectors that are near one another.
fn between(one: Vector, other: Vector) -> f64 {
    libm::asin(length(cross(one, other)).min(1.0))
}

/// The angle of the rotation from one to another that is near it.
fn about(one: &Rotation, other: &Rotation) -> f64 {
    let (one, other) = (transposed(one), transposed(other));
    // The part of R^T R' that is not symmetric is the sine times the axis.
    let entry = |i: usize, j: usize| dot(one[i], other[j]);
    let part = |i: usize, j: usize| (entry(i, j) - entry(j, i)) / 2.0;
    libm::asin(length([part(1, 2), part(2, 0), part(0, 1)]).min(1.0))
}
