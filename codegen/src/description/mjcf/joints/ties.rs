//! Joints that linear equalities tie: to another joint, which they follow, or to a constant, at which they are held.
//!
//! MuJoCo counts from the reference pose: `q1 - ref1 = shift + factor (q2 - ref2)`.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::xml::Reader;
use crate::description::{JointKind, Mimic, WrittenBody};
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};

/// An equality between joints.
#[derive(Clone, Debug)]
pub(in crate::description::mjcf) struct Equation {
    pub(in crate::description::mjcf) joint: Spanned<String>,
    /// `None` where the joint is held.
    pub(in crate::description::mjcf) leader: Option<Spanned<String>>,
    pub(in crate::description::mjcf) shift: f64,
    pub(in crate::description::mjcf) factor: f64,
    /// The words for the equality.
    pub(in crate::description::mjcf) owner: String,
    pub(in crate::description::mjcf) span: Span,
}

/// How joints are tied.
#[derive(Debug, Default)]
pub(in crate::description::mjcf) struct Ties {
    /// By the joint that is tied.
    joints: BTreeMap<String, Equation>,
    /// The names of all equalities.
    pub(in crate::description::mjcf) equalities: BTreeSet<String>,
}

/// How far joints are held from the reference pose, rad, m.
pub(in crate::description::mjcf) type Held = BTreeMap<String, f64>;

impl Ties {
    /// Adds an equation, the other way round where its joint is tied already.
    pub(in crate::description::mjcf) fn add(&mut self, reader: &mut Reader, equation: Equation) {
        let Some(first) = self.joints.get(&equation.joint.value) else {
            self.joints.insert(equation.joint.value.clone(), equation);
            return;
        };
        match turned(&equation) {
            Some(turned) if !self.joints.contains_key(&turned.joint.value) => {
                self.joints.insert(turned.joint.value.clone(), turned);
            }
            _ => {
                let name = shown(&equation.joint.value);
                let message = format!(
                    "{} ties joint `{name}`, which is tied already",
                    equation.owner
                );
                let fault = Diagnostic::error(message).at(equation.span, "the second one");
                reader.faults.push(fault.at(first.span, "the first one"));
            }
        }
    }

    /// The joints that are held, directly or by one that they follow.
    pub(in crate::description::mjcf) fn held(&self) -> Held {
        let mut held = Held::new();
        let mut followers: BTreeMap<&str, Vec<&Equation>> = BTreeMap::new();
        let mut open = Vec::new();
        for equation in self.joints.values() {
            match &equation.leader {
                Some(leader) if equation.factor != 0.0 => {
                    followers.entry(&leader.value).or_default().push(equation);
                }
                _ => open.push((equation, equation.shift)),
            }
        }
        while let Some((equation, by)) = open.pop() {
            held.insert(equation.joint.value.clone(), by + 0.0);
            let following = followers.remove(equation.joint.value.as_str());
            let following = following.unwrap_or_default().into_iter();
            open.extend(following.map(|next| (next, next.shift + next.factor * by)));
        }
        held
    }

    /// Lets joints follow others; `references` are the coordinates of all joints in the reference pose.
    pub(in crate::description::mjcf) fn apply(
        &self,
        reader: &mut Reader,
        bodies: &mut [WrittenBody],
        references: &[f64],
    ) {
        let named = places(bodies, |body| body.joint.name.as_ref());
        let answering = places(bodies, WrittenBody::joint_name);
        let held = self.held();
        for equation in self.joints.values() {
            let joint = place(reader, bodies, &named, equation, &equation.joint);
            let leader = equation.leader.as_ref();
            let leader =
                leader.map(|leader| (leader, place(reader, bodies, &named, equation, leader)));
            let Some(joint) = joint else { continue };
            let joint_name = shown(&equation.joint.value);
            if let Some(by) = held.get(&equation.joint.value) {
                let message = format!(
                    "{} holds joint `{joint_name}`, {by} from the reference pose",
                    equation.owner
                );
                let note = Diagnostic::note(message).at(equation.span, "held");
                reader
                    .faults
                    .push(note.one_of("joints that equalities hold", &joint_name));
                continue;
            }
            let Some((name, Some(leader))) = leader else {
                continue;
            };
            if answering.get(&name.value) != Some(&leader) {
                let message = format!(
                    "`{}` is a joint and a body whose joint has no name",
                    shown(&name.value)
                );
                let fault = Diagnostic::error(message).at(name.span, "followed here");
                reader.faults.push(fault.help("give that joint a name"));
                continue;
            }
            let message = format!(
                "joint `{joint_name}` follows `{}` exactly, as {} says",
                shown(&name.value),
                equation.owner
            );
            let note = Diagnostic::note(message)
                .at(equation.span, "exact here, a soft constraint in MuJoCo");
            reader
                .faults
                .push(note.one_of("joints that follow others by equalities", &joint_name));
            let offset = references[joint] + equation.shift - equation.factor * references[leader];
            let mimic = Mimic {
                joint: name.clone(),
                multiplier: equation.factor,
                offset: offset + 0.0,
            };
            bodies[joint].joint.mimic = Some(Spanned::new(mimic, equation.span));
        }
    }
}

/// The first body of each name.
fn places(
    bodies: &[WrittenBody],
    name: impl Fn(&WrittenBody) -> Option<&Spanned<String>>,
) -> BTreeMap<String, usize> {
    let mut places = BTreeMap::new();
    for (index, body) in bodies.iter().enumerate() {
        if let Some(name) = name(body) {
            places.entry(name.value.clone()).or_insert(index);
        }
    }
    places
}

/// The joint of this name: a hinge or a slide, or one that was, before it was held.
fn place(
    reader: &mut Reader,
    bodies: &[WrittenBody],
    named: &BTreeMap<String, usize>,
    equation: &Equation,
    name: &Spanned<String>,
) -> Option<usize> {
    let found = named.get(&name.value).copied();
    let kind = found.and_then(|body| bodies[body].joint.kind.as_ref());
    let problem = match kind.map(|kind| &kind.value) {
        Some(JointKind::Revolute | JointKind::Prismatic | JointKind::Fixed) => return found,
        None => "which is no joint",
        Some(_) => "which is no hinge and no slide",
    };
    let message = format!(
        "{} ties `{}`, {problem}",
        equation.owner,
        shown(&name.value)
    );
    let fault = Diagnostic::error(message).at(name.span, "expected a hinge or a slide");
    reader.faults.push(fault);
    None
}

/// The equation solved for the joint that leads.
fn turned(equation: &Equation) -> Option<Equation> {
    let leader = equation.leader.clone().filter(|_| equation.factor != 0.0)?;
    Some(Equation {
        joint: leader,
        leader: Some(equation.joint.clone()),
        shift: 0.0 - equation.shift / equation.factor,
        factor: 1.0 / equation.factor,
        ..equation.clone()
    })
}
