//! How messages call what a description names.

use crate::description::Description;
use crate::diagnostic::Escaped;

/// "body `hub`", or "body 3" where it has no name.
pub(crate) fn shown(description: &Description, body: usize) -> String {
    match description
        .bodies
        .get(body)
        .and_then(|body| body.name.as_ref())
    {
        Some(name) if !name.value.is_empty() => format!("body `{}`", name.value.escaped()),
        _ => format!("body {}", body + 1),
    }
}

/// "joint `elbow`" where it has a name of its own, or the body.
pub(crate) fn shown_by_joint(description: &Description, body: usize) -> String {
    named_joint(description, body).unwrap_or_else(|| shown(description, body))
}

/// "joint `elbow`" where it has a name of its own, or "the joint of body `forearm`".
pub(crate) fn shown_joint(description: &Description, body: usize) -> String {
    let of_body = || format!("the joint of {}", shown(description, body));
    named_joint(description, body).unwrap_or_else(of_body)
}

fn named_joint(description: &Description, body: usize) -> Option<String> {
    let name = description.bodies.get(body)?.joint.name.as_ref()?;
    Some(format!("joint `{}`", name.value.escaped()))
}

/// The name of a joint as written: its own, or its body's.
pub(crate) fn joint_name(description: &Description, body: usize) -> Option<&str> {
    let body = description.bodies.get(body)?;
    let name = body.joint.name.as_ref().or(body.name.as_ref())?;
    Some(&name.value)
}

/// The places of the bodies, those first whose names, or whose joints' own, mean a joint.
pub(crate) fn by_joints(description: &Description) -> impl Iterator<Item = usize> {
    let bodies = &description.bodies;
    let is_meant = |body: &usize| bodies[*body].joint_name().is_some();
    let meant = (0..bodies.len()).filter(is_meant);
    meant.chain((0..bodies.len()).filter(move |body| !is_meant(body)))
}
