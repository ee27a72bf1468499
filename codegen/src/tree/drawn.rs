//! A tree of the same bodies and joints whose numbers are drawn: what holds of it holds of the structure, not of values.

use crate::geometry::{self, IDENTITY, Rotation};
use crate::random::Random;
use crate::tree::body::{Body, Inertia, Pose, RigidPart};
use crate::tree::frames::Frame;
use crate::tree::joint::{Coordinate, Joint, Orientation};
use crate::tree::mechanics::Mechanics;
use crate::tree::offset::{Offset, Step};
use crate::tree::system::Tree;
use crate::tree::value::Value;

impl Tree {
    /// The tree with other numbers in the place of all that are baked in, drawn by a seed. No length, mass, inertia, spring, damper
    /// or rotor is zero, and no axes are parallel, so that only the structure is left. What is set at run time stays so.
    #[must_use]
    pub fn with_drawn_numbers(&self, seed: u64) -> Self {
        let mut drawn = Drawn(Random::new(seed));
        Self {
            gravity: self.gravity.map(|component| drawn.value(component)),
            bodies: self.bodies.iter().map(|body| drawn.body(body)).collect(),
            frames: self.frames.iter().map(|own| drawn.frame(own)).collect(),
            markers: self.markers.iter().map(|own| drawn.frame(own)).collect(),
            ..self.clone()
        }
    }
}

struct Drawn(Random);

impl Drawn {
    /// Between a quarter and 1.25 in magnitude.
    fn number(&mut self) -> f64 {
        let number = self.0.signed();
        number + 0.25_f64.copysign(number)
    }

    fn vector(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.number())
    }

    fn rotation(&mut self) -> Rotation {
        geometry::body_fixed_123(self.vector())
    }

    fn value(&mut self, value: Value) -> Value {
        match value {
            Value::Baked(_) => Value::Baked(self.number()),
            Value::Runtime(_) => value,
        }
    }

    /// A vector to which what is set at run time is added as before.
    fn offset(&mut self, offset: &Offset) -> Offset {
        let own = Offset::new(IDENTITY, self.vector().map(Value::Baked));
        let mut steps = offset.steps().iter();
        let is_set = |value: &Value| matches!(value, Value::Runtime(_));
        let mut of_step = |sum: Offset, step: &Step| {
            let vector = step.vector.map(|value| self.value(value));
            let rotation = self.rotation();
            sum.plus(Step {
                rotation,
                vector,
                ..*step
            })
        };
        let steps = steps.by_ref().filter(|step| step.vector.iter().any(is_set));
        steps.fold(own, &mut of_step)
    }

    fn pose(&mut self, pose: &Pose) -> Pose {
        Pose {
            rotation: self.rotation(),
            origin: self.offset(&pose.origin),
        }
    }

    fn frame(&mut self, frame: &Frame) -> Frame {
        Frame {
            rotation: self.rotation(),
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
            axes: self.rotation(),
        }
    }

    fn joint(&mut self, joint: &Joint) -> Joint {
        let mut mechanics = joint.mechanics.map(|own| Mechanics {
            stiffness: self.value(own.stiffness),
            rest: self.value(own.rest),
            damping: self.value(own.damping),
            armature: self.value(own.armature),
            ..own
        });
        let orientation = match joint.orientation {
            Orientation::Rates(angles) => {
                Orientation::Rates(angles.map(|own| self.coordinate(own)))
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
            rotation: self.rotation(),
            attachment: self.offset(&joint.attachment),
            orientation,
            translations: joint.translations.map(|own| self.coordinate(own)),
            mechanics,
            ..joint.clone()
        }
    }

    fn coordinate(&mut self, coordinate: Coordinate) -> Coordinate {
        match coordinate {
            Coordinate::Free { .. } => coordinate,
            Coordinate::Mimic {
                coordinate, speed, ..
            } => Coordinate::Mimic {
                coordinate,
                speed,
                multiplier: self.number(),
                offset: self.number(),
            },
            Coordinate::Locked(_) => Coordinate::Locked(self.number()),
        }
    }
}
