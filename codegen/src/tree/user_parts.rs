//! The parts of a body as its user describes them: along the user's axes, from the user's origin.

use crate::geometry::{self, Rotation};
use crate::tree::body::{Body, Pose, RigidPart};
use crate::tree::rotations::snapped;

/// What rounding leaves of the zeros of a product of two rotations, with room.
const ROUNDING: f64 = 1e-14;

/// The parts, where the user's axes and origin are the internal ones.
pub fn user_parts(body: &Body) -> Vec<RigidPart> {
    let parts = body.parts.iter();
    parts.map(|part| seen_from(&body.pose, part)).collect()
}

fn seen_from(pose: &Pose, part: &RigidPart) -> RigidPart {
    let back = geometry::transposed(&pose.rotation);
    let turned = |rotation: &Rotation| snapped(&geometry::then(&back, rotation), ROUNDING).0;
    let center = part.mass_center.less(&pose.origin);
    RigidPart {
        mass_center: center.with_rotations(turned),
        axes: turned(&part.axes),
        ..part.clone()
    }
}
