//! A body with several joints as several bodies: one without mass for each joint but the last.

use crate::description::mjcf::joints::JointElement;
use crate::description::mjcf::joints::free_inertia::{PosedBody, inertias};
use crate::description::mjcf::joints::seat::{fixed, held, joined};
use crate::description::mjcf::joints::ties::Held;
use crate::description::mjcf::mass::inertial::{MassProperties, WrittenMass};
use crate::description::mjcf::mass::solid::Solid;
use crate::description::mjcf::mass::weight::Weight;
use crate::description::mjcf::names::{self, Wish};
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::description::{Given, Optional, Scalar, WrittenBody, WrittenJoint};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::limits::SPRING_UPDATES;

/// The bodies of a model, before they have their names, weights and seats.
#[derive(Debug, Default)]
pub(super) struct Bodies {
    pub(super) list: Vec<ChainedBody>,
}

/// A body and the joint by which it hangs.
#[derive(Debug)]
pub(super) struct ChainedBody {
    pub(super) span: Span,
    /// `None` where the body is fixed.
    joint: Option<JointElement>,
    /// Where the body stands in its lower body.
    place: Placement,
    /// Where the joint is placed in the file.
    joint_span: Span,
    /// The number of its lower body, from 1, or 0 for the world.
    pub(super) lower: usize,
    wish: Wish,
    pub(super) weight: Weight,
    /// Whether it is part of its lower body, in MuJoCo.
    pub(super) is_fused: bool,
    /// The share of its weight that is lifted.
    lifted: Optional<Scalar>,
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
    pub(super) weight: Weight,
    /// Whether it is part of its lower body, in MuJoCo.
    pub(super) is_fused: bool,
    /// The share of its weight that is lifted; absent: zero.
    pub(super) lifted: Optional<Scalar>,
}

/// The bodies as a description has them.
pub(super) struct WrittenBodies {
    pub(super) list: Vec<WrittenBody>,
    /// Of each the number of its lower body, from 1, or 0 for the world.
    pub(super) lower: Vec<Given<i64>>,
    /// Of each its joint's coordinate in the reference pose, rad, m.
    pub(super) references: Vec<f64>,
}

impl Bodies {
    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    /// True where a share of some weight is lifted upward.
    pub(super) fn lifts_upward(&self) -> bool {
        let mut shares = self.list.iter().filter_map(|body| body.lifted);
        shares.any(|share| share.value.nominal() > 0.0)
    }

    /// Lifts no weight.
    pub(super) fn lift_nothing(&mut self) {
        for body in &mut self.list {
            body.lifted = None;
        }
    }

    /// The names of all joints.
    pub(super) fn joint_names(&self) -> impl Iterator<Item = &str> {
        let joints = self.list.iter().filter_map(|body| body.joint.as_ref());
        joints.filter_map(|joint| Some(joint.name.as_ref()?.value.as_str()))
    }

    /// The names that the file gives to bodies.
    pub(super) fn given_names(&self) -> impl Iterator<Item = &str> {
        self.list.iter().filter_map(|body| match &body.wish {
            Wish::Given(name) => Some(name.value.as_str()),
            _ => None,
        })
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
            let span = element.span;
            self.list.push(ChainedBody {
                span,
                joint: Some(element),
                place,
                joint_span: parts.span,
                lower,
                wish: Wish::After {
                    body: last,
                    joint: name,
                    span,
                },
                weight: Weight::Nothing,
                is_fused: false,
                lifted: None,
            });
            lower = self.list.len();
            place = Placement::SAME;
        }
        self.list.push(ChainedBody {
            span: parts.span,
            joint: joints.next(),
            place,
            joint_span: parts.span,
            lower,
            wish: parts.wish,
            weight: parts.weight,
            is_fused: parts.is_fused,
            lifted: parts.lifted,
        });
    }

    /// True where some weight is lifted.
    pub(super) fn lifts_any(&self) -> bool {
        self.list.iter().any(|body| body.lifted.is_some())
    }

    /// Gives joints the springs and dampers that follow from their inertias.
    fn settle_spring_dampers(&mut self, reader: &mut Reader, factor: Option<f64>) {
        let mut joints = self.list.iter().filter_map(|body| body.joint.as_ref());
        if joints.all(|joint| joint.spring_damper().is_none()) {
            return;
        }
        let posed = self.list.iter().map(|body| PosedBody {
            lower: body.lower,
            place: &body.place,
            joint: body.joint.as_ref(),
            mass: body.solid(factor),
        });
        let Some(inertias) = inertias(&posed.collect::<Vec<_>>()) else {
            let mut joints = self.list.iter().filter_map(|body| body.joint.as_ref());
            let message = format!(
                "springs of `springdamper` follow from the mass matrix, which takes more than {SPRING_UPDATES} updates here"
            );
            let fault =
                Diagnostic::error(message).help("give `stiffness` and `damping` as numbers");
            let place = joints.find_map(JointElement::spring_damper);
            reader.faults.push(fault.at_if(place, "the first one"));
            return;
        };
        for (body, inertia) in self.list.iter_mut().zip(inertias) {
            let Some(joint) = &mut body.joint else {
                continue;
            };
            let Some(place) = joint.spring_damper() else {
                continue;
            };
            if let Some(inertia) = inertia.filter(|inertia| inertia.is_finite() && *inertia > 0.0) {
                joint.settle(inertia);
                continue;
            }
            let message = "this joint has no inertia of its own at the start, from which `springdamper` makes a spring";
            let fault = Diagnostic::error(message)
                .at(place, "it moves no mass, or what other joints move alike");
            reader
                .faults
                .push(fault.help("give `stiffness` and `damping` as numbers"));
        }
    }

    /// The bodies with names, joints of which some are held, and masses that are scaled where the settings give their total.
    pub(super) fn written(
        mut self,
        reader: &mut Reader,
        total_mass: Option<f64>,
        held: &Held,
    ) -> WrittenBodies {
        let wishes: Vec<Wish> = self.list.iter().map(|body| body.wish.clone()).collect();
        let names = names::give(reader, &wishes);
        let total = self.total_mass();
        let factor = total_mass.filter(|_| total > 0.0);
        let factor = factor.map(|wanted| wanted / total);
        self.settle_spring_dampers(reader, factor);
        let lower = |body: &ChainedBody| {
            let number = i64::try_from(body.lower).ok()?;
            Some(Spanned::new(number, body.span))
        };
        WrittenBodies {
            lower: self.list.iter().map(lower).collect(),
            references: self.list.iter().map(ChainedBody::reference).collect(),
            list: self
                .list
                .into_iter()
                .zip(names)
                .map(|(body, name)| body.written(name, factor, held))
                .collect(),
        }
    }
}

impl ChainedBody {
    pub(super) fn mass(&self) -> Option<f64> {
        Some(self.weight.properties()?.mass())
    }

    /// The joint's coordinate in the reference pose, rad, m.
    fn reference(&self) -> f64 {
        self.joint.as_ref().map_or(0.0, |joint| joint.reference)
    }

    /// The joint where it sits, or where it is held.
    fn seated(&self, held_joints: &Held) -> WrittenJoint {
        let (place, span) = (&self.place, self.joint_span);
        let Some(element) = &self.joint else {
            return fixed(place, span);
        };
        let name = element.name.as_ref();
        let by = name.and_then(|name| held_joints.get(&name.value));
        match by.filter(|_| element.axis.is_some()) {
            Some(by) => held(element, place, span, *by),
            None => joined(element, place, span),
        }
    }

    fn solid(&self, factor: Option<f64>) -> Option<Solid> {
        let mass = self.weight.properties()?;
        Some(factor.map_or(*mass, |factor| mass.scaled(factor)).solid())
    }

    fn written(self, name: Spanned<String>, factor: Option<f64>, held: &Held) -> WrittenBody {
        let joint = self.seated(held);
        let mass = match &self.weight {
            Weight::Nothing => Some(MassProperties::massless(self.span)),
            weight => weight.properties().map(|mass| match factor {
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
            gravity_compensation: self.lifted,
            joint,
        }
    }
}
