//! Springs, dampers, rotors, friction and limits: of coordinates that can have them, and of the right sign.

use crate::description::{
    Chart, CoordinateName, JointKind, Limits, PerCoordinate, Scalar, WrittenBody, WrittenJoint,
};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};

/// Quantities of coordinates that are not free, or that no spring, damper or rotor has.
pub(super) fn mechanics(
    body: &WrittenBody,
    joint: &ResolvedJoint,
    name: &str,
    findings: &mut Vec<Diagnostic>,
) {
    let written = &body.joint;
    let has_axis = written
        .kind
        .as_ref()
        .is_some_and(|kind| kind.value.has_axis());
    let mut check = Check {
        joint,
        name,
        called: body.joint_name().map_or(name, |name| &name.value),
        has_axis,
        findings,
    };
    let is_fixed = |kind: &Spanned<JointKind>| kind.value.is_fixed();
    // Of a fixed joint all is refused, whatever it names.
    if !written.kind.as_ref().is_some_and(is_fixed) {
        check.coordinates("stiffness", &written.stiffness);
        check.coordinates("rest", &written.rest);
        check.coordinates("damping", &written.damping);
        check.coordinates("armature", &written.armature);
        check.coordinates("friction", &written.friction);
        check.coordinates("limits", &written.limits);
    }
    check.negative(
        ("damping", "it adds energy"),
        &written.damping,
        "joints whose damping adds energy",
    );
    check.negative(
        ("stiffness", "it pushes away from rest"),
        &written.stiffness,
        "joints whose springs push away from rest",
    );
    check.rests(&written.rest, &written.stiffness);
    check.negative_armature(&written.armature);
    check.negative_friction(&written.friction);
    check.springs(&written.stiffness);
    check.springs(&written.rest);
    check.isotropic_armature(&written.armature);
    for limits in values(&written.limits) {
        check.limits(&limits.value);
    }
    check.limits_of_quaternion(&written.limits);
    if let Some(kind) = &written.kind {
        check.contradictions(kind, written);
    }
}

struct Check<'a> {
    joint: &'a ResolvedJoint,
    /// The joint, or its body, as messages have it.
    name: &'a str,
    /// The joint, as lists of names have it.
    called: &'a str,
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

/// True where a coordinate, not its speed, is limited.
fn is_ranged(limits: &Limits) -> bool {
    limits.lower.is_some() || limits.upper.is_some()
}

/// Where a quantity is given first.
fn first<T>(quantity: &PerCoordinate<T>) -> Option<Span> {
    values(quantity).first().map(|value| value.span)
}

impl Check<'_> {
    fn fault(&mut self, message: String, span: Span, label: &str) {
        self.findings
            .push(Diagnostic::error(message).at(span, label));
    }

    /// What is said of a motion that the joint's name excludes.
    fn contradictions(&mut self, kind: &Spanned<JointKind>, written: &WrittenJoint) {
        let mut refuse = |span: Span, fault: String, help: &str| {
            let fault = Diagnostic::error(fault)
                .at(span, "not expected")
                .at(kind.span, "this joint");
            self.findings.push(fault.help(help));
        };
        let name = self.name;
        match kind.value {
            _ if kind.value.is_fixed() => {
                let given = [
                    ("stiffness", first(&written.stiffness)),
                    ("rest", first(&written.rest)),
                    ("damping", first(&written.damping)),
                    ("armature", first(&written.armature)),
                    ("friction", first(&written.friction)),
                    ("limits", first(&written.limits)),
                    ("mimic", written.mimic.as_ref().map(|mimic| mimic.span)),
                ];
                for (key, span) in given {
                    let Some(span) = span else { continue };
                    let fault = format!("`{key}` of {name} is given, but the joint is fixed");
                    refuse(span, fault, &format!("leave `{key}` out"));
                }
            }
            JointKind::Continuous => {
                for limits in values(&written.limits) {
                    let Limits { lower, upper, .. } = &limits.value;
                    for (key, limit) in [("lower", lower), ("upper", upper)] {
                        let Some(limit) = limit else { continue };
                        let fault =
                            format!("`limits` of {name} has `{key}`, but the joint is continuous");
                        refuse(limit.span, fault, "a joint with such limits is `revolute`");
                    }
                }
            }
            _ => {}
        }
    }

    /// Every coordinate that a quantity names is free.
    fn coordinates<T>(&mut self, quantity: &str, values: &PerCoordinate<T>) {
        let PerCoordinate::Each(values) = values else {
            return;
        };
        for (coordinate, _) in values {
            let (name, kind) = (self.name, coordinate.value.name());
            if self.has_axis {
                let message = format!(
                    "`{quantity}` of {name} names `{kind}`, but the joint has an axis of its own"
                );
                self.fault(message, coordinate.span, "expected one value for the joint");
            } else if matches!(
                self.joint.motions[coordinate.value.index()],
                Freedom::Locked(_)
            ) {
                let message = format!("`{quantity}` of {name} names `{kind}`, which is not free");
                self.fault(message, coordinate.span, "not free");
            }
        }
    }

    fn negative_armature(&mut self, armature: &PerCoordinate<Scalar>) {
        for value in values(armature) {
            let found = value.value.nominal();
            if found < 0.0 {
                let message = format!(
                    "`armature` of {} is {found:?}; expected zero or more",
                    self.name
                );
                self.fault(message, value.span, "negative");
            }
        }
    }

    /// Warns of friction that pushes: it is in no equation.
    fn negative_friction(&mut self, friction: &PerCoordinate<f64>) {
        for value in values(friction)
            .into_iter()
            .filter(|value| value.value < 0.0)
        {
            let message = format!(
                "`friction` of {} is {:?}; it counts as zero",
                self.name, value.value
            );
            let warning = Diagnostic::warning(message).at(value.span, "negative");
            let warning = warning.one_of("negative frictions count as zero", self.called);
            self.findings.push(warning);
        }
    }

    /// Warns of dampers and springs that push: nothing else becomes wrong by them.
    fn negative(
        &mut self,
        (quantity, why): (&str, &str),
        quantities: &PerCoordinate<Scalar>,
        all: &str,
    ) {
        for value in values(quantities) {
            let found = value.value.nominal();
            if found < 0.0 {
                let name = self.name;
                let message =
                    format!("`{quantity}` of {name} is {found:?}: {why}; it is computed as given");
                let warning = Diagnostic::warning(message).at(value.span, "negative");
                let warning = warning.one_of(all, self.called);
                self.findings.push(warning);
            }
        }
    }

    /// Warns of rest positions without springs.
    fn rests(&mut self, rest: &PerCoordinate<Scalar>, stiffness: &PerCoordinate<Scalar>) {
        let has_spring = |coordinate: usize| stiffness.at(coordinate).is_some();
        let idle = match rest {
            PerCoordinate::Absent => None,
            PerCoordinate::Same(value) => Some(value).filter(|_| !(0..6).any(has_spring)),
            PerCoordinate::Each(values) => {
                let mut values = values.iter();
                let idle = values.find(|(coordinate, _)| !has_spring(coordinate.value.index()));
                idle.map(|(_, value)| value)
            }
        };
        if let Some(idle) = idle {
            let message = format!("`rest` of {} has no effect without `stiffness`", self.name);
            let warning =
                Diagnostic::warning(message).at(idle.span, "expected `stiffness` beside it");
            let warning = warning.one_of("joints with `rest` and without `stiffness`", self.called);
            self.findings.push(warning);
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
                let turns = values
                    .iter()
                    .filter(|(coordinate, _)| coordinate.value.is_angle());
                turns.map(|(_, value)| value.span).collect()
            }
        };
        for span in spans {
            let message = format!(
                "a spring acts on a coordinate, but the speeds of {} are components of an angular velocity",
                self.name
            );
            let fault = Diagnostic::error(message).at(span, "no spring can act here");
            let moment = "add the moment of a spring on its orientation to `tau`";
            let help = match self.first_shift() {
                Some(shift) => format!(
                    "springs of its translations are named: `{{ {shift} = 100.0 }}`; {moment}"
                ),
                None => moment.to_owned(),
            };
            self.findings.push(fault.help(help));
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
            .filter(|(coordinate, _)| coordinate.value.is_angle())
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

    /// The name of its first translation.
    fn first_shift(&self) -> Option<&'static str> {
        let shift = self.joint.free().find(|motion| *motion >= 3)?;
        Some(CoordinateName::NAMES[shift])
    }

    /// No coordinate of a quaternion is an angle that could be limited.
    fn limits_of_quaternion(&mut self, quantity: &PerCoordinate<Limits>) {
        if self.joint.chart != Chart::Quaternion {
            return;
        }
        let limits = match quantity {
            PerCoordinate::Absent => None,
            PerCoordinate::Same(limits) => Some(limits),
            PerCoordinate::Each(values) => {
                let mut values = values.iter();
                let of_angle = values.find(|(coordinate, limits)| {
                    coordinate.value.is_angle() && is_ranged(&limits.value)
                });
                of_angle.map(|(_, limits)| limits)
            }
        };
        let Some(limits) = limits.filter(|limits| is_ranged(&limits.value)) else {
            return;
        };
        let message = format!(
            "`lower` and `upper` of {} do not limit its angles: its orientation is a quaternion",
            self.name
        );
        let is_of_all = matches!(quantity, PerCoordinate::Same(_));
        let others = self.first_shift().filter(|_| is_of_all);
        let warning = Diagnostic::warning(message)
            .at(limits.span, "left out for angles")
            .one_of("limits of angles of quaternions are left out", self.called)
            .help_if(others.map(|_| "its translations have them"));
        self.findings.push(warning);
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
                    .at(upper.span, "the upper limit")
                    .one_of("joints have limits that are no range", self.called),
            );
        }
        for (what, limit) in [("velocity", limits.velocity), ("effort", limits.effort)] {
            if let Some(limit) = limit.filter(|limit| limit.value < 0.0) {
                let message = format!(
                    "the `{what}` limit of {} is {:?}; it counts as none",
                    self.name, limit.value
                );
                let warning = Diagnostic::warning(message).at(limit.span, "negative");
                let all = format!("negative limits of {what} count as none");
                self.findings.push(warning.one_of(all, self.called));
            }
        }
    }
}
