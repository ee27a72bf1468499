//! Numbers that look as if they had another unit: degrees in place of radians, millimetres in place of metres.
//!
//! In: a description. Out: warnings; everything is computed as given.

use crate::description::{Description, JointKind, Limits, PerCoordinate, WrittenBody};
use crate::diagnostic::{Diagnostic, Span};
use crate::tree::names::shown;

/// Limits up to two turns, rad, are not looked at.
const TWO_TURNS: f64 = 4.0 * std::f64::consts::PI;
/// Limits beyond, were they degrees, stand for none.
const MOST_DEGREES: f64 = 720.0;
/// Limits in degrees are multiples of this.
const DEGREES: f64 = 5.0;
/// Multiples of this often stand for no limit.
const ROUND: f64 = 50.0;
/// Most lengths of a small system are below, m.
const FAR: f64 = 20.0;
/// The mass of all bodies of a small system, kg.
const SMALL: f64 = 1000.0;

/// Warns of limits that look like degrees, and of lengths that look like millimetres.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) {
    limits(description, findings);
    findings.extend(lengths(description));
}

/// All limits of a file have one unit: where one looks like degrees, all that are too large for radians do.
fn limits(description: &Description, findings: &mut Vec<Diagnostic>) {
    let bodies = description.bodies.iter().enumerate();
    let large = bodies.filter_map(|(place, body)| {
        let limits = angular_limits(body).into_iter();
        let ends = limits.flat_map(|limits| [limits.lower, limits.upper]);
        let mut large = ends.flatten().filter(|end| is_large(end.value));
        let limit = large.next()?;
        let looks = std::iter::once(limit)
            .chain(large)
            .any(|end| is_round(end.value));
        Some((place, body, limit, looks))
    });
    let large: Vec<_> = large.collect();
    if !large.iter().any(|(.., looks)| *looks) {
        return;
    }
    for (place, body, limit, _) in large {
        let name = joint(description, body, place);
        let message = format!(
            "a limit of {name} is {:?} rad; is it in degrees?",
            limit.value
        );
        let warning = Diagnostic::warning(message).at(limit.span, "expected radians");
        findings.push(warning.one_of(
            "joints have limits that look like degrees, not radians",
            name,
        ));
    }
}

/// The limits of angles.
fn angular_limits(body: &WrittenBody) -> Vec<&Limits> {
    let is_angular = |kind: &JointKind| match kind {
        JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Universal
        | JointKind::Spherical => true,
        JointKind::List(names) => names.iter().all(|name| name.value.is_angle()),
        _ => false,
    };
    match &body.joint.limits {
        PerCoordinate::Absent => Vec::new(),
        PerCoordinate::Same(limits) => {
            let kind = body.joint.kind.as_ref();
            let is_angular = kind.is_some_and(|kind| is_angular(&kind.value));
            is_angular.then_some(&limits.value).into_iter().collect()
        }
        PerCoordinate::Each(limits) => {
            let angles = limits.iter().filter(|(name, _)| name.value.is_angle());
            angles.map(|(_, limits)| &limits.value).collect()
        }
    }
}

fn is_large(limit: f64) -> bool {
    limit.abs() > TWO_TURNS && limit.abs() <= MOST_DEGREES
}

fn is_round(limit: f64) -> bool {
    limit % DEGREES == 0.0 && limit % ROUND != 0.0
}

/// The joint by its own name, or by its body's.
fn joint(description: &Description, body: &WrittenBody, place: usize) -> String {
    match &body.joint.name {
        Some(name) => format!("joint `{}`", name.value.escape_debug()),
        None => shown(description, place),
    }
}

/// One warning, at the longest: a long part among short ones is a boom or a tether.
fn lengths(description: &Description) -> Option<Diagnostic> {
    let bodies = &description.bodies;
    let stands = standing(description);
    let masses = bodies.iter().filter_map(|body| body.mass);
    let mass: f64 = masses.map(|mass| mass.value.nominal()).sum();
    let of_bodies = bodies.iter().enumerate();
    let of_bodies = of_bodies.flat_map(|(place, body)| {
        // How far from the inertial frame something stands says nothing.
        let attachment = (!stands[place]).then_some(body.joint.attachment);
        let mass_center = (!is_fixed(body)).then_some(body.mass_center);
        attachment.into_iter().chain(mass_center)
    });
    let mut lengths: Vec<(f64, Span)> = of_bodies
        .filter_map(|parts| {
            let [Some(x), Some(y), Some(z)] = parts else {
                return None;
            };
            let square: f64 = [x, y, z]
                .iter()
                .map(|part| part.value.nominal().powi(2))
                .sum();
            let span = Span::from(x.span.start..z.span.end.max(x.span.end));
            (square > 0.0).then_some((square.sqrt(), span))
        })
        .collect();
    lengths.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    let (median, _) = *lengths.get(lengths.len().checked_sub(1)? / 2)?;
    let (longest, span) = *lengths.last()?;
    (mass < SMALL && median > FAR).then(|| {
        let message = format!(
            "most lengths are above {FAR} m, the longest is {longest:.1} m, and all bodies together have {mass:?} kg; are the lengths in millimetres?"
        );
        Diagnostic::warning(message).at(span, "expected metres")
    })
}

/// For each body whether its joint sits on the inertial frame, or on what is fixed there.
fn standing(description: &Description) -> Vec<bool> {
    let bodies = &description.bodies;
    let lower_bodies = description.lower_bodies.as_ref();
    let lower = |body: usize| -> Option<usize> {
        let lower = lower_bodies?.value.get(body).copied().flatten()?;
        usize::try_from(lower.value).ok()?.checked_sub(1)
    };
    let (mut above, mut reached) = (vec![Vec::new(); bodies.len()], Vec::new());
    for body in 0..bodies.len() {
        match lower(body).and_then(|lower| above.get_mut(lower)) {
            Some(above) => above.push(body),
            None => reached.push(body),
        }
    }
    let mut stands = vec![false; bodies.len()];
    while let Some(body) = reached.pop() {
        stands[body] = true;
        if is_fixed(&bodies[body]) {
            reached.append(&mut above[body]);
        }
    }
    stands
}

fn is_fixed(body: &WrittenBody) -> bool {
    let kind = body.joint.kind.as_ref();
    kind.is_some_and(|kind| kind.value == JointKind::Fixed)
}
