//! Where joints sit.

use crate::description::mjcf::joints::JointElement;
use crate::description::mjcf::joints::joint_type::JointType;
use crate::description::mjcf::mass::inertial::baked;
use crate::description::mjcf::placement::{Placement, about};
use crate::description::{Given, JointKind, Optional, Rotation, Scalar, WrittenJoint};
use crate::diagnostic::{Span, Spanned};
use crate::geometry::{IDENTITY, Vector, scaled, then};

/// The joint of a body that is part of its lower body, at this place.
pub(in crate::description::mjcf) fn fixed(place: &Placement, span: Span) -> WrittenJoint {
    let kind = Some(Spanned::new(JointKind::Fixed, span));
    WrittenJoint {
        attachment_rotation: rotation(place, span),
        ..WrittenJoint::new(kind, vector(place.position, span))
    }
}

/// The joint where it sits: MuJoCo turns (shifts) the body from where it stands, about (along) the joint's axis through
/// its anchor, by the coordinate less the reference.
pub(in crate::description::mjcf) fn joined(
    element: &JointElement,
    place: &Placement,
    span: Span,
) -> WrittenJoint {
    let seat = seat(element, place);
    let has_anchor = matches!(element.kind, JointType::Hinge | JointType::Ball);
    let anchor = element.anchor;
    let body_attachment = (has_anchor && anchor != [0.0; 3]).then(|| vector(anchor, element.span));
    WrittenJoint {
        attachment_rotation: rotation(&seat, span),
        body_attachment,
        ..element.written(vector(seat.position, span))
    }
}

/// The joint as a fixed one, so far from where the body stands; rad, m.
pub(in crate::description::mjcf) fn held(
    element: &JointElement,
    place: &Placement,
    span: Span,
    by: f64,
) -> WrittenJoint {
    let moved = element.with_reference(-by);
    let joined = joined(&moved, place, span);
    WrittenJoint {
        name: joined.name,
        attachment_rotation: joined.attachment_rotation,
        body_attachment: joined.body_attachment,
        ..WrittenJoint::new(
            Some(Spanned::new(JointKind::Fixed, element.span)),
            joined.attachment,
        )
    }
}

fn seat(element: &JointElement, place: &Placement) -> Placement {
    let anchored = Placement {
        position: place.point(element.anchor),
        rotation: place.rotation,
    };
    match (element.kind, element.axis) {
        // Its coordinates are those of the body in the world, whatever its reference pose.
        (JointType::Free, _) => Placement::SAME,
        (JointType::Hinge, Some(axis)) if element.reference != 0.0 => {
            let [sine, cosine] = element.reference_turn;
            Placement {
                rotation: then(&place.rotation, &about(axis, [-sine, cosine])),
                ..anchored
            }
        }
        // Where along its line a slide sits makes no difference.
        (JointType::Slide, Some(axis)) => Placement {
            position: place.point(scaled(axis, -element.reference)),
            ..anchored
        },
        _ => anchored,
    }
}

fn rotation(place: &Placement, span: Span) -> Optional<Rotation> {
    (place.rotation != IDENTITY).then(|| Spanned::new(place.rotation, span))
}

fn vector(vector: Vector, span: Span) -> [Given<Scalar>; 3] {
    vector.map(|entry| Some(baked(Spanned::new(entry, span))))
}
