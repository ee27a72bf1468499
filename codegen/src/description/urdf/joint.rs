//! `joint`: a joint, and the two links that it joins.

use crate::description::urdf::named::{IGNORED, Named};
use crate::description::urdf::origin;
use crate::description::xml::{Element, Known, Reader};
use crate::description::{
    Chart, Given, JointKind, Limits, Mimic, Optional, PerCoordinate, Scalar, WrittenJoint,
    on_angular_velocity,
};
use crate::diagnostic::{Diagnostic, Spanned};

/// The types of joints.
const TYPES: [(&str, JointKind); 6] = [
    ("fixed", JointKind::Fixed),
    ("revolute", JointKind::Revolute),
    ("continuous", JointKind::Continuous),
    ("prismatic", JointKind::Prismatic),
    ("planar", JointKind::Planar),
    ("floating", JointKind::Free),
];

/// The ends of a range, and what stands for none.
const ENDS: [(&str, f64); 2] = [("lower", f64::NEG_INFINITY), ("upper", f64::INFINITY)];

/// A joint, and the two links that it joins.
pub(super) struct JointElement<'d> {
    /// The name.
    pub(super) name: Given<&'d str>,
    /// The words for it in messages.
    pub(super) words: String,
    /// The name of the lower link.
    pub(super) parent: Given<&'d str>,
    /// The name of the link that it moves.
    pub(super) child: Given<&'d str>,
    /// The joint itself.
    pub(super) joint: WrittenJoint,
}

/// Reads a `joint`.
pub(super) fn read<'d>(
    reader: &mut Reader,
    element: Element<'d>,
    Named { name, words }: Named<'d>,
    chart: Chart,
) -> JointElement<'d> {
    let known = Known {
        attributes: &["name", "type"],
        children: &[
            "origin", "parent", "child", "axis", "limit", "dynamics", "mimic",
        ],
        ignored_children: &IGNORED,
        ..Known::NONE
    };
    reader.unknown(element, &words, &known);
    let kind = reader
        .required(element, &words, "type")
        .and_then(|kind| reader.keyword(kind, &format!("`type` of {words}"), &TYPES));
    let own_name = name.map(|name| Spanned::new(name.value.to_owned(), name.span));
    let joint = WrittenJoint {
        name: own_name,
        ..read_motion(reader, element, &words, kind, chart)
    };
    JointElement {
        parent: end(reader, element, &words, "parent"),
        child: end(reader, element, &words, "child"),
        name,
        words,
        joint,
    }
}

/// The joint but for its name and the links that it joins.
fn read_motion(
    reader: &mut Reader,
    element: Element<'_>,
    words: &str,
    kind: Given<JointKind>,
    chart: Chart,
) -> WrittenJoint {
    let what = kind.as_ref().map(|kind| &kind.value);
    let origin = origin::read(reader, element, words);
    let has_axis = what.is_none_or(JointKind::has_axis);
    let axis = has_axis.then(|| axis(reader, element, words)).flatten();
    let moves = what != Some(&JointKind::Fixed);
    let mimic = if moves {
        mimic(reader, element, words)
    } else {
        warn_of_mimic(reader, element, words);
        None
    };
    let dynamics = if moves {
        dynamics(reader, element, words)
    } else {
        Dynamics::default()
    };
    let limits = match what {
        Some(JointKind::Fixed) => PerCoordinate::Absent,
        Some(JointKind::Free | JointKind::Planar) => {
            warn_of_limits(reader, element, words);
            PerCoordinate::Absent
        }
        _ => limits(reader, element, words, what),
    };
    let is_free = kind.as_ref().filter(|kind| kind.value == JointKind::Free);
    if let PerCoordinate::Same(damping) = &dynamics.damping
        && is_free.is_some()
        && chart == Chart::Angles
        && damping.value.nominal() != 0.0
    {
        let what = format!("`damping` of `dynamics` of {words}");
        reader.faults.push(on_angular_velocity(&what, damping.span));
    }
    WrittenJoint {
        axis,
        attachment_rotation: origin.rotation,
        chart: is_free.map(|kind| Spanned::new(chart, kind.span)),
        damping: dynamics.damping,
        friction: dynamics.friction,
        limits,
        mimic,
        ..WrittenJoint::new(kind, origin.position)
    }
}

/// The link that `parent` or `child` names.
fn end<'d>(reader: &mut Reader, joint: Element<'d>, words: &str, name: &str) -> Given<&'d str> {
    let element = reader.required_child(joint, words, name)?;
    let owner = format!("`{name}` of {words}");
    let known = Known {
        attributes: &["link"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    reader.required(element, &owner, "link")
}

fn axis(reader: &mut Reader, joint: Element<'_>, words: &str) -> Optional<[f64; 3]> {
    let absent = Some(Spanned::new([1.0, 0.0, 0.0], joint.span()));
    let Some(element) = reader.child(joint, words, "axis") else {
        return absent;
    };
    let owner = format!("`axis` of {words}");
    let known = Known {
        attributes: &["xyz"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    let Some(xyz) = element.attribute("xyz") else {
        let warning = Diagnostic::warning(format!("{owner} has no `xyz`"));
        let warning = warning
            .at(element.span(), "read as along x")
            .one_of("axes have no `xyz`", words);
        reader.faults.push(warning);
        return absent;
    };
    let axis: [_; 3] = reader.numbers(xyz, &format!("`xyz` of {owner}"))?;
    let axis = axis.map(|entry| entry.value);
    if axis == [0.0; 3] {
        let fault = Diagnostic::error(format!("{owner} is zero; expected a direction"));
        reader.faults.push(fault.at(xyz.span, "no direction"));
        return None;
    }
    Some(Spanned::new(axis, xyz.span))
}

/// The limits; of a joint that has to have them, a warning where there are none.
fn limits(
    reader: &mut Reader,
    joint: Element<'_>,
    words: &str,
    kind: Option<&JointKind>,
) -> PerCoordinate<Limits> {
    let is_ranged = matches!(kind, Some(JointKind::Revolute | JointKind::Prismatic));
    let Some(element) = reader.child(joint, words, "limit") else {
        if is_ranged {
            let warning = Diagnostic::warning(format!("{words} has no `limit`"));
            let warning = warning
                .at(joint.span(), "read as without limits")
                .one_of("joints have no `limit`", words);
            reader.faults.push(warning);
        }
        return PerCoordinate::Absent;
    };
    let owner = format!("`limit` of {words}");
    let known = Known {
        attributes: &["lower", "upper", "velocity", "effort"],
        ignored_attributes: &["acceleration", "deceleration", "jerk"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    let mut limits = Limits {
        velocity: reader.optional_limit(element, &owner, "velocity", f64::INFINITY),
        effort: reader.optional_limit(element, &owner, "effort", f64::INFINITY),
        ..Limits::default()
    };
    if is_ranged {
        let [lower, upper] = ENDS.map(|(name, none)| {
            if element.attribute(name).is_none() {
                return Some(Spanned::new(0.0, element.span()));
            }
            reader.optional_limit(element, &owner, name, none)
        });
        (limits.lower, limits.upper) = (lower, upper);
        warn_of_range(reader, element, &owner);
    } else if matches!(kind, Some(JointKind::Continuous)) {
        let ends = ENDS.map(|(name, none)| reader.optional_limit(element, &owner, name, none));
        // Some exporters write zeros where there are no limits.
        if ends.iter().flatten().any(|end| end.value != 0.0) {
            warn_of_range_of_continuous(reader, element, words);
        }
    }
    PerCoordinate::Same(Spanned::new(limits, element.span()))
}

/// A continuous joint has no range.
fn warn_of_range_of_continuous(reader: &mut Reader, element: Element<'_>, words: &str) {
    let message = format!("the range of {words} is left out: the joint is continuous");
    let warning = Diagnostic::warning(message)
        .at(element.span(), "a joint with a range is `revolute`")
        .one_of("ranges of continuous joints are left out", words);
    reader.faults.push(warning);
}

/// Limits of joints that move along or about several axes are left out.
fn warn_of_limits(reader: &mut Reader, joint: Element<'_>, words: &str) {
    if let Some(element) = reader.child(joint, words, "limit") {
        let message = format!("`limit` of {words} is left out: the joint has several axes");
        let warning = Diagnostic::warning(message)
            .at(element.span(), "ignored")
            .one_of("limits of joints with several axes are left out", words);
        reader.faults.push(warning);
    }
}

/// An absent end of the range is zero, which may surprise where both are absent.
fn warn_of_range(reader: &mut Reader, element: Element<'_>, owner: &str) {
    let is_given = |name: &str| element.attribute(name).is_some();
    if !is_given("lower") && !is_given("upper") {
        let warning = format!("{owner} has neither `lower` nor `upper`; both are zero then");
        let warning = Diagnostic::warning(warning)
            .at(element.span(), "from 0 to 0")
            .one_of(
                "limits have neither `lower` nor `upper`; both are zero then",
                owner,
            );
        reader.faults.push(warning);
    }
}

/// What a `dynamics` says.
#[derive(Default)]
struct Dynamics {
    damping: PerCoordinate<Scalar>,
    friction: PerCoordinate<f64>,
}

fn dynamics(reader: &mut Reader, joint: Element<'_>, words: &str) -> Dynamics {
    let Some(element) = reader.child(joint, words, "dynamics") else {
        return Dynamics::default();
    };
    let owner = format!("`dynamics` of {words}");
    let known = Known {
        attributes: &["damping", "friction"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    let damping = reader.optional_number(element, &owner, "damping");
    let damping = damping.map(|damping| Spanned::new(Scalar::Baked(damping.value), damping.span));
    let friction = reader.optional_number(element, &owner, "friction");
    Dynamics {
        damping: damping.map_or(PerCoordinate::Absent, PerCoordinate::Same),
        friction: friction.map_or(PerCoordinate::Absent, PerCoordinate::Same),
    }
}

/// A fixed joint follows none.
fn warn_of_mimic(reader: &mut Reader, joint: Element<'_>, words: &str) {
    if let Some(element) = reader.child(joint, words, "mimic") {
        let message = format!("`mimic` of {words} is left out: the joint is fixed");
        let warning = Diagnostic::warning(message)
            .at(element.span(), "ignored")
            .one_of("`mimic`s of fixed joints are left out", words);
        reader.faults.push(warning);
    }
}

fn mimic(reader: &mut Reader, joint: Element<'_>, words: &str) -> Optional<Mimic> {
    let element = reader.child(joint, words, "mimic")?;
    let owner = format!("`mimic` of {words}");
    let known = Known {
        attributes: &["joint", "multiplier", "offset"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    let mut number = |name, absent: f64| match element.attribute(name) {
        Some(_) => reader.optional_number(element, &owner, name),
        None => Some(Spanned::new(absent, element.span())),
    };
    let (multiplier, offset) = (number("multiplier", 1.0), number("offset", 0.0));
    let followed = reader.required(element, &owner, "joint")?;
    let mimic = Mimic {
        joint: Spanned::new(followed.value.to_owned(), followed.span),
        multiplier: multiplier?.value,
        offset: offset?.value,
    };
    Some(Spanned::new(mimic, element.span()))
}
