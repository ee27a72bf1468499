//! What a joint's parts have to do with one another: free and locked coordinates, charts, springs and limits.

use std::collections::BTreeMap;

use crate::description::{
    Axis, Chart, Description, JointKind, Limits, PerCoordinate, Scalar, Speeds, WrittenBody,
};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::tree::joints::resolve::{Freedom, Resolved};
use crate::tree::names::shown;

/// |cos(theta2)| below which theta1 and theta3 turn about one axis.
const SINGULAR: f64 = 1e-9;
/// |cos(theta2)| below which they nearly do: such as theta2 = 1.5708, a rounded right angle.
const NEARLY_SINGULAR: f64 = 1e-4;

/// Reports joints that contradict themselves.
pub(crate) fn check(
    description: &Description,
    joints: &[Option<Resolved>],
    findings: &mut Vec<Diagnostic>,
) {
    names_twice(description, findings);
    for (index, (body, joint)) in description.bodies.iter().zip(joints).enumerate() {
        let Some(joint) = joint else { continue };
        let name = shown(description, index);
        locked(body, joint, &name, findings);
        orientation(body, joint, &name, findings);
        mechanics(body, joint, &name, findings);
    }
}

/// Reports motions that cannot be, once all that is held is held.
pub(crate) fn check_motions(
    description: &Description,
    joints: &[Resolved],
    findings: &mut Vec<Diagnostic>,
) {
    let bodies = &description.bodies;
    for (index, (body, joint)) in bodies.iter().zip(joints).enumerate() {
        let name = shown(description, index);
        findings.extend(singular(body, joint, &name));
    }
    if !bodies.is_empty() && joints.iter().all(Resolved::is_fixed) {
        let fault = Diagnostic::error("no body has a free coordinate, so nothing can move");
        let joints = bodies
            .iter()
            .take(3)
            .filter_map(|body| body.joint.kind.as_ref());
        findings.push(joints.fold(fault, |fault, joint| {
            fault.at(joint.span, "no free coordinate")
        }));
    }
}

/// Two joints with one name, their own or their bodies': which of them is meant elsewhere could not be told.
fn names_twice(description: &Description, findings: &mut Vec<Diagnostic>) {
    let mut first: BTreeMap<&str, (bool, Span)> = BTreeMap::new();
    for body in &description.bodies {
        let own = body.joint.name.as_ref();
        let Some(name) = own.or(body.name.as_ref()) else {
            continue;
        };
        let Some((is_own, span)) = first.get(name.value.as_str()) else {
            first.insert(&name.value, (own.is_some(), name.span));
            continue;
        };
        // Two bodies of one name are told elsewhere.
        if own.is_some() || *is_own {
            let shown = name.value.escape_debug();
            findings.push(
                Diagnostic::error(format!("two joints have the name `{shown}`"))
                    .at(name.span, "the second one")
                    .at(*span, "the first one")
                    .help("a joint without a name of its own has its body's"),
            );
        }
    }
}

fn locked(body: &WrittenBody, joint: &Resolved, name: &str, findings: &mut Vec<Diagnostic>) {
    let Some(kind) = &body.joint.kind else { return };
    for (locked, _) in &body.joint.locked {
        if kind.value.has_axis() {
            let fault = format!(
                "`locked` of {name} holds `{}`, but its joint is about or along an axis of its own",
                locked.value.name()
            );
            let help = "give the joint as a list of free coordinates, or turn its frames by constant rotations";
            findings.push(
                Diagnostic::error(fault)
                    .at(locked.span, "no coordinate of this joint")
                    .help(help),
            );
        } else if let Freedom::Free(free) = joint.motions[locked.value.index()] {
            let fault = format!(
                "`locked` of {name} holds `{}`, which its joint leaves free",
                locked.value.name()
            );
            findings.push(
                Diagnostic::error(fault)
                    .at(locked.span, "locked here")
                    .at(free, "free here"),
            );
        }
    }
}

/// A quaternion or an angular velocity where not all angles are free, or rates of a quaternion.
fn orientation(body: &WrittenBody, joint: &Resolved, name: &str, findings: &mut Vec<Diagnostic>) {
    let turns = joint.free().filter(|motion| *motion < 3).count();
    if turns < 3 {
        let found = match (body.joint.chart, body.joint.speeds) {
            (Some(chart), _) if chart.value == Chart::Quaternion => Some(("`chart`", chart.span)),
            (_, Some(speeds)) if speeds.value == Speeds::AngularVelocity => {
                Some(("`speeds`", speeds.span))
            }
            _ => None,
        };
        if let Some((what, span)) = found {
            let fault = format!("{what} of {name} needs a joint whose three angles are free");
            findings.push(Diagnostic::error(fault).at(span, format!("{turns} of them are free")));
        }
    } else if let (Chart::Quaternion, Speeds::Rates, Some(speeds)) =
        (joint.chart, joint.speeds, body.joint.speeds)
    {
        let fault = format!("{name} has a quaternion, whose rates are no speeds");
        let fault = Diagnostic::error(fault).at(speeds.span, "expected `angular_velocity`");
        findings.push(fault.help("leave `speeds` out"));
    }
}

/// A `theta2` locked at a right angle between free `theta1` and `theta3`, an error; near one, a warning.
fn singular(body: &WrittenBody, joint: &Resolved, name: &str) -> Option<Diagnostic> {
    let (Freedom::Free(first), Freedom::Locked(value), Freedom::Free(third)) =
        (joint.motions[0], joint.motions[1], joint.motions[2])
    else {
        return None;
    };
    let cos = libm::cos(value).abs();
    let (fault, there) = if cos < SINGULAR {
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
    let written = body
        .joint
        .locked
        .iter()
        .find(|(axis, _)| axis.value == Axis::Theta2)
        .and_then(|(_, value)| value.as_ref());
    let fault = match written {
        Some(written) => fault.at(
            written.span,
            format!("`theta1` and `theta3` turn about one axis {there}"),
        ),
        None => fault,
    };
    let fault = fault.at(first, "free here").at(third, "free here");
    Some(
        fault.help(
            "leave out one of `theta1` and `theta3`: only their sum or difference would matter",
        ),
    )
}

/// Quantities of coordinates that are not free, or that no spring, damper or rotor has.
fn mechanics(body: &WrittenBody, joint: &Resolved, name: &str, findings: &mut Vec<Diagnostic>) {
    let written = &body.joint;
    let has_axis = written
        .kind
        .as_ref()
        .is_some_and(|kind| kind.value.has_axis());
    let mut check = Check {
        joint,
        name,
        has_axis,
        findings,
    };
    check.coordinates("stiffness", &written.stiffness);
    check.coordinates("rest", &written.rest);
    check.coordinates("damping", &written.damping);
    check.coordinates("armature", &written.armature);
    check.coordinates("friction", &written.friction);
    check.coordinates("limits", &written.limits);
    check.not_negative("damping", &written.damping, |value| value.nominal());
    check.not_negative("armature", &written.armature, |value| value.nominal());
    check.not_negative("friction", &written.friction, |value| *value);
    check.springs(&written.stiffness);
    check.springs(&written.rest);
    check.isotropic_armature(&written.armature);
    for limits in values(&written.limits) {
        check.limits(&limits.value);
    }
}

struct Check<'a> {
    joint: &'a Resolved,
    name: &'a str,
    has_axis: bool,
    findings: &'a mut Vec<Diagnostic>,
}

fn values<T>(quantity: &PerCoordinate<T>) -> Vec<&Spanned<T>> {
    match quantity {
        PerCoordinate::Absent => Vec::new(),
        PerCoordinate::Same(value) => vec![value],
        PerCoordinate::Each(values) => values.iter().map(|(_, value)| value).collect(),
    }
}

impl Check<'_> {
    fn fault(&mut self, message: String, span: Span, label: &str) {
        self.findings
            .push(Diagnostic::error(message).at(span, label));
    }

    /// Every coordinate that a quantity names is free.
    fn coordinates<T>(&mut self, quantity: &str, values: &PerCoordinate<T>) {
        let PerCoordinate::Each(values) = values else {
            return;
        };
        for (axis, _) in values {
            let (name, kind) = (self.name, axis.value.name());
            if self.has_axis {
                let message = format!(
                    "`{quantity}` of {name} names `{kind}`, but its joint has an axis of its own"
                );
                self.fault(message, axis.span, "expected a number alone");
            } else if matches!(self.joint.motions[axis.value.index()], Freedom::Locked(_)) {
                let message = format!("`{quantity}` of {name} names `{kind}`, which is not free");
                self.fault(message, axis.span, "not free");
            }
        }
    }

    fn not_negative<T>(
        &mut self,
        quantity: &str,
        quantities: &PerCoordinate<T>,
        number: impl Fn(&T) -> f64,
    ) {
        for value in values(quantities) {
            let found = number(&value.value);
            if found < 0.0 {
                let message = format!(
                    "`{quantity}` of {} is {found:?}; expected zero or more",
                    self.name
                );
                self.fault(message, value.span, "negative");
            }
        }
    }

    /// A spring has no potential in components of an angular velocity.
    fn springs(&mut self, quantity: &PerCoordinate<Scalar>) {
        if !self.joint.has_angular_velocity() {
            return;
        }
        let spans: Vec<Span> = match quantity {
            PerCoordinate::Absent => vec![],
            PerCoordinate::Same(value) => vec![value.span],
            PerCoordinate::Each(values) => {
                let turns = values.iter().filter(|(axis, _)| axis.value.is_angle());
                turns.map(|(_, value)| value.span).collect()
            }
        };
        for span in spans {
            let message = format!(
                "a spring acts on a coordinate, but the speeds of {} are components of an angular velocity",
                self.name
            );
            self.fault(message, span, "no spring can act here");
        }
    }

    /// A rotor about each axis of a body that turns has an energy without gyroscopic terms only if all are equal.
    fn isotropic_armature(&mut self, quantity: &PerCoordinate<Scalar>) {
        let PerCoordinate::Each(values) = quantity else {
            return;
        };
        if !self.joint.has_angular_velocity() {
            return;
        }
        let turns: Vec<_> = values
            .iter()
            .filter(|(axis, _)| axis.value.is_angle())
            .collect();
        let differs = |value: &Scalar| {
            turns
                .first()
                .is_some_and(|(_, first)| first.value != *value)
        };
        if let Some((_, value)) = turns
            .iter()
            .find(|(_, value)| turns.len() < 3 || differs(&value.value))
        {
            let message = format!(
                "`armature` of {} must be one for its three components of angular velocity",
                self.name
            );
            self.fault(message, value.span, "expected one number for the three");
        }
    }

    fn limits(&mut self, limits: &Limits) {
        if let (Some(lower), Some(upper)) = (limits.lower, limits.upper)
            && lower.value > upper.value
        {
            let message = format!(
                "the limits of {} are from {:?} to {:?}, which is no range",
                self.name, lower.value, upper.value
            );
            self.findings.push(
                Diagnostic::warning(message)
                    .at(lower.span, "above the upper limit")
                    .at(upper.span, "the upper limit"),
            );
        }
        for (what, limit) in [("velocity", limits.velocity), ("effort", limits.effort)] {
            if let Some(limit) = limit.filter(|limit| limit.value < 0.0) {
                let message = format!(
                    "the `{what}` limit of {} is {:?}; expected zero or more",
                    self.name, limit.value
                );
                self.fault(message, limit.span, "negative");
            }
        }
    }
}

/// The free coordinates as written.
pub(crate) fn free_axes(body: &WrittenBody) -> Vec<Spanned<Axis>> {
    match &body.joint.kind {
        Some(kind) => match &kind.value {
            JointKind::List(axes) => axes.clone(),
            _ => Axis::ALL.map(|axis| Spanned::new(axis, kind.span)).to_vec(),
        },
        None => Vec::new(),
    }
}
