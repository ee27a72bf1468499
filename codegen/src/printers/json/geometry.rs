//! Joints and frames, as records of a manifest.

use super::syntax::{list, number, object, optional, string, strings};
use crate::{
    geometry::{Rotation, Vector},
    listing::{Frame, Joint, Mimic, Moved, Turned},
};

/// A record on one line; what a joint does not have is left out.
pub(super) fn joint(joint: &Joint) -> String {
    let kind = joint.kind.map_or_else(|| optional(None), string);
    let mut members = vec![
        ("name", string(&joint.name)),
        ("kind", kind),
        ("chart", string(joint.chart.name())),
        ("q", list(joint.q.map(optional))),
        ("u", list(joint.u.map(optional))),
        ("axes", rotation(&joint.axes)),
        ("body_axes", rotation(&joint.body_axes)),
        ("position", vector(&joint.position)),
        ("body_position", vector(&joint.body_position)),
    ];
    members.extend(moved_by(&joint.moved));
    members.extend(joint.mimic.as_ref().map(|own| ("mimic", mimic(own))));
    if !joint.locked.is_empty() {
        let locked = joint.locked.iter();
        let locked: Vec<(&str, String)> = locked
            .map(|(name, value)| (*name, number(*value)))
            .collect();
        members.push(("locked", object(&locked)));
    }
    object(&members)
}

/// The same of a frame.
pub(super) fn frame(frame: &Frame) -> String {
    let mut members = vec![
        ("name", string(&frame.name)),
        ("identifier", string(&frame.identifier)),
        ("body", optional(frame.body)),
        ("rotation", rotation(&frame.rotation)),
        ("position", vector(&frame.position)),
    ];
    members.extend(moved_by(&frame.moved));
    members.extend(frame.turned.as_ref().map(|own| ("turned_by", turned(own))));
    object(&members)
}

fn mimic(mimic: &Mimic) -> String {
    object(&[
        ("coordinate", string(mimic.coordinate)),
        ("joint", string(&mimic.joint)),
        ("leader", mimic.leader.to_string()),
        ("multiplier", number(mimic.multiplier)),
        ("offset", number(mimic.offset)),
    ])
}

fn moved_by(moved: &[Moved]) -> Option<(&'static str, String)> {
    let record = |one: &Moved| {
        object(&[
            ("parameter", string(&one.parameter)),
            ("along", vector(&one.along)),
        ])
    };
    (!moved.is_empty()).then(|| ("moved_by", list(moved.iter().map(record))))
}

fn turned(turned: &Turned) -> String {
    object(&[
        ("parameters", list(turned.parameters.iter().map(strings))),
        ("after", rotation(&turned.after)),
    ])
}

fn rotation(rotation: &Rotation) -> String {
    list(rotation.iter().map(vector))
}

fn vector(vector: &Vector) -> String {
    list(vector.map(number))
}
