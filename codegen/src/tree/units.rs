//! Numbers that look as if they had another unit: degrees in place of radians, also in limits of velocity; millimetres in place of
//! metres, also in inertias and gravity.
//!
//! In: a description. Out: warnings; everything is computed as given.

use std::ops::{Range, RangeInclusive};

use crate::description::{Description, Limits, PerCoordinate, WrittenBody};
use crate::diagnostic::{Diagnostic, Escaped, Span};
use crate::tree::names::shown;

/// Limits up to two turns, rad, are not looked at.
const TWO_TURNS: f64 = 4.0 * std::f64::consts::PI;
/// Limits beyond, were they degrees, stand for none.
const MOST_DEGREES: f64 = 720.0;
/// Limits in degrees are multiples of this.
const DEGREES: f64 = 5.0;
/// Multiples of this often stand for no limit.
const ROUND: f64 = 50.0;
/// If all limits of velocity are in this range, they may be in degrees per second: one of several joints is usually slower.
const FAST: RangeInclusive<f64> = 45.0..=MOST_DEGREES;
/// Most lengths of a small system are below, m.
const FAR: f64 = 20.0;
/// The mass of all bodies of a small system, kg.
const SMALL: f64 = 1000.0;
/// An offset between two joints beyond this may be in millimetres where others are in metres, m; tethers are often shorter.
const LONG: f64 = 100.0;
/// So many offsets between joints, or limits of velocity, say which unit all have.
const FEW: usize = 3;
/// A length in millimetres among others in metres is so many times the median.
const MANY: Range<f64> = 100.0..5000.0;
/// A mass centre is at most so many times as far away as the mass would have to be for the inertia about it.
const SLENDER: f64 = 50.0;
/// Shorter lengths are crumbs, m.
const SHORTEST: f64 = 1e-6;
/// Inertias of real bodies are those of their mass at most at so many times the longest distance of a system.
const WIDE: f64 = 20.0;
/// A body with a smaller part of all mass may be there for a joint alone.
const LIGHT: f64 = 1e-3;
/// The largest gravity that is not looked at, m/s^2: a hundred times that of the earth.
const STRONG: f64 = 1000.0;

/// Warns of limits that look like degrees, of lengths, inertias and gravity that look like those in millimetres.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) {
    limits(description, findings);
    findings.extend(fast_limits(description));
    let masses = description.bodies.iter().filter_map(|body| body.mass);
    let mass: f64 = masses.map(|mass| mass.value.nominal()).sum();
    if mass < SMALL {
        let lengths = lengths(description);
        findings.extend(long_lengths(description, &lengths, mass));
        findings.extend(lone_offsets(description, &lengths));
        findings.extend(wide_inertias(description, &lengths, mass));
    }
    findings.extend(strong_gravity(description));
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

/// One warning where all limits of velocity are too large for radians; wheels and propellers, which have no range, may be that fast.
fn fast_limits(description: &Description) -> Option<Diagnostic> {
    let limits = description.bodies.iter().flat_map(angular_limits);
    let ranged = limits.filter(|limits| limits.lower.is_some() && limits.upper.is_some());
    let limits: Vec<_> = ranged.filter_map(|limits| limits.velocity).collect();
    let are_fast = limits.len() >= FEW && limits.iter().all(|limit| FAST.contains(&limit.value));
    let round = limits.iter().find(|limit| is_round(limit.value));
    let round = round.filter(|_| are_fast)?;
    let values = limits.iter().map(|limit| limit.value);
    let (least, most) = values.fold((f64::INFINITY, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    let message = format!(
        "all {} limits of velocity of rotations with a range are between {least:?} and {most:?} rad/s; are they in degrees per second?",
        limits.len()
    );
    Some(Diagnostic::warning(message).at(round.span, "expected rad/s"))
}

/// The limits of angles.
fn angular_limits(body: &WrittenBody) -> Vec<&Limits> {
    match &body.joint.limits {
        PerCoordinate::Absent => Vec::new(),
        PerCoordinate::Same(limits) => {
            let kind = body.joint.kind.as_ref();
            let is_angular = kind.is_some_and(|kind| kind.value.is_angular());
            is_angular.then_some(&limits.value).into_iter().collect()
        }
        PerCoordinate::Each(limits) => {
            let angles = limits.iter().filter(|(name, _)| name.value.is_angle());
            angles.map(|(_, limits)| &limits.value).collect()
        }
    }
}

/// True for what no angle in radians is, but one in degrees may be.
pub(crate) fn is_large(limit: f64) -> bool {
    limit.abs() > TWO_TURNS && limit.abs() <= MOST_DEGREES
}

fn is_round(limit: f64) -> bool {
    limit % DEGREES == 0.0 && limit % ROUND != 0.0
}

/// The joint by its own name, or by its body's.
fn joint(description: &Description, body: &WrittenBody, place: usize) -> String {
    match &body.joint.name {
        Some(name) => format!("joint `{}`", name.value.escaped()),
        None => shown(description, place),
    }
}

/// A length of a body, and where it stands.
struct Length {
    metres: f64,
    span: Span,
    body: usize,
    is_mass_center: bool,
}

/// The lengths that say how large a system is, the shortest first.
fn lengths(description: &Description) -> Vec<Length> {
    let stands = standing(description);
    let of_bodies = description.bodies.iter().enumerate();
    let of_bodies = of_bodies.flat_map(|(place, body)| {
        // How far from the inertial frame something stands says nothing.
        let attachment = (!stands[place]).then_some(body.joint.attachment);
        let mass_center = (!is_fixed(body)).then_some(body.mass_center);
        [(false, attachment), (true, mass_center)].map(|(is, parts)| (place, is, parts))
    });
    let lengths = of_bodies.filter_map(|(body, is_mass_center, parts)| {
        let parts = parts?;
        let [Some(x), Some(y), Some(z)] = parts else {
            return None;
        };
        let squares = [x, y, z].map(|part| part.value.nominal().powi(2));
        let length = Length {
            metres: squares.iter().sum::<f64>().sqrt(),
            span: Span::from(x.span.start..z.span.end.max(x.span.end)),
            body,
            is_mass_center,
        };
        (length.metres > SHORTEST).then_some(length)
    });
    let mut lengths: Vec<Length> = lengths.collect();
    lengths.sort_by(|one, other| one.metres.total_cmp(&other.metres));
    lengths
}

/// One warning, at the longest, where most are long; else one for each mass centre that stands out. What hangs far away, on a tether,
/// has its mass centre near its origin.
fn long_lengths(description: &Description, lengths: &[Length], mass: f64) -> Vec<Diagnostic> {
    let Some(longest) = lengths.last() else {
        return Vec::new();
    };
    let median = lengths[(lengths.len() - 1) / 2].metres;
    let between: Vec<&Length> = lengths.iter().filter(|own| !own.is_mass_center).collect();
    let most_are_far = between.len() >= FEW && between[(between.len() - 1) / 2].metres > FAR;
    if median > FAR || most_are_far {
        let (what, longest) = match between.last() {
            Some(last) if median <= FAR => ("offsets between joints", *last),
            _ => ("lengths", longest),
        };
        let longest_metres = longest.metres;
        let message = format!(
            "most {what} are above {FAR} m, the longest is {longest_metres:.1} m, and all bodies together have {mass:?} kg; are the lengths in millimetres?"
        );
        let warning = Diagnostic::warning(message);
        return vec![warning.at(longest.span, "expected metres")];
    }
    let outliers = lengths.iter();
    let outliers = outliers.filter(|length| {
        let (metres, body) = (length.metres, &description.bodies[length.body]);
        let stands_out = metres > FAR && MANY.contains(&(metres / median));
        // A boom is as long as that.
        let is_slender = radius(body).is_some_and(|radius| metres <= SLENDER * radius);
        length.is_mass_center && stands_out && !is_slender
    });
    let warned = outliers.map(|length| {
        let (metres, name) = (length.metres, shown(description, length.body));
        let message = format!(
            "the mass centre of {name} is {metres:.1} m from its origin, far beyond all else; is it in millimetres?"
        );
        let warning = Diagnostic::warning(message).at(length.span, "expected metres");
        warning.one_of("mass centres look as if they were in millimetres", name)
    });
    warned.collect()
}

/// A warning for each offset between joints that is large and stands out among others; among few, none is usual.
fn lone_offsets(description: &Description, lengths: &[Length]) -> Vec<Diagnostic> {
    let between: Vec<&Length> = lengths.iter().filter(|own| !own.is_mass_center).collect();
    if between.len() <= FEW {
        return Vec::new();
    }
    let median = between[(between.len() - 1) / 2].metres;
    let stands_out =
        |length: &&Length| length.metres > LONG && MANY.contains(&(length.metres / median));
    let warned = between.into_iter().filter(stands_out).map(|length| {
        let (metres, body) = (length.metres, &description.bodies[length.body]);
        let factor = metres / median;
        let name = joint(description, body, length.body);
        let message = format!(
            "{name} is {metres:.1} m from the origin of its lower body, {factor:.0} times the median offset; is it in millimetres?"
        );
        let warning = Diagnostic::warning(message).at(length.span, "expected metres");
        warning.one_of("offsets between joints look as if they were in millimetres", name)
    });
    warned.collect()
}

/// The distance at which all mass of a body would have its inertia, m; `None` where there is no mass.
fn radius(body: &WrittenBody) -> Option<f64> {
    let [Some(xx), Some(yy), Some(zz), ..] = body.inertia else {
        return None;
    };
    let trace: f64 = [xx, yy, zz].map(|entry| entry.value.nominal()).iter().sum();
    let mass = body.mass?.value.nominal();
    (mass > 0.0 && trace > 0.0).then(|| (trace / (2.0 * mass)).sqrt())
}

/// A warning for each inertia that has its mass far beyond all of the system.
fn wide_inertias(description: &Description, lengths: &[Length], total: f64) -> Vec<Diagnostic> {
    let longest = lengths.last().map_or(0.0, |length| length.metres);
    let far = FAR.max(WIDE * longest);
    let stands = standing(description);
    let bodies = description.bodies.iter().enumerate();
    let moving = bodies.filter(|(place, body)| !(stands[*place] && is_fixed(body)));
    let warned = moving.filter_map(|(place, body)| {
        let (mass, radius) = (body.mass?.value.nominal(), radius(body)?);
        if mass <= LIGHT * total || radius <= far {
            return None;
        }
        let xx = body.inertia[0]?;
        let name = shown(description, place);
        let radius = match radius {
            near if near < 1e6 => format!("{near:.0}"),
            far => format!("{far:.0e}"),
        };
        let message = format!(
            "the inertia of {name} is that of {mass:?} kg at a distance of {radius} m; is it in kg mm^2?"
        );
        let warning = Diagnostic::warning(message).at(xx.span, "expected kg m^2");
        Some(warning.one_of("inertias look like kg mm^2, not kg m^2", name))
    });
    warned.collect()
}

/// A warning where gravity is too strong for any place that has robots.
fn strong_gravity(description: &Description) -> Option<Diagnostic> {
    let mut components = description.gravity.iter().flatten();
    let strong = components.find(|component| component.value.nominal().abs() > STRONG)?;
    let message = format!(
        "a component of gravity is {:?} m/s^2; is it in mm/s^2?",
        strong.value.nominal()
    );
    Some(Diagnostic::warning(message).at(strong.span, "expected m/s^2"))
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
    kind.is_some_and(|kind| kind.value.is_fixed())
}
