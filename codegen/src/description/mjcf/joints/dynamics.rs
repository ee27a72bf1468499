//! Springs, dampers, rotors and friction of joints.

use crate::description::mjcf::joints::joint_type::{JointType, angle_unit};
use crate::description::mjcf::joints::spring_damper::SpringDamper;
use crate::description::mjcf::mass::inertial::baked;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::settings::{Settings, Switch, TRUTH};
use crate::description::xml::Reader;
use crate::description::{PerCoordinate, Scalar};
use crate::diagnostic::{Diagnostic, Span, Spanned};

/// What acts along the coordinates of a joint.
#[derive(Clone, Debug, Default)]
pub(in crate::description::mjcf) struct Dynamics {
    pub(in crate::description::mjcf) stiffness: PerCoordinate<Scalar>,
    pub(in crate::description::mjcf) rest: PerCoordinate<Scalar>,
    pub(in crate::description::mjcf) damping: PerCoordinate<Scalar>,
    pub(in crate::description::mjcf) armature: PerCoordinate<Scalar>,
    pub(in crate::description::mjcf) friction: PerCoordinate<f64>,
    /// Where spring and damper follow from the inertia: the rule, and which of the two there are.
    pub(in crate::description::mjcf) spring_damper: Option<(Spanned<SpringDamper>, [Switch; 2])>,
    /// Where it is left to an actuator to lift weights.
    pub(in crate::description::mjcf) by_actuator: Option<Span>,
}

impl Dynamics {
    /// Gives the spring and the damper that follow from the joint's inertia, kg m² or kg.
    pub(in crate::description::mjcf) fn settle(&mut self, inertia: f64) {
        let Some((rule, [springs, dampers])) = self.spring_damper.take() else {
            return;
        };
        let same = |value: f64| PerCoordinate::Same(baked(Spanned::new(value, rule.span)));
        if springs == Switch::On {
            self.stiffness = same(rule.value.stiffness(inertia));
        }
        if dampers == Switch::On {
            self.damping = same(rule.value.damping(inertia));
        }
    }
}

/// Spring, damper, rotor and friction.
pub(in crate::description::mjcf) fn dynamics(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    kind: JointType,
) -> Dynamics {
    for (name, counts) in [
        ("stiffness", settings.springs),
        ("damping", settings.dampers),
    ] {
        if counts == Switch::On {
            polynomial(reader, given, name);
        }
    }
    let feels = settings.springs == Switch::On || settings.dampers == Switch::On;
    let spring_damper = feels.then(|| spring_damper(reader, given, kind)).flatten();
    let same = |value: Option<Spanned<f64>>| {
        value.map_or(PerCoordinate::Absent, |value| {
            PerCoordinate::Same(baked(value))
        })
    };
    let springs =
        settings.springs == Switch::On && matches!(kind, JointType::Hinge | JointType::Slide);
    let stiffness = springs.then(|| first(reader, given, "stiffness")).flatten();
    let has_spring = stiffness.is_some() || springs && spring_damper.is_some();
    if has_spring {
        yielding(reader, given);
    }
    let rest = given.number(reader, "springref");
    let rest = rest.filter(|_| has_spring).map(|rest| {
        let angle = angle_unit(kind, settings).radians(rest.value);
        Spanned::new(angle, rest.span)
    });
    let dampers = settings.dampers == Switch::On;
    let damping = dampers.then(|| first(reader, given, "damping")).flatten();
    let not_zero = |number: Option<Spanned<f64>>| number.filter(|number| number.value != 0.0);
    let armature = not_zero(given.number(reader, "armature"));
    let friction = not_zero(given.number(reader, "frictionloss"));
    let by_actuator = given.keyword(reader, "actuatorgravcomp", &TRUTH);
    let by_actuator = by_actuator.filter(|by| by.value == Switch::On);
    Dynamics {
        by_actuator: by_actuator.map(|by| by.span),
        stiffness: same(stiffness),
        rest: same(rest),
        damping: same(damping),
        armature: same(armature),
        friction: friction.map_or(PerCoordinate::Absent, PerCoordinate::Same),
        spring_damper: spring_damper.map(|rule| (rule, [settings.springs, settings.dampers])),
    }
}

/// The first of up to three coefficients, where it is not zero.
pub(in crate::description::mjcf) fn first(
    reader: &mut Reader,
    given: &Attributes<'_>,
    name: &str,
) -> Option<Spanned<f64>> {
    let coefficients = given.up_to(reader, name, 3)?;
    coefficients
        .first()
        .copied()
        .filter(|first| first.value != 0.0)
}

/// Coefficients after the first are those of squares and cubes.
fn polynomial(reader: &mut Reader, given: &Attributes<'_>, name: &str) {
    let coefficients = given.up_to(reader, name, 3).unwrap_or_default();
    let mut others = coefficients.iter().enumerate().skip(1);
    if let Some((place, other)) = others.find(|(_, other)| other.value != 0.0) {
        let message = format!(
            "{} has the coefficient {} of a higher power; expected one that is linear",
            given.what_of_entry(name, place),
            other.value
        );
        let fault = Diagnostic::error(message).at(other.span, "not supported");
        reader.faults.push(fault);
    }
}

/// What MuJoCo computes a spring and a damper from, where it does.
fn spring_damper(
    reader: &mut Reader,
    given: &Attributes<'_>,
    kind: JointType,
) -> Option<Spanned<SpringDamper>> {
    let [time_constant, damping_ratio]: [Spanned<f64>; 2] =
        given.numbers(reader, "springdamper")?;
    let span = given.place("springdamper");
    let pair = [time_constant.value, damping_ratio.value];
    if pair == [0.0; 2] {
        return None;
    }
    if pair.iter().any(|entry| *entry <= 0.0) {
        let message = format!(
            "{} is {} {}; expected two positive numbers",
            given.what("springdamper"),
            pair[0],
            pair[1]
        );
        let fault = Diagnostic::error(message).at(span, "expected more than 0");
        reader.faults.push(fault);
        return None;
    }
    if !matches!(kind, JointType::Hinge | JointType::Slide) {
        let message = format!(
            "{} makes a spring about all axes, which is not supported",
            given.what("springdamper")
        );
        let fault = Diagnostic::error(message).at(span, "expected a hinge or a slide");
        reader.faults.push(fault);
        return None;
    }
    let rule = SpringDamper {
        time_constant: time_constant.value,
        damping_ratio: damping_ratio.value,
    };
    Some(Spanned::new(rule, span))
}

/// Refuses springs that yield.
fn yielding(reader: &mut Reader, given: &Attributes<'_>) {
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
