//! Joints: which coordinates are free, and at which values the others are locked.

use crate::description::{Axis, Body, Description, JointKind};
use crate::diagnostic::{Diagnostic, Spanned};
use crate::tree::names::shown;

/// |cos(theta2)| below which theta1 and theta3 turn about one axis.
const SINGULAR: f64 = 1e-9;
/// |cos(theta2)| below which they nearly do: such as theta2 = 1.5708, a rounded right angle.
const NEARLY_SINGULAR: f64 = 1e-4;

/// Reports joints that contradict themselves; true where nothing is an error.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) -> bool {
    let mut stands = true;
    for (index, body) in description.bodies.iter().enumerate() {
        let name = shown(description, index);
        for (locked, _) in &body.joint.locked {
            let Some(free) = free(body, locked.value) else {
                continue;
            };
            let fault = format!(
                "`locked` of {name} holds `{}`, which its joint leaves free",
                locked.value.name()
            );
            findings.push(
                Diagnostic::error(fault)
                    .at(locked.span, "locked here")
                    .at(free.span, "free here"),
            );
            stands = false;
        }
        if let Some((fault, is_error)) = singular(body, &name) {
            findings.push(fault);
            stands &= !is_error;
        }
    }
    let bodies = &description.bodies;
    if !bodies.is_empty()
        && bodies.iter().all(|body| {
            matches!(&body.joint.kind, Some(kind) if kind.value == JointKind::List(Vec::new()))
        })
    {
        let fault = Diagnostic::error("no body has a free coordinate, so nothing can move");
        let joints = bodies.iter().take(3).filter_map(|body| body.joint.kind.as_ref());
        findings.push(joints.fold(fault, |fault, joint| {
            fault.at(joint.span, "no free coordinate")
        }));
        stands = false;
    }
    stands
}

fn free(body: &Body, axis: Axis) -> Option<Spanned<Axis>> {
    free_axes(body).into_iter().find(|free| free.value == axis)
}

/// A `theta2` locked at a right angle between free `theta1` and `theta3`; true with an error, false with a warning.
fn singular(body: &Body, name: &str) -> Option<(Diagnostic, bool)> {
    let first = free(body, Axis::Theta1)?;
    let third = free(body, Axis::Theta3)?;
    if free(body, Axis::Theta2).is_some() {
        return None;
    }
    let (_, locked) = body
        .joint
        .locked
        .iter()
        .find(|(axis, _)| axis.value == Axis::Theta2)?;
    let locked = locked.as_ref()?;
    let cos = libm::cos(locked.value).abs();
    let is_error = cos < SINGULAR;
    let (fault, there) = if is_error {
        (
            Diagnostic::error(format!(
                "`theta2` of {name} is locked where cos(theta2) = 0, between free `theta1` and `theta3`"
            )),
            "there",
        )
    } else if cos < NEARLY_SINGULAR {
        (
            Diagnostic::warning(format!(
                "`theta2` of {name} is locked near cos(theta2) = 0, between free `theta1` and `theta3`"
            )),
            "nearly",
        )
    } else {
        return None;
    };
    let fault = fault.at(
        locked.span,
        format!("`theta1` and `theta3` turn about one axis {there}"),
    );
    let fault = fault
        .at(first.span, "free here")
        .at(third.span, "free here");
    Some((
        fault.help(
            "leave out one of `theta1` and `theta3`: only their sum or difference would matter",
        ),
        is_error,
    ))
}

/// The free coordinates.
pub(crate) fn free_axes(body: &Body) -> Vec<Spanned<Axis>> {
    match &body.joint.kind {
        Some(kind) => match &kind.value {
            JointKind::List(axes) => axes.clone(),
            _ => Axis::ALL.map(|axis| Spanned::new(axis, kind.span)).to_vec(),
        },
        None => Vec::new(),
    }
}
