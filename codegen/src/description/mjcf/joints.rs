//! `joint` and `freejoint`: what a joint is, and what it has.

use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::inertial::baked;
use crate::description::mjcf::orientation::AngleUnit;
use crate::description::mjcf::placement::{Placement, unit};
use crate::description::mjcf::settings::{Settings, Switch};
use crate::description::xml::Reader;
use crate::description::{Chart, JointKind, Limits, PerCoordinate, WrittenJoint};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::geometry::Vector;

/// What a joint leaves free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    Hinge,
    Slide,
    Ball,
    Free,
}

const TYPES: [(&str, Type); 4] = [
    ("hinge", Type::Hinge),
    ("slide", Type::Slide),
    ("ball", Type::Ball),
    ("free", Type::Free),
];

/// A joint as it stands in its body.
#[derive(Debug)]
pub(super) struct Read {
    pub(super) kind: Type,
    pub(super) span: Span,
    /// Where it sits, body components, m.
    pub(super) anchor: Vector,
    /// Of length one, body components; `None` for ball and free joints, or where it is faulty.
    pub(super) axis: Option<Vector>,
    /// The coordinate where the model is drawn, rad, m.
    pub(super) reference: f64,
    /// Sine and cosine of the coordinate where the model is drawn.
    pub(super) reference_turn: [f64; 2],
    /// Whether a free joint gets the axes of its body's inertia, where it says so.
    pub(super) align: Option<Switch>,
    /// All but where it sits.
    pub(super) joint: WrittenJoint,
}

impl Read {
    /// A joint of which only the kind and the name are known.
    fn new(given: &Attributes<'_>, kind: Type) -> Self {
        let mut joint = WrittenJoint::unknown();
        let name = given.text("name").filter(|name| !name.value.is_empty());
        joint.name = name.map(|name| Spanned::new(name.value.to_owned(), name.span));
        let described = match kind {
            Type::Hinge => JointKind::Revolute,
            Type::Slide => JointKind::Prismatic,
            Type::Ball => JointKind::Spherical,
            Type::Free => JointKind::Free,
        };
        joint.kind = Some(Spanned::new(described, given.span));
        Self {
            kind,
            span: given.span,
            anchor: [0.0; 3],
            axis: None,
            reference: 0.0,
            reference_turn: [0.0, 1.0],
            align: None,
            joint,
        }
    }

    /// How the orientation is described; by a quaternion where the user says nothing.
    fn describe(&mut self, chart: Option<Chart>) -> Chart {
        let chart = chart.unwrap_or(Chart::Quaternion);
        self.joint.chart = Some(Spanned::new(chart, self.span));
        chart
    }
}

/// Reads a `freejoint`, which inherits nothing.
pub(super) fn read_free(reader: &mut Reader, given: &Attributes<'_>, chart: Option<Chart>) -> Read {
    let mut read = Read::new(given, Type::Free);
    read.describe(chart);
    let words = [
        ("true", Some(Switch::On)),
        ("false", Some(Switch::Off)),
        ("auto", None),
    ];
    let align = given.keyword(reader, "align", &words);
    read.align = align.and_then(|align| align.value);
    read
}

/// Reads a joint; `around` is the frame in which it is written.
pub(super) fn read(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    chart: Option<Chart>,
) -> Read {
    let kind = given.keyword(reader, "type", &TYPES);
    let kind = kind.unwrap_or(Spanned::new(Type::Hinge, given.span));
    let mut read = Read::new(given, kind.value);
    if kind.value != Type::Free {
        let anchor = given.vector(reader, "pos").unwrap_or_default();
        read.anchor = around.point(anchor);
    }
    if matches!(kind.value, Type::Hinge | Type::Slide) {
        scalar(reader, given, settings, around, &mut read);
    } else {
        let chart = read.describe(chart);
        rotating(reader, given, settings, chart, kind.value);
    }
    dynamics(reader, given, settings, &mut read);
    read
}

/// What hinges and slides alone have: an axis, a reference and limits.
fn scalar(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    read: &mut Read,
) {
    let axis = given.vector(reader, "axis").unwrap_or([0.0, 0.0, 1.0]);
    read.axis = unit(axis);
    if read.axis.is_none() {
        let fault = Diagnostic::error(format!("{} is zero", given.what("axis")));
        let fault = fault.at(given.place("axis"), "expected an axis that is not zero");
        reader.faults.push(fault);
    }
    read.joint.axis = Some(Spanned::new(around.vector(axis), given.place("axis")));
    read.axis = read.axis.map(|axis| around.vector(axis));
    let angle = angle_unit(read.kind, settings);
    let reference = given.number(reader, "ref").map_or(0.0, |r| r.value);
    read.reference = angle.radians(reference);
    read.reference_turn = angle.sine_cosine(reference);
    let range = limited(reader, given, settings, "limited", "range");
    let effort = limited(
        reader,
        given,
        settings,
        "actuatorfrclimited",
        "actuatorfrcrange",
    );
    let limits = Limits {
        lower: range.map(|[lower, _]| Spanned::new(angle.radians(lower.value), lower.span)),
        upper: range.map(|[_, upper]| Spanned::new(angle.radians(upper.value), upper.span)),
        velocity: None,
        effort: effort.map(|[lower, upper]| {
            // Where the two differ, what holds in both directions.
            let least = upper.value.abs().min(lower.value.abs());
            Spanned::new(least, upper.span)
        }),
    };
    if limits != Limits::default() {
        read.joint.limits = PerCoordinate::Same(Spanned::new(limits, given.span));
    }
}

/// Slides have lengths where hinges have angles.
fn angle_unit(kind: Type, settings: &Settings) -> AngleUnit {
    if kind == Type::Slide {
        AngleUnit::Radian
    } else {
        settings.angle
    }
}

/// A range that is in force.
fn limited(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    switch: &str,
    name: &str,
) -> Option<[Spanned<f64>; 2]> {
    let words = [
        ("true", Some(Switch::On)),
        ("false", Some(Switch::Off)),
        ("auto", None),
    ];
    let found = given.keyword(reader, switch, &words);
    let found = found.and_then(|found| found.value);
    let range: Option<[_; 2]> = given.numbers(reader, name);
    if found.is_none() && settings.auto_limits == Switch::Off && given.has(name) {
        let message = format!(
            "{} has `{name}`, but does not say whether it is in force",
            given.owner
        );
        let fault = Diagnostic::error(message).at(given.place(name), "in force or not");
        reader.faults.push(fault.help(format!(
            "write `{switch}=\"true\"`, or `autolimits=\"true\"` at `compiler`"
        )));
        return None;
    }
    if found == Some(Switch::Off) {
        return None;
    }
    let [lower, upper] = match range {
        Some(range) => range,
        None if found == Some(Switch::On) && !given.has(name) => {
            let message = format!("{} is limited, but has no `{name}`", given.owner);
            let fault = Diagnostic::error(message).at(given.place(switch), "no range");
            reader.faults.push(fault);
            return None;
        }
        None => return None,
    };
    if lower.value < upper.value {
        return Some([lower, upper]);
    }
    // Without a word about it, MuJoCo takes a range that is none for no limit.
    if found == Some(Switch::On) {
        let message = format!(
            "{} is from {} to {}; expected the second to be the larger",
            given.what(name),
            lower.value,
            upper.value
        );
        let fault = Diagnostic::error(message).at(given.place(name), "empty range");
        reader.faults.push(fault);
    }
    None
}

/// What ball and free joints cannot have.
fn rotating(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    chart: Chart,
    kind: Type,
) {
    if kind == Type::Ball && given.has("range") {
        let message = format!(
            "{} limits the angle of a ball joint; it is left out",
            given.what("range")
        );
        let warning = Diagnostic::warning(message).at(given.place("range"), "ignored");
        reader.faults.push(warning);
    }
    if let Some(stiffness) = first(reader, given, "stiffness")
        && settings.springs == Switch::On
    {
        let message = format!(
            "{} has a stiffness; a spring about all axes is not supported",
            given.owner
        );
        let fault = Diagnostic::error(message).at(stiffness.span, "expected 0");
        reader.faults.push(fault);
    }
    // They act on the angular velocity, not on the rates of angles.
    for name in ["damping", "armature"] {
        if chart == Chart::Angles
            && let Some(value) = first(reader, given, name)
        {
            let message = format!(
                "{} acts on the angular velocity, but the speeds are rates of angles",
                given.what(name)
            );
            let fault = Diagnostic::error(message).at(value.span, "expected 0");
            reader
                .faults
                .push(fault.help("describe the orientation by a quaternion"));
        }
    }
}

/// The first of up to three coefficients, where it is not zero.
fn first(reader: &mut Reader, given: &Attributes<'_>, name: &str) -> Option<Spanned<f64>> {
    let coefficients = given.up_to(reader, name, 3)?;
    coefficients
        .first()
        .copied()
        .filter(|first| first.value != 0.0)
}

/// Spring, damper, rotor and friction.
fn dynamics(reader: &mut Reader, given: &Attributes<'_>, settings: &Settings, read: &mut Read) {
    for name in ["stiffness", "damping"] {
        polynomial(reader, given, name);
    }
    spring_damper(reader, given);
    let kind = read.kind;
    let joint = &mut read.joint;
    let same = |value| PerCoordinate::Same(baked(value));
    if settings.springs == Switch::On
        && matches!(kind, Type::Hinge | Type::Slide)
        && let Some(stiffness) = first(reader, given, "stiffness")
    {
        joint.stiffness = same(stiffness);
        let rest = given.number(reader, "springref");
        let rest = rest.map(|rest| {
            let angle = angle_unit(kind, settings).radians(rest.value);
            Spanned::new(angle, rest.span)
        });
        joint.rest = rest.map_or(PerCoordinate::Absent, same);
    }
    if settings.dampers == Switch::On
        && let Some(damping) = first(reader, given, "damping")
    {
        joint.damping = same(damping);
    }
    let armature = given.number(reader, "armature");
    if let Some(armature) = armature.filter(|armature| armature.value != 0.0) {
        joint.armature = same(armature);
    }
    let friction = given.number(reader, "frictionloss");
    if let Some(friction) = friction.filter(|friction| friction.value != 0.0) {
        joint.friction = PerCoordinate::Same(friction);
    }
}

/// Coefficients after the first are those of squares and cubes.
fn polynomial(reader: &mut Reader, given: &Attributes<'_>, name: &str) {
    let coefficients = given.up_to(reader, name, 3).unwrap_or_default();
    let other = coefficients.iter().skip(1).find(|c| c.value != 0.0);
    if let Some(other) = other {
        let message = format!(
            "{} has the coefficient {} of a higher power; expected one that is linear",
            given.what(name),
            other.value
        );
        let fault = Diagnostic::error(message).at(other.span, "not supported");
        reader.faults.push(fault);
    }
}

/// Springs and dampers that MuJoCo computes from the inertia, and springs that yield.
fn spring_damper(reader: &mut Reader, given: &Attributes<'_>) {
    let pair: Option<[Spanned<f64>; 2]> = given.numbers(reader, "springdamper");
    if pair.is_some_and(|pair| pair.iter().all(|entry| entry.value > 0.0)) {
        let message = format!("{} is not supported", given.what("springdamper"));
        let fault = Diagnostic::error(message).at(given.place("springdamper"), "not supported");
        reader
            .faults
            .push(fault.help("give `stiffness` and `damping` as numbers"));
    }
    let threshold = given.number(reader, "springyield");
    if let Some(threshold) = threshold.filter(|threshold| threshold.value > 0.0) {
        let message = format!(
            "{} is {}; a spring that yields is not supported",
            given.what("springyield"),
            threshold.value
        );
        let fault = Diagnostic::error(message).at(threshold.span, "expected 0");
        reader.faults.push(fault);
    }
}
