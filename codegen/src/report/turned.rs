//! Joints whose axes point elsewhere: a coordinate's sign is another, and code that uses it goes on and is wrong.
//!
//! In: two outlines. Out: each such joint with its axis before and after. Bodies are the same as in their `Differences`.

use super::{
    differences::Differences,
    meaning::Meaning,
    outline::{AXIS, Outline},
};
use crate::geometry;

/// Joints whose axes turned by more than a right angle, seen from both of their bodies: where one of these alone has other axes, no sign changes.
pub fn turned(old: &Outline, new: &Outline, differences: &Differences) -> Vec<Meaning> {
    let axes = |outline: &Outline, body: &str| {
        let body = outline.bodies.iter().find(|own| own.name == body)?;
        Some((body.axis?, body.values.get(AXIS)?.clone()))
    };
    let changed = new.bodies.iter().filter_map(|body| {
        let old_name = differences.old_name(&body.name).unwrap_or(&body.name);
        let (old_axes, old_text) = axes(old, old_name)?;
        let (new_axes, new_text) = axes(new, &body.name)?;
        let mut pairs = old_axes.into_iter().zip(new_axes);
        let is_turned = pairs.all(|(old, new)| geometry::dot(old, new) < 0.0);
        let joint = body.values.get("joint_name").unwrap_or(&body.name);
        is_turned.then(|| Meaning {
            name: format!("direction of q, u and tau of {joint}"),
            old: format!("axis {old_text}"),
            new: format!("axis {new_text}"),
        })
    });
    changed.collect()
}
