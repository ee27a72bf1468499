//! Springs, dampers, rotors and friction of joints.

use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::inertial::baked;
use crate::description::mjcf::joint_type::{JointType, angle_unit};
use crate::description::mjcf::settings::{Settings, Switch};
use crate::description::xml::Reader;
use crate::description::{PerCoordinate, Scalar};
use crate::diagnostic::{Diagnostic, Spanned};

/// What acts along the coordinates of a joint.
#[derive(Clone, Debug, Default)]
pub(super) struct Dynamics {
    pub(super) stiffness: PerCoordinate<Scalar>,
    pub(super) rest: PerCoordinate<Scalar>,
    pub(super) damping: PerCoordinate<Scalar>,
    pub(super) armature: PerCoordinate<Scalar>,
    pub(super) friction: PerCoordinate<f64>,
}

/// Spring, damper, rotor and friction.
pub(super) fn dynamics(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    kind: JointType,
) -> Dynamics {
    for name in ["stiffness", "damping"] {
        polynomial(reader, given, name);
    }
    spring_damper(reader, given);
    let same = |value: Option<Spanned<f64>>| {
        value.map_or(PerCoordinate::Absent, |value| {
            PerCoordinate::Same(baked(value))
        })
    };
    let springs =
        settings.springs == Switch::On && matches!(kind, JointType::Hinge | JointType::Slide);
    let stiffness = springs.then(|| first(reader, given, "stiffness")).flatten();
    let rest = stiffness.and_then(|_| given.number(reader, "springref"));
    let rest = rest.map(|rest| {
        let angle = angle_unit(kind, settings).radians(rest.value);
        Spanned::new(angle, rest.span)
    });
    let dampers = settings.dampers == Switch::On;
    let damping = dampers.then(|| first(reader, given, "damping")).flatten();
    let not_zero = |number: Option<Spanned<f64>>| number.filter(|number| number.value != 0.0);
    let armature = not_zero(given.number(reader, "armature"));
    let friction = not_zero(given.number(reader, "frictionloss"));
    Dynamics {
        stiffness: same(stiffness),
        rest: same(rest),
        damping: same(damping),
        armature: same(armature),
        friction: friction.map_or(PerCoordinate::Absent, PerCoordinate::Same),
    }
}

/// The first of up to three coefficients, where it is not zero.
pub(super) fn first(
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
