//! Numbers that were computed from others fit a float.

use crate::description::xml::Reader;
use crate::description::{Given, Optional, Rotation, Scalar, WrittenBody};
use crate::diagnostic::{Diagnostic, shown};

/// Reports the bodies of which a number became infinite on the way.
pub(super) fn check(reader: &mut Reader, bodies: &[WrittenBody]) {
    for body in bodies {
        let joint = &body.joint;
        let at_body = joint.body_attachment.unwrap_or([None; 3]);
        let mass = std::iter::once(&body.mass).chain(&body.mass_center);
        let seat = joint.attachment.iter().chain(&at_body);
        let numbers = mass.chain(&body.inertia).chain(seat);
        let finite = numbers.copied().all(is_finite)
            && joint
                .axis
                .is_none_or(|axis| axis.value.iter().all(|entry| entry.is_finite()))
            && are_finite(body.inertia_rotation)
            && are_finite(joint.attachment_rotation);
        if !finite {
            let name = body.name.as_ref();
            let name = name.map_or(String::new(), |name| {
                format!(" of body `{}`", shown(&name.value))
            });
            let message = format!(
                "the numbers{name} are too large: what follows from them does not fit a 64-bit float"
            );
            let fault = Diagnostic::error(message).at(body.span, "too large");
            reader.faults.push(fault);
        }
    }
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
