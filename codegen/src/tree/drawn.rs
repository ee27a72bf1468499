//! A tree of the same bodies and joints whose numbers are drawn: what holds of it holds of the structure, not of values.

use crate::geometry::{self, IDENTITY, Rotation};
use crate::id::ParameterId;
use crate::random::Random;
use crate::tree::body::{Body, Inertia, Pose, RigidPart};
use crate::tree::frames::Frame;
use crate::tree::joint::{Coordinate, Joint, Orientation};
use crate::tree::mechanics::Mechanics;
use crate::tree::offset::{Offset, Step};
use crate::tree::system::Tree;
use crate::tree::value::{Parameter, Value};

impl Tree {
    /// The tree with other numbers in the place of all that are baked in, drawn by a seed. No length, mass, inertia, spring, damper
    /// or rotor is zero, and no axes are parallel, so that only the structure is left. What is set at run time stays so, and which base
    /// parameters there are, where that is known.
    #[must_use]
    pub fn with_drawn_numbers(&self, seed: u64) -> Self {
        self.drawn(seed, None, Shared::Kept)
    }

    /// The same with all values set at run time, after those that were; rotations have rational entries. So nothing is rounded
    /// where expressions are built.
    pub(crate) fn with_drawn_parameters(&self, seed: u64) -> Self {
        self.drawn(seed, Some(self.parameters.clone()), Shared::Kept)
    }

    /// The same where coordinates of a joint that share a value each have one of their own, as if the value were a number; `None` where
    /// none do.
    pub(crate) fn with_drawn_parameters_apart(&self, seed: u64) -> Option<Self> {
        let shares = |body: &Body| apart(&body.joint.mechanics) != body.joint.mechanics;
        let shares = self.bodies.iter().any(shares);
        shares.then(|| self.drawn(seed, Some(self.parameters.clone()), Shared::Apart))
    }

    fn drawn(&self, seed: u64, parameters: Option<Vec<Parameter>>, shared: Shared) -> Self {
        let mut drawn = Drawn {
            values: Random::new(seed),
            joints: Random::new(!seed),
            parameters,
            shared,
        };
        let tree = Self {
            // Which entries are zero does not depend on how much is lifted.
            lifted: 0.0,
            gravity: self.gravity.map(|component| drawn.value(component)),
            bodies: self.bodies.iter().map(|body| drawn.body(body)).collect(),
            frames: self.frames.iter().map(|own| drawn.frame(own)).collect(),
            markers: self.markers.iter().map(|own| drawn.frame(own)).collect(),
            base_parameters: self.base_parameters.kept(),
            ..self.clone()
        };
        Self {
            parameters: drawn.parameters.unwrap_or(tree.parameters),
            ..tree
        }
    }
}

struct Drawn {
    /// For masses, lengths, what acts in joints, and how parts are turned.
    values: Random,
    /// For what stays a number: how joints are turned, and what is constant in them. It is the same whatever is set at run time.
    joints: Random,
    /// Where all values are set at run time, those that there are.
    parameters: Option<Vec<Parameter>>,
    shared: Shared,
}

/// What becomes of a value set at run time that several coordinates of a joint share.
enum Shared {
    Kept,
    Apart,
}

impl Drawn {
    /// Between a quarter and 1.25 in magnitude.
    fn number(&mut self) -> f64 {
        let number = self.values.signed();
        number + 0.25_f64.copysign(number)
    }

    fn vector(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.number())
    }

    /// An eighth of a whole number, of which sums and products are exact.
    fn eighths(&mut self) -> f64 {
        whole(&mut self.joints) / 8.0
    }

    /// An angle whose sine and cosine are fractions with the denominator 5, 13, 17 or 25.
    fn angle(&mut self) -> f64 {
        let [first, second, sign] = [0; 3].map(|_| self.joints.signed());
        let (a, b) = match (first < 0.0, second < 0.0) {
            (false, false) => (1.0, 2.0),
            (false, true) => (2.0, 3.0),
            (true, false) => (1.0, 4.0),
            (true, true) => (3.0_f64, 4.0),
        };
        2.0 * libm::atan2(a, b).copysign(sign)
    }

    fn value(&mut self, value: Value) -> Value {
        if let Value::Runtime(_) = value {
            return value;
        }
        let number = self.number();
        let Some(parameters) = &mut self.parameters else {
            return Value::Baked(number);
        };
        parameters.push(Parameter {
            name: format!("drawn_{}", parameters.len()),
            body: None,
            nominal: number,
            unit: "",
        });
        Value::Runtime(ParameterId::new(parameters.len() - 1))
    }

    /// A vector to which what is set at run time is added as before.
    fn offset(&mut self, offset: &Offset) -> Offset {
        let own = [0; 3].map(|_| self.value(Value::Baked(0.0)));
        let own = Offset::new(IDENTITY, own);
        let is_set = |value: &Value| matches!(value, Value::Runtime(_));
        let steps = offset.steps().iter();
        let steps = steps.filter(|step| step.vector.iter().any(is_set));
        steps.fold(own, |sum, step| {
            sum.plus(Step {
                rotation: rotation(&mut self.values),
                vector: step.vector.map(|value| self.value(value)),
                ..*step
            })
        })
    }

    fn pose(&mut self, pose: &Pose) -> Pose {
        Pose {
            rotation: rotation(&mut self.joints),
            origin: self.offset(&pose.origin),
        }
    }

    fn frame(&mut self, frame: &Frame) -> Frame {
        Frame {
            rotation: rotation(&mut self.values),
            position: self.vector(),
            pose: self.pose(&frame.pose),
            turn: frame
                .turn
                .map(|turn| turn.map(|row| row.map(|entry| self.value(entry)))),
            ..frame.clone()
        }
    }

    fn body(&mut self, body: &Body) -> Body {
        Body {
            parts: body.parts.iter().map(|part| self.part(part)).collect(),
            joint: self.joint(&body.joint),
            pose: self.pose(&body.pose),
            ..body.clone()
        }
    }

    fn part(&mut self, part: &RigidPart) -> RigidPart {
        let of = part.inertia;
        let [xx, yy, zz, xy, xz, yz] =
            [of.xx, of.yy, of.zz, of.xy, of.xz, of.yz].map(|entry| self.value(entry));
        RigidPart {
            mass: self.value(part.mass),
            mass_center: self.offset(&part.mass_center),
            inertia: Inertia {
                xx,
                yy,
                zz,
                xy,
                xz,
                yz,
            },
            axes: rotation(&mut self.values),
            lifted: if part.is_lifted() {
                self.value(part.lifted)
            } else {
                part.lifted
            },
        }
    }

    fn joint(&mut self, joint: &Joint) -> Joint {
        let given = match self.shared {
            Shared::Kept => joint.mechanics,
            Shared::Apart => apart(&joint.mechanics),
        };
        let mut mechanics = given.map(|own| Mechanics {
            stiffness: self.value(own.stiffness),
            rest: self.value(own.rest),
            damping: self.value(own.damping),
            armature: self.value(own.armature),
            ..own
        });
        let orientation = match joint.orientation {
            Orientation::Rates(angles) => {
                // A constant turn before all motions or after them is part of the drawn rotations there.
                let moves = |own: &Coordinate| own.motion().is_some();
                let between = moves(&angles[0]) && moves(&angles[2]);
                let both = angles.iter().any(moves) && joint.translations.iter().any(moves);
                let is_own = between || both;
                Orientation::Rates(angles.map(|own| match own {
                    Coordinate::Locked(_) if !is_own => Coordinate::Locked(0.0),
                    own => self.coordinate(own, Self::angle),
                }))
            }
            orientation @ Orientation::AngularVelocity { .. } => {
                // No spring acts there, and the rotors of all three are one.
                let armature = mechanics[0].armature;
                for (own, given) in mechanics.iter_mut().zip(&joint.mechanics).take(3) {
                    own.armature = armature;
                    own.stiffness = given.stiffness;
                }
                orientation
            }
        };
        Joint {
            rotation: rotation(&mut self.joints),
            attachment: self.offset(&joint.attachment),
            orientation,
            translations: joint
                .translations
                .map(|own| self.coordinate(own, Self::eighths)),
            mechanics,
            ..joint.clone()
        }
    }

    fn coordinate(&mut self, coordinate: Coordinate, locked: fn(&mut Self) -> f64) -> Coordinate {
        match coordinate {
            Coordinate::Free { .. } => coordinate,
            Coordinate::Mimic {
                coordinate, speed, ..
            } => Coordinate::Mimic {
                coordinate,
                speed,
                multiplier: self.eighths() / 2.0,
                offset: self.eighths(),
            },
            Coordinate::Locked(_) => Coordinate::Locked(locked(self)),
        }
    }
}

/// What acts in a joint, with a number in the place of a value set at run time that a coordinate before has too.
fn apart(mechanics: &[Mechanics; 6]) -> [Mechanics; 6] {
    let mut apart = *mechanics;
    for (place, own) in apart.iter_mut().enumerate().skip(1) {
        let before = &mechanics[..place];
        let unless_shared = |value: Value, of: fn(&Mechanics) -> Value| {
            let is_set = matches!(value, Value::Runtime(_));
            let is_shared = is_set && before.iter().any(|other| of(other) == value);
            if is_shared { Value::Baked(0.0) } else { value }
        };
        own.stiffness = unless_shared(own.stiffness, |other| other.stiffness);
        own.rest = unless_shared(own.rest, |other| other.rest);
        own.damping = unless_shared(own.damping, |other| other.damping);
        own.armature = unless_shared(own.armature, |other| other.armature);
    }
    apart
}

/// A whole number of either sign between 2 and 9. Entries of rotations become fractions with small denominators, which are told
/// from others when they are rounded, and also products of a few.
fn whole(random: &mut Random) -> f64 {
    let number = (8.0 * random.signed()).trunc();
    number + 2.0_f64.copysign(number)
}

/// A rotation with rational entries, none of which is zero.
fn rotation(random: &mut Random) -> Rotation {
    loop {
        let quaternion = [0; 4].map(|_| whole(random));
        let rotation = geometry::of_quaternion(quaternion);
        let is_plain = |entry: &f64| entry.abs() < 1e-3;
        if let Some(found) = rotation
            && !found.as_flattened().iter().any(is_plain)
        {
            return found;
        }
    }
}
