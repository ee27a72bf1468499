//! Springs, dampers, rotors, friction and limits: from quantities as written to those of each motion.

use crate::description::{PerCoordinate, Scalar, WrittenJoint};
use crate::diagnostic::Spanned;
use crate::id::BodyId;
use crate::tree::joints::{Freedom, ResolvedJoint};
use crate::tree::mechanics::Mechanics;
use crate::tree::value::Value;
use crate::tree::values::parameters::Parameters;

/// The units of a quantity.
struct Units {
    angles: &'static str,
    translations: &'static str,
    /// That of a value of both.
    both: &'static str,
}

const STIFFNESS: Units = Units {
    angles: "N m/rad",
    translations: "N/m",
    both: "N m/rad and N/m",
};
const REST: Units = Units {
    angles: "rad",
    translations: "m",
    both: "rad and m",
};
const DAMPING: Units = Units {
    angles: "N m s/rad",
    translations: "N s/m",
    both: "N m s/rad and N s/m",
};
const ARMATURE: Units = Units {
    angles: "kg m^2",
    translations: "kg",
    both: "kg m^2 and kg",
};

impl Units {
    /// That of a value of these motions.
    fn of(&self, motions: &[usize]) -> &'static str {
        let turns = motions.iter().any(|motion| *motion < 3);
        let slides = motions.iter().any(|motion| *motion >= 3);
        match (turns, slides) {
            (true, true) => self.both,
            (_, false) => self.angles,
            (false, true) => self.translations,
        }
    }
}

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
    let stiffness = reader.values("stiffness", &written.stiffness, &STIFFNESS);
    let rest = reader.values("rest", &written.rest, &REST);
    let damping = reader.values("damping", &written.damping, &DAMPING);
    let armature = reader.values("armature", &written.armature, &ARMATURE);
    // What is negative is left out.
    let bound = |limit: Option<Spanned<f64>>| {
        let limit = limit.filter(|limit| limit.value >= 0.0);
        limit.map_or(f64::INFINITY, |limit| limit.value)
    };
    std::array::from_fn(|motion| {
        let limits = written.limits.at(motion).unwrap_or_default();
        Mechanics {
            stiffness: stiffness[motion],
            rest: rest[motion],
            damping: damping[motion],
            armature: armature[motion],
            friction: written.friction.at(motion).unwrap_or(0.0).max(0.0),
            range: [
                limits.lower.map_or(f64::NEG_INFINITY, |limit| limit.value),
                limits.upper.map_or(f64::INFINITY, |limit| limit.value),
            ],
            velocity: bound(limits.velocity),
            effort: bound(limits.effort),
        }
    })
}

struct Reader<'a> {
    parameters: &'a mut Parameters,
    joint: &'a ResolvedJoint,
    body: BodyId,
}

impl Reader<'_> {
    /// A quantity along the six motions.
    fn values(
        &mut self,
        quantity: &str,
        given: &PerCoordinate<Scalar>,
        units: &Units,
    ) -> [Value; 6] {
        let mut values = [Value::Baked(0.0); 6];
        let prefix = self.joint.identifier.clone();
        let mut value = |scalar, name, motions: &[usize]| {
            let unit = units.of(motions);
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
                if !moving.is_empty() {
                    let shared = value(*scalar, format!("{prefix}_{quantity}"), &moving);
                    for motion in moving {
                        values[motion] = shared;
                    }
                }
            }
            PerCoordinate::Each(given) => {
                for (coordinate, scalar) in given {
                    let name = format!("{prefix}_{}_{quantity}", coordinate.value.name());
                    let motion = coordinate.value.index();
                    values[motion] = value(*scalar, name, &[motion]);
                }
            }
        }
        values
    }
}
