//! A body with several joints as several bodies: one without mass for each joint but the last.

use crate::description::mjcf::inertial::{MassProperties, WrittenMass};
use crate::description::mjcf::joints::JointElement;
use crate::description::mjcf::names::{self, Wish};
use crate::description::mjcf::placement::Placement;
use crate::description::mjcf::seat::{fixed, held, joined};
use crate::description::mjcf::ties::Held;
use crate::description::xml::Reader;
use crate::description::{Given, WrittenBody, WrittenJoint};
use crate::diagnostic::{Span, Spanned};

/// The bodies of a model, before they have their names and weights.
#[derive(Debug)]
pub(super) struct Bodies {
    list: Vec<ChainedBody>,
    held: Held,
}

/// A body and the joint by which it hangs.
#[derive(Debug)]
struct ChainedBody {
    span: Span,
    joint: WrittenJoint,
    /// The joint's coordinate where the model is drawn, rad, m.
    reference: f64,
    /// The number of its lower body, from 1, or 0 for the world.
    lower: usize,
    wish: Wish,
    weight: Weight,
}

/// What a body weighs.
#[derive(Debug)]
enum Weight {
    /// Nothing: it is there for a joint alone.
    Nothing,
    /// What the file says; `None` where that is faulty.
    Given(Option<Box<MassProperties>>),
}

/// A body with its joints.
pub(super) struct JointedBody {
    pub(super) joints: Vec<JointElement>,
    /// Where the body stands in its lower body.
    pub(super) place: Placement,
    pub(super) span: Span,
    /// The number of its lower body.
    pub(super) lower: usize,
    pub(super) wish: Wish,
    /// `None` where it is faulty.
    pub(super) mass: Option<MassProperties>,
}

/// The bodies as a description has them.
pub(super) struct WrittenBodies {
    pub(super) list: Vec<WrittenBody>,
    /// Of each the number of its lower body, from 1, or 0 for the world.
    pub(super) lower: Vec<Given<i64>>,
    /// Of each its joint's coordinate where the model is drawn, rad, m.
    pub(super) references: Vec<f64>,
}

impl Bodies {
    /// None yet; joints with these names will be held.
    pub(super) fn new(held: Held) -> Self {
        Self {
            list: Vec::new(),
            held,
        }
    }

    /// The joint where it sits, or where it is held.
    fn seated(&self, element: &JointElement, place: &Placement, span: Span) -> WrittenJoint {
        let name = element.name.as_ref();
        let by = name.and_then(|name| self.held.get(&name.value));
        match by.filter(|_| element.axis.is_some()) {
            Some(by) => held(element, place, span, *by),
            None => joined(element, place, span),
        }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    /// Adds a body, behind those that its joints make.
    pub(super) fn add(&mut self, parts: JointedBody) {
        let count = parts.joints.len().max(1);
        let last = self.list.len() + count - 1;
        let mut place = parts.place;
        let mut lower = parts.lower;
        let mut joints = parts.joints.into_iter();
        for index in 1..count {
            let Some(element) = joints.next() else { break };
            let name = element.name.as_ref();
            let name = name.map_or(format!("joint{index}"), |name| name.value.clone());
            self.list.push(ChainedBody {
                span: element.span,
                joint: self.seated(&element, &place, parts.span),
                reference: element.reference,
                lower,
                wish: Wish::After {
                    body: last,
                    joint: name,
                    span: element.span,
                },
                weight: Weight::Nothing,
            });
            lower = self.list.len();
            place = Placement::SAME;
        }
        let (joint, reference) = match joints.next() {
            Some(element) => {
                let joint = self.seated(&element, &place, parts.span);
                (joint, element.reference)
            }
            None => (fixed(&place, parts.span), 0.0),
        };
        self.list.push(ChainedBody {
            span: parts.span,
            joint,
            reference,
            lower,
            wish: parts.wish,
            weight: Weight::Given(parts.mass.map(Box::new)),
        });
    }

    /// The bodies with names, and with masses that are scaled where the settings give their total.
    pub(super) fn written(self, reader: &mut Reader, total_mass: Option<f64>) -> WrittenBodies {
        let wishes: Vec<Wish> = self.list.iter().map(|body| body.wish.clone()).collect();
        let names = names::give(reader, &wishes);
        let total: f64 = self.list.iter().filter_map(ChainedBody::mass).sum();
        let factor = total_mass.filter(|_| total > 0.0);
        let factor = factor.map(|wanted| wanted / total);
        let lower = |body: &ChainedBody| {
            let number = i64::try_from(body.lower).ok()?;
            Some(Spanned::new(number, body.span))
        };
        WrittenBodies {
            lower: self.list.iter().map(lower).collect(),
            references: self.list.iter().map(|body| body.reference).collect(),
            list: self
                .list
                .into_iter()
                .zip(names)
                .map(|(body, name)| body.written(name, factor))
                .collect(),
        }
    }
}

impl ChainedBody {
    fn mass(&self) -> Option<f64> {
        match &self.weight {
            Weight::Nothing => None,
            Weight::Given(mass) => Some(mass.as_ref()?.mass()),
        }
    }

    fn written(self, name: Spanned<String>, factor: Option<f64>) -> WrittenBody {
        let mass = match self.weight {
            Weight::Nothing => Some(MassProperties::massless(self.span)),
            Weight::Given(mass) => mass.map(|mass| match factor {
                Some(factor) => mass.scaled(factor),
                None => *mass,
            }),
        };
        let mass = mass.map_or_else(WrittenMass::default, |mass| mass.written());
        WrittenBody {
            span: self.span,
            name: Some(name),
            mass: mass.mass,
            mass_center: mass.center,
            inertia: mass.inertia,
            inertia_rotation: mass.rotation,
            joint: self.joint,
        }
    }
}
