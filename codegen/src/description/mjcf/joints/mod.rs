//! `joint` and `freejoint`: what a joint is, and what it has.

pub(in crate::description::mjcf) mod dynamics;
pub(in crate::description::mjcf) mod free_inertia;
pub(in crate::description::mjcf) mod joint_type;
pub(in crate::description::mjcf) mod limits;
pub(in crate::description::mjcf) mod seat;
pub(in crate::description::mjcf) mod spring_damper;
pub(in crate::description::mjcf) mod ties;

use crate::description::mjcf::joints::dynamics::{Dynamics, dynamics, first};
use crate::description::mjcf::joints::joint_type::{JointType, TYPES, angle_unit};
use crate::description::mjcf::joints::limits::limits;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::settings::{Settings, Switch};
use crate::description::mjcf::placement::{Placement, unit};
use crate::description::xml::Reader;
use crate::description::{
    Chart, Given, JointKind, Limits, Optional, PerCoordinate, Scalar, WrittenJoint,
    on_angular_velocity,
};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::geometry::Vector;

/// A joint as it stands in its body.
#[derive(Clone, Debug)]
pub(in crate::description::mjcf) struct JointElement {
    pub(in crate::description::mjcf) kind: JointType,
    pub(in crate::description::mjcf) span: Span,
    pub(in crate::description::mjcf) name: Optional<String>,
    /// Where it sits, body components, m.
    pub(in crate::description::mjcf) anchor: Vector,
    /// Of length one, body components; `None` for ball and free joints, or where it is faulty.
    pub(in crate::description::mjcf) axis: Option<Vector>,
    /// The coordinate in the reference pose, rad, m.
    pub(in crate::description::mjcf) reference: f64,
    /// Sine and cosine of the coordinate in the reference pose.
    pub(in crate::description::mjcf) reference_turn: [f64; 2],
    /// Whether a free joint gets the axes of its body's inertia, where it says so.
    pub(in crate::description::mjcf) align: Option<Switch>,
    /// The axis as written, body components.
    written_axis: Optional<Vector>,
    chart: Optional<Chart>,
    limits: PerCoordinate<Limits>,
    dynamics: Dynamics,
}

impl JointElement {
    /// The joint under the name that it has as a copy, too.
    pub(in crate::description::mjcf) fn named(self, name: Optional<String>) -> Self {
        Self { name, ..self }
    }

    /// The joint as if its coordinate were this in the reference pose; rad, m.
    pub(in crate::description::mjcf) fn with_reference(&self, reference: f64) -> Self {
        let (sine, cosine) = libm::sincos(reference);
        Self {
            reference,
            reference_turn: [sine, cosine],
            ..self.clone()
        }
    }

    /// Where it leaves it to an actuator to lift weights.
    pub(in crate::description::mjcf) fn by_actuator(&self) -> Option<Span> {
        self.dynamics.by_actuator
    }

    /// The rotor's inertia, kg m² or kg.
    pub(in crate::description::mjcf) fn armature(&self) -> f64 {
        match &self.dynamics.armature {
            PerCoordinate::Same(armature) => armature.value.nominal(),
            _ => 0.0,
        }
    }

    /// Where a spring and a damper follow from the joint's inertia: the place that says so.
    pub(in crate::description::mjcf) fn spring_damper(&self) -> Option<Span> {
        let (rule, _) = self.dynamics.spring_damper.as_ref()?;
        Some(rule.span)
    }

    /// Gives the joint the spring and the damper that follow from its inertia, kg m² or kg.
    pub(in crate::description::mjcf) fn settle(&mut self, inertia: f64) {
        self.dynamics.settle(inertia);
    }

    /// The joint where it sits in the lower body.
    pub(in crate::description::mjcf) fn written(
        &self,
        attachment: [Given<Scalar>; 3],
    ) -> WrittenJoint {
        let kind = match self.kind {
            JointType::Hinge => JointKind::Revolute,
            JointType::Slide => JointKind::Prismatic,
            JointType::Ball => JointKind::Spherical,
            JointType::Free => JointKind::Free,
        };
        WrittenJoint {
            name: self.name.clone(),
            axis: self.written_axis,
            chart: self.chart,
            stiffness: self.dynamics.stiffness.clone(),
            rest: self.dynamics.rest.clone(),
            damping: self.dynamics.damping.clone(),
            armature: self.dynamics.armature.clone(),
            friction: self.dynamics.friction.clone(),
            limits: self.limits.clone(),
            ..WrittenJoint::new(Some(Spanned::new(kind, self.span)), attachment)
        }
    }
}

/// Reads a `freejoint`, which inherits nothing.
pub(in crate::description::mjcf) fn read_free(
    reader: &mut Reader,
    given: &Attributes<'_>,
    chart: Option<Chart>,
) -> JointElement {
    let words = [
        ("true", Some(Switch::On)),
        ("false", Some(Switch::Off)),
        ("auto", None),
    ];
    let align = given.keyword(reader, "align", &words);
    JointElement {
        align: align.and_then(|align| align.value),
        ..turning(
            given,
            JointType::Free,
            [0.0; 3],
            described(chart),
            Dynamics::default(),
        )
    }
}

/// Reads a joint; `around` is the frame in which it is written.
pub(in crate::description::mjcf) fn read(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    chart: Option<Chart>,
) -> JointElement {
    let kind = given.keyword(reader, "type", &TYPES);
    let kind = kind.map_or(JointType::Hinge, |kind| kind.value);
    let anchor = if kind == JointType::Free {
        [0.0; 3]
    } else {
        around.point(given.vector(reader, "pos").unwrap_or_default())
    };
    if matches!(kind, JointType::Hinge | JointType::Slide) {
        return along_axis(reader, given, settings, around, kind, anchor);
    }
    let chart = described(chart);
    rotating(reader, given, settings, chart, kind);
    let dynamics = dynamics(reader, given, settings, kind);
    turning(given, kind, anchor, chart, dynamics)
}

/// How the orientation is described; by a quaternion where the user says nothing.
fn described(chart: Option<Chart>) -> Chart {
    chart.unwrap_or(Chart::Quaternion)
}

fn name(given: &Attributes<'_>) -> Optional<String> {
    let name = given.text("name").filter(|name| !name.value.is_empty());
    name.map(|name| Spanned::new(name.value.to_owned(), name.span))
}

/// A ball or free joint.
fn turning(
    given: &Attributes<'_>,
    kind: JointType,
    anchor: Vector,
    chart: Chart,
    dynamics: Dynamics,
) -> JointElement {
    JointElement {
        kind,
        span: given.span,
        name: name(given),
        anchor,
        axis: None,
        reference: 0.0,
        reference_turn: [0.0, 1.0],
        align: None,
        written_axis: None,
        chart: Some(Spanned::new(chart, given.span)),
        limits: PerCoordinate::Absent,
        dynamics,
    }
}

/// A hinge or a slide, which alone have an axis, a reference and limits.
fn along_axis(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    kind: JointType,
    anchor: Vector,
) -> JointElement {
    let axis = given.vector(reader, "axis").unwrap_or([0.0, 0.0, 1.0]);
    let unit_axis = unit(axis);
    if unit_axis.is_none() {
        let fault = Diagnostic::error(format!("{} is zero", given.what("axis")));
        let fault = fault.at(given.place("axis"), "expected an axis that is not zero");
        reader.faults.push(fault);
    }
    let angle = angle_unit(kind, settings);
    let reference = given.number(reader, "ref").map_or(0.0, |r| r.value);
    JointElement {
        kind,
        span: given.span,
        name: name(given),
        anchor,
        axis: unit_axis.map(|axis| around.vector(axis)),
        reference: angle.radians(reference),
        reference_turn: angle.sine_cosine(reference),
        align: None,
        written_axis: Some(Spanned::new(around.vector(axis), given.place("axis"))),
        chart: None,
        limits: limits(reader, given, settings, angle),
        dynamics: dynamics(reader, given, settings, kind),
    }
}

/// What ball and free joints cannot have.
fn rotating(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    chart: Chart,
    kind: JointType,
) {
    if kind == JointType::Ball && given.has("range") {
        let message = format!(
            "{} limits the angle of a ball joint; it is left out",
            given.what("range")
        );
        let warning = Diagnostic::warning(message).at(given.place("range"), "ignored");
        let warning = warning.one_of("limits of ball joints are left out", given.what("range"));
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
            reader
                .faults
                .push(on_angular_velocity(&given.what(name), value.span));
        }
    }
}
