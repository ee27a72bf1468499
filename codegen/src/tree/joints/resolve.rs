//! Joints as written become six motions, each free or held, between two constant frames.
//!
//! In: kinds, exact axes, lists of coordinates. Out: a [`ResolvedJoint`] for every body.
//! Afterwards: every free motion is about or along a coordinate axis of the joint's aligned frame.
//! Does not: judge what is free; that is `rules`.

use crate::description::{Chart, Description, JointKind, Speeds, WrittenJoint};
use crate::diagnostic::Span;
use crate::geometry;
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};
use crate::tree::names;
use crate::tree::rotations::ConstantRotations;

/// The joint of every body; `None` for one that is not known, which is then a fault.
pub(crate) fn joints(
    description: &Description,
    rotations: &[ConstantRotations],
) -> Vec<Option<ResolvedJoint>> {
    let identifiers = names::joint_identifiers(description);
    let joints = description.bodies.iter().zip(rotations).zip(identifiers);
    joints
        .map(|((body, rotations), identifier)| resolved(&body.joint, rotations, identifier))
        .collect()
}

fn resolved(
    joint: &WrittenJoint,
    rotations: &ConstantRotations,
    identifier: String,
) -> Option<ResolvedJoint> {
    let kind = joint.kind.as_ref()?;
    let (align, place) = match &rotations.axis {
        Some(axis) => (axis.rotation, axis.place),
        None if kind.value.has_axis() => return None,
        None => (geometry::IDENTITY, 0),
    };
    let mut motions = [Freedom::Locked(0.0); 6];
    for (axis, value) in &joint.locked {
        motions[axis.value.index()] = Freedom::Locked(value.as_ref()?.value);
    }
    for (motion, span) in free(&kind.value, place, kind.span) {
        motions[motion] = Freedom::Free(span);
    }
    let chart = joint.chart.map_or(Chart::Angles, |chart| chart.value);
    let natural = match chart {
        Chart::Angles => Speeds::Rates,
        Chart::Quaternion => Speeds::AngularVelocity,
    };
    let mut free = (0..6).filter(|motion| matches!(motions[*motion], Freedom::Free(_)));
    let leading = free.next().filter(|_| free.next().is_none());
    Some(ResolvedJoint {
        align,
        motions,
        chart,
        speeds: joint.speeds.map_or(natural, |speeds| speeds.value),
        identifier,
        leading,
    })
}

/// The free motions of a kind of joint, given the place of its axis, and where they are written.
fn free(kind: &JointKind, place: usize, span: Span) -> Vec<(usize, Span)> {
    if let JointKind::List(axes) = kind {
        let places = axes.iter().map(|axis| (axis.value.index(), axis.span));
        return places.collect();
    }
    let motions = motions(kind, place).into_iter();
    motions.map(|motion| (motion, span)).collect()
}

/// The motions that a kind of joint leaves free, given the place of its axis.
fn motions(kind: &JointKind, place: usize) -> Vec<usize> {
    let others = ((place + 1) % 3, (place + 2) % 3);
    match kind {
        JointKind::Fixed => vec![],
        JointKind::Revolute | JointKind::Continuous => vec![place],
        JointKind::Prismatic => vec![3 + place],
        JointKind::Cylindrical => vec![place, 3 + place],
        JointKind::Planar => vec![place, 3 + others.0, 3 + others.1],
        JointKind::Universal => vec![0, 1],
        JointKind::Spherical => vec![0, 1, 2],
        JointKind::Free => vec![0, 1, 2, 3, 4, 5],
        JointKind::List(axes) => axes.iter().map(|axis| axis.value.index()).collect(),
    }
}

/// The name of the kind of joint that leaves these motions free, about whichever axis; of two kinds the one that says more.
pub(crate) fn kind_of(moving: [bool; 6], has_limits: bool) -> Option<&'static str> {
    let leaves = |kind: &JointKind| {
        (0..3).any(|place| {
            let motions = motions(kind, place);
            (0..6).all(|motion| motions.contains(&motion) == moving[motion])
        })
    };
    let may_be = |kind: &JointKind| *kind != JointKind::Continuous || !has_limits;
    let mut named = JointKind::NAMED.iter();
    let last = named.rfind(|(_, kind)| may_be(kind) && leaves(kind));
    last.map(|(name, _)| *name)
}
