//! Ranges of hinges that look like radians where the file's angles are in degrees, the default unit of an MJCF.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::description::mjcf::model::angles::AngleUnit;
use crate::description::mjcf::model::settings::Settings;
use crate::description::xml::Reader;
use crate::description::{JointKind, PerCoordinate, WrittenBody};
use crate::diagnostic::{Diagnostic, Spanned};

/// How far, of itself, a right angle in radians is rounded: `1.57`.
const ROUNDED: f64 = 7e-4;

/// Warns if no range goes beyond a turn in radians, and one ends at right angles in radians.
pub(super) fn warn(reader: &mut Reader, settings: &Settings, bodies: &[WrittenBody]) {
    if settings.angle == AngleUnit::Radian {
        return;
    }
    let ends: Vec<Spanned<f64>> = bodies.iter().flat_map(ends).collect();
    let is_within = |end: &Spanned<f64>| end.value.abs() <= TAU * (1.0 + ROUNDED);
    let right = ends.iter().find(|end| is_right(end.value));
    let Some(right) = right.filter(|_| ends.iter().all(is_within)) else {
        return;
    };
    let largest = ends
        .iter()
        .fold(0.0, |most: f64, end| most.max(end.value.abs()));
    let message = format!(
        "the ranges of all hinges are within {largest:.2} degrees, and one ends at {:.4}; are they in radians?",
        right.value
    );
    let warning = Diagnostic::warning(message).at(right.span, "read as degrees");
    // Other angles of the file may be in degrees.
    let help = "convert the ranges to degrees, or set `<compiler angle=\"radian\"/>` if all angles of the file are in radians";
    reader.faults.push(warning.help(help));
}

/// The ends of the range of a hinge, degrees.
fn ends(body: &WrittenBody) -> Vec<Spanned<f64>> {
    let kind = body.joint.kind.as_ref();
    let limits = match &body.joint.limits {
        PerCoordinate::Same(limits)
            if kind.is_some_and(|kind| kind.value == JointKind::Revolute) =>
        {
            limits.value
        }
        _ => return Vec::new(),
    };
    let ends = [limits.lower, limits.upper].into_iter().flatten();
    ends.map(|end| Spanned::new(end.value.to_degrees(), end.span))
        .collect()
}

/// True for one to four right angles in radians, either way.
fn is_right(angle: f64) -> bool {
    let turns = angle.abs() / FRAC_PI_2;
    let whole = turns.round();
    whole >= 1.0 && (turns - whole).abs() <= ROUNDED * whole
}
