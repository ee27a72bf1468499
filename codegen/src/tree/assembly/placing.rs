//! Where every written body stands in the body of the tree in which it is.
//!
//! In: values in the user's axes, exact rotations, and joints. Out: a [`Placed`] for every body. Afterwards: all of it is
//! along internal axes, those of the joint that moves it, with their origin where that joint sits.

use crate::geometry;
use crate::geometry::Rotation;
use crate::tree::assembly::settled::Settled;
use crate::tree::body::{Pose, RigidPart};
use crate::tree::joints::ResolvedJoint;
use crate::tree::offset::{Offset, Step};
use crate::tree::rotations::{ConstantRotations, snapped};
use crate::tree::value::Value;
use crate::tree::values::BodyValues;

/// A written body, in the internal axes of the body in which it is.
pub(super) struct Placed {
    /// Where its joint sits, in the internal axes of the body below.
    pub(super) seat: Seat,
    /// The user's axes and origin.
    pub(super) pose: Pose,
    /// What it is made of.
    pub(super) part: RigidPart,
}

/// Where a joint sits in the body below.
pub(super) struct Seat {
    /// From the internal axes of the body below to those of the joint's coordinates.
    pub(super) rotation: Rotation,
    /// From the internal origin of the body below.
    pub(super) attachment: Offset,
}

/// What a body is placed by.
struct Placing<'a> {
    values: &'a BodyValues,
    rotations: &'a ConstantRotations,
    joint: &'a ResolvedJoint,
    /// How near to 0, 1 or -1 entries of rotations become exact: of products, which rounding may have left near.
    snap: f64,
}

impl Placing<'_> {
    /// The body where the user's frame of the body below is at `below`.
    fn on(&self, below: &Pose) -> Placed {
        let seat = self.seat(below);
        let pose = self.pose(&seat);
        Placed {
            part: self.part(&pose),
            seat,
            pose,
        }
    }

    fn product(&self, first: &Rotation, second: &Rotation) -> Rotation {
        snapped(&geometry::then(first, second), self.snap).0
    }

    fn seat(&self, below: &Pose) -> Seat {
        let own = geometry::then(&self.rotations.attachment, &self.joint.align);
        let attachment = Offset::new(below.rotation, self.values.attachment);
        Seat {
            rotation: self.product(&below.rotation, &own),
            attachment: below.origin.clone().join(&attachment, false),
        }
    }

    /// The user's frame: in the body's own internal axes where the joint moves it, else in those of the body below.
    fn pose(&self, seat: &Seat) -> Pose {
        let back = geometry::transposed(&self.joint.align);
        let to_body = self.product(&back, &self.rotations.body);
        let (rotation, joint_origin) = if self.joint.is_fixed() {
            let turned = geometry::body_fixed_123(self.joint.locked(0));
            let turned = geometry::then(&seat.rotation, &turned);
            (self.product(&turned, &to_body), self.held(seat))
        } else {
            (to_body, Offset::default())
        };
        let origin = match self.values.body_attachment {
            Some(vector) => joint_origin.plus(Step {
                rotation,
                vector,
                negative: true,
            }),
            None => joint_origin,
        };
        Pose { rotation, origin }
    }

    /// Where the joint holds the body, from the internal origin of the body below.
    fn held(&self, seat: &Seat) -> Offset {
        let shift = self.joint.locked(3);
        let attachment = seat.attachment.clone();
        if shift == [0.0; 3] {
            return attachment;
        }
        let shift = Offset::new(seat.rotation, shift.map(Value::Baked));
        attachment.join(&shift, false)
    }

    fn part(&self, pose: &Pose) -> RigidPart {
        let center = Offset::new(geometry::IDENTITY, self.values.mass_center);
        let center = center.before(&pose.rotation);
        RigidPart {
            mass: self.values.mass,
            mass_center: pose.origin.clone().join(&center, false),
            inertia: self.values.inertia,
            axes: self.product(&pose.rotation, &self.rotations.inertia),
            lifted: self.values.lifted,
        }
    }
}

/// The written bodies where they stand, outward.
pub(super) fn place(settled: Settled<'_>, values: &[BodyValues]) -> Vec<Placed> {
    let Settled {
        outward,
        joints,
        rotations,
        snap,
        ..
    } = settled;
    let mut placed: Vec<Placed> = Vec::with_capacity(values.len());
    for ((&place, lower), values) in outward.places.iter().zip(&outward.lowers).zip(values) {
        let placing = Placing {
            values,
            rotations: &rotations[place],
            joint: &joints[place],
            snap,
        };
        let below = lower.map_or_else(Pose::internal, |lower| placed[lower].pose.clone());
        placed.push(placing.on(&below));
    }
    placed
}
