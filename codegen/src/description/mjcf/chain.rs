//! A body with several joints as several bodies: one without mass for each joint but the last.

use crate::description::mjcf::inertial::{MassProperties, baked};
use crate::description::mjcf::joints::{self, Type};
use crate::description::mjcf::names::Wish;
use crate::description::mjcf::placement::{Placement, about};
use crate::description::{Given, JointKind, Scalar, WrittenBody, WrittenJoint};
use crate::diagnostic::{Span, Spanned};
use crate::geometry::{IDENTITY, Vector, scaled, then};

/// The bodies of a model.
#[derive(Debug, Default)]
pub(super) struct Bodies {
    pub(super) list: Vec<WrittenBody>,
    /// Of each the number of its lower body, from 1, or 0 for the world.
    pub(super) lower: Vec<Given<i64>>,
    /// Of each how it is to be called.
    pub(super) wishes: Vec<Wish>,
    /// Of each its mass; `None` where that is faulty, or where it is there for a joint alone.
    masses: Vec<Option<MassProperties>>,
}

/// A body with its joints.
pub(super) struct Parts {
    pub(super) joints: Vec<joints::Read>,
    /// Where the body stands in its lower body.
    pub(super) place: Placement,
    pub(super) span: Span,
    /// The number of its lower body.
    pub(super) lower: usize,
    pub(super) wish: Wish,
    /// `None` where it is faulty.
    pub(super) mass: Option<MassProperties>,
}

impl Bodies {
    /// Adds a body, behind those that its joints make.
    pub(super) fn add(&mut self, parts: Parts) {
        let count = parts.joints.len().max(1);
        let last = self.list.len() + count - 1;
        let mut place = parts.place;
        let mut lower = parts.lower;
        let mut joints = parts.joints.into_iter();
        for index in 1..count {
            let Some(read) = joints.next() else { break };
            let span = read.span;
            let name = read.joint.name.as_ref();
            let name = name.map_or(format!("joint{index}"), |name| name.value.clone());
            let wish = Wish::After {
                body: last,
                joint: name,
                span,
            };
            let mut body = blank(span, joined(&read, &place, parts.span));
            MassProperties::massless(span).fill(&mut body);
            self.push(body, lower, wish);
            self.masses.push(None);
            lower = self.list.len();
            place = Placement::SAME;
        }
        let joint = match joints.next() {
            Some(read) => joined(&read, &place, parts.span),
            None => fixed(&place, parts.span),
        };
        self.push(blank(parts.span, joint), lower, parts.wish);
        self.masses.push(parts.mass);
    }

    fn push(&mut self, body: WrittenBody, lower: usize, wish: Wish) {
        let number = i64::try_from(lower).ok();
        self.lower
            .push(number.map(|number| Spanned::new(number, body.span)));
        self.list.push(body);
        self.wishes.push(wish);
    }

    /// Scales the masses where the settings give their total, and writes them into the bodies.
    pub(super) fn weigh(&mut self, total_mass: Option<f64>) {
        let total: f64 = self.masses.iter().flatten().map(MassProperties::mass).sum();
        let wanted = total_mass.filter(|_| total > 0.0);
        for (body, mass) in self.list.iter_mut().zip(&mut self.masses) {
            let Some(mass) = mass else { continue };
            if let Some(wanted) = wanted {
                mass.scale(wanted / total);
            }
            mass.fill(body);
        }
    }
}

/// A body of which only the joint is known.
fn blank(span: Span, joint: WrittenJoint) -> WrittenBody {
    WrittenBody {
        span,
        name: None,
        mass: None,
        mass_center: [None; 3],
        inertia: [None; 6],
        inertia_rotation: None,
        joint,
    }
}

fn fixed(place: &Placement, span: Span) -> WrittenJoint {
    let mut joint = WrittenJoint::unknown();
    joint.kind = Some(Spanned::new(JointKind::Fixed, span));
    attach(&mut joint, place, span);
    joint
}

fn attach(joint: &mut WrittenJoint, place: &Placement, span: Span) {
    joint.attachment = vector(place.position, span);
    let turned = place.rotation != IDENTITY;
    joint.attachment_rotation = turned.then(|| Spanned::new(place.rotation, span));
}

fn vector(vector: Vector, span: Span) -> [Given<Scalar>; 3] {
    vector.map(|entry| Some(baked(Spanned::new(entry, span))))
}

/// The joint where it sits: MuJoCo turns (shifts) the body from where it stands, about (along) the joint's axis through
/// its anchor, by the coordinate less the reference.
fn joined(read: &joints::Read, place: &Placement, span: Span) -> WrittenJoint {
    let mut joint = read.joint.clone();
    let mut seat = Placement {
        position: place.point(read.anchor),
        rotation: place.rotation,
    };
    match (read.kind, read.axis) {
        // Its coordinates are those of the body in the world, wherever it is drawn.
        (Type::Free, _) => {
            attach(&mut joint, &Placement::SAME, span);
            return joint;
        }
        (Type::Hinge, Some(axis)) if read.reference != 0.0 => {
            let [sine, cosine] = read.reference_turn;
            seat.rotation = then(&place.rotation, &about(axis, [-sine, cosine]));
        }
        // Where along its line a slide sits makes no difference.
        (Type::Slide, Some(axis)) => {
            seat.position = place.point(scaled(axis, -read.reference));
        }
        _ => {}
    }
    attach(&mut joint, &seat, span);
    if read.kind != Type::Slide && read.anchor != [0.0; 3] {
        joint.body_attachment = Some(vector(read.anchor, read.span));
    }
    joint
}
