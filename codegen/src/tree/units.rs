//! Numbers that look as if they had another unit: degrees in place of radians, millimetres in place of metres.
//!
//! In: a description. Out: warnings; everything is computed as given.

use crate::description::{Description, JointKind, PerCoordinate, WrittenBody};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::tree::names::shown;

/// Limits up to two turns, rad, are not looked at.
const TWO_TURNS: f64 = 4.0 * std::f64::consts::PI;
/// Limits beyond, were they degrees, stand for none.
const MOST_DEGREES: f64 = 720.0;
/// Limits in degrees are multiples of this.
const DEGREES: f64 = 5.0;
/// Multiples of this often stand for no limit.
const ROUND: f64 = 50.0;
/// Bodies of small systems are not that far apart, m.
const FAR: f64 = 20.0;
/// The mass of all bodies of a small system, kg.
const SMALL: f64 = 1000.0;

/// Warns of limits that look like degrees, and of distances that look like millimetres.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) {
    let masses = description.bodies.iter();
    let masses = masses.filter_map(|body| body.mass.map(|mass| mass.value.nominal()));
    let mass: f64 = masses.sum();
    for (place, body) in description.bodies.iter().enumerate() {
        let name = shown(description, place);
        findings.extend(limit_in_degrees(body, &name));
        // How far from the origin of the inertial frame a system starts says nothing.
        if mass < SMALL && has_lower_body(description, place) {
            findings.extend(distance_in_millimetres(body, &name, mass));
        }
    }
}

fn has_lower_body(description: &Description, place: usize) -> bool {
    let lower_bodies = description.lower_bodies.as_ref();
    let lower = lower_bodies.and_then(|all| all.value.get(place).copied().flatten());
    lower.is_some_and(|lower| lower.value != 0)
}

fn limit_in_degrees(body: &WrittenBody, name: &str) -> Option<Diagnostic> {
    let kind = &body.joint.kind.as_ref()?.value;
    let PerCoordinate::Same(Spanned { value: limits, .. }) = &body.joint.limits else {
        return None;
    };
    if !matches!(kind, JointKind::Revolute | JointKind::Continuous) {
        return None;
    }
    let both = [limits.lower, limits.upper];
    let limit = both.into_iter().flatten();
    let limit = limit.into_iter().find(|limit| is_degrees(limit.value))?;
    let message = format!(
        "a limit of {name} is {:?} rad; are these degrees?",
        limit.value
    );
    let warning = Diagnostic::warning(message).at(limit.span, "expected radians");
    let called = body.joint_name().map_or(name, |name| &name.value);
    Some(warning.one_of(
        "joints have limits that look like degrees, not radians",
        called,
    ))
}

fn is_degrees(limit: f64) -> bool {
    let size = limit.abs();
    size > TWO_TURNS && size <= MOST_DEGREES && size % DEGREES == 0.0 && size % ROUND != 0.0
}

fn distance_in_millimetres(body: &WrittenBody, name: &str, mass: f64) -> Option<Diagnostic> {
    let [Some(x), Some(y), Some(z)] = body.joint.attachment else {
        return None;
    };
    let parts = [x, y, z].map(|part| part.value.nominal());
    let square: f64 = parts.iter().map(|part| part * part).sum();
    if square <= FAR * FAR {
        return None;
    }
    let distance = square.sqrt();
    let message = format!(
        "{name} is attached {distance:.1} m from the origin of its lower body, and all bodies together have {mass:.1} kg; are these millimetres?"
    );
    let span = Span::from(x.span.start..z.span.end.max(x.span.end));
    let warning = Diagnostic::warning(message).at(span, "expected metres");
    Some(warning.one_of(
        "bodies are so far from their lower bodies that it looks like millimetres, not metres",
        name,
    ))
}
