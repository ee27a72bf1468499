//! Numbers that were computed from others fit a float.

use crate::description::xml::Reader;
use crate::description::{
    FrameRotation, Given, Optional, PerCoordinate, Rotation, Scalar, WrittenBody, WrittenFrame,
};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// Reports the bodies and frames of which a number became infinite on the way.
pub(super) fn check(reader: &mut Reader, bodies: &[WrittenBody], frames: &[WrittenFrame]) {
    let bodies = bodies.iter().filter(|body| !body_is_finite(body));
    let bodies = bodies.map(|body| ("body", &body.name, body.span));
    let frames = frames.iter().filter(|frame| !frame_is_finite(frame));
    let frames = frames.map(|frame| ("site", &frame.name, frame.span));
    for (kind, name, span) in bodies.chain(frames) {
        let name = name.as_ref();
        let name = name.map_or(String::new(), |name| {
            format!(" of {kind} `{}`", shown(&name.value))
        });
        let message = format!(
            "the numbers{name} are too large: what follows from them does not fit a 64-bit float"
        );
        let fault = Diagnostic::error(message).at(span, "too large");
        reader.faults.push(fault);
    }
}

fn body_is_finite(body: &WrittenBody) -> bool {
    let joint = &body.joint;
    let at_body = joint.body_attachment.unwrap_or([None; 3]);
    let mass = std::iter::once(&body.mass).chain(&body.mass_center);
    let seat = joint.attachment.iter().chain(&at_body);
    let numbers = mass.chain(&body.inertia).chain(seat);
    let acting = [
        &joint.stiffness,
        &joint.rest,
        &joint.damping,
        &joint.armature,
    ];
    let axis = joint.axis.iter().flat_map(|axis| axis.value);
    let mimic = joint.mimic.iter().map(|mimic| &mimic.value);
    let mimic = mimic.flat_map(|mimic| [mimic.multiplier, mimic.offset]);
    numbers.copied().all(is_finite)
        && acting.into_iter().all(all_are_finite)
        && axis.chain(mimic).all(f64::is_finite)
        && are_finite(body.inertia_rotation)
        && are_finite(joint.attachment_rotation)
}

fn frame_is_finite(frame: &WrittenFrame) -> bool {
    let rotation = frame.rotation.as_ref();
    let rotation = rotation.and_then(|rotation| match rotation.value {
        FrameRotation::Baked(baked) => Some(Spanned::new(baked, rotation.span)),
        FrameRotation::Runtime(_) => None,
    });
    frame.position.iter().copied().all(is_finite) && are_finite(rotation)
}

fn all_are_finite(numbers: &PerCoordinate<Scalar>) -> bool {
    let mut numbers = (0..6).filter_map(|place| numbers.at(place));
    numbers.all(|number| number.nominal().is_finite())
}

fn is_finite(number: Given<Scalar>) -> bool {
    number.is_none_or(|number| number.value.nominal().is_finite())
}

fn are_finite(rotation: Optional<Rotation>) -> bool {
    rotation.is_none_or(|rotation| {
        rotation
            .value
            .iter()
            .flatten()
            .all(|entry| entry.is_finite())
    })
}
