//! Springs, dampers, rotors, friction and limits: from quantities as written to those of each motion.

use crate::description::{PerCoordinate, Scalar, WrittenJoint};
use crate::id::BodyId;
use crate::tree::joints::{Freedom, ResolvedJoint};
use crate::tree::mechanics::Mechanics;
use crate::tree::value::Value;
use crate::tree::values::parameters::Parameters;

/// What acts along the six motions of the joint of a body, and how far they go.
pub(super) fn of(
    parameters: &mut Parameters,
    written: &WrittenJoint,
    joint: &ResolvedJoint,
    body: BodyId,
) -> [Mechanics; 6] {
    let mut reader = Reader {
        parameters,
        joint,
        body,
    };
    let stiffness = reader.values("stiffness", &written.stiffness, ["N m/rad", "N/m"]);
    let rest = reader.values("rest", &written.rest, ["rad", "m"]);
    let damping = reader.values("damping", &written.damping, ["N m s/rad", "N s/m"]);
    let armature = reader.values("armature", &written.armature, ["kg m^2", "kg"]);
    std::array::from_fn(|motion| {
        let limits = written.limits.at(motion).unwrap_or_default();
        Mechanics {
            stiffness: stiffness[motion],
            rest: rest[motion],
            damping: damping[motion],
            armature: armature[motion],
            friction: written.friction.at(motion).unwrap_or(0.0),
            range: [
                limits.lower.map_or(f64::NEG_INFINITY, |limit| limit.value),
                limits.upper.map_or(f64::INFINITY, |limit| limit.value),
            ],
            velocity: limits.velocity.map_or(f64::INFINITY, |limit| limit.value),
            effort: limits.effort.map_or(f64::INFINITY, |limit| limit.value),
        }
    })
}

struct Reader<'a> {
    parameters: &'a mut Parameters,
    joint: &'a ResolvedJoint,
    body: BodyId,
}

impl Reader<'_> {
    /// A quantity along the six motions; its unit differs between angles and translations.
    fn values(
        &mut self,
        quantity: &str,
        given: &PerCoordinate<Scalar>,
        units: [&'static str; 2],
    ) -> [Value; 6] {
        let mut values = [Value::Baked(0.0); 6];
        let prefix = self.joint.identifier.clone();
        let mut value = |scalar, name, motion: usize| {
            let unit = units[usize::from(motion >= 3)];
            let value = self
                .parameters
                .value(Some(scalar), name, Some(self.body), unit);
            value.unwrap_or(Value::Baked(0.0))
        };
        match given {
            PerCoordinate::Absent => {}
            PerCoordinate::Same(scalar) => {
                let is_moving =
                    |motion: &usize| !matches!(self.joint.motions[*motion], Freedom::Locked(_));
                let moving: Vec<usize> = (0..6).filter(is_moving).collect();
                if let Some(first) = moving.first() {
                    let shared = value(*scalar, format!("{prefix}_{quantity}"), *first);
                    for motion in moving {
                        values[motion] = shared;
                    }
                }
            }
            PerCoordinate::Each(given) => {
                for (coordinate, scalar) in given {
                    let name = format!("{prefix}_{}_{quantity}", coordinate.value.name());
                    values[coordinate.value.index()] =
                        value(*scalar, name, coordinate.value.index());
                }
            }
        }
        values
    }
}
