//! Joints that linear equalities tie: to another joint, which they follow, or to a constant, at which they are held.
//!
//! MuJoCo counts from the reference pose: `q1 - ref1 = shift + factor (q2 - ref2)`.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::xml::Reader;
use crate::description::{Description, JointKind, Mimic, WrittenBody};
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

/// What joints are that equalities hold, as it stands after a number.
const HELD: &str = "joints that equalities hold";

/// The first equality that holds a joint.
pub(crate) fn holding(description: &Description) -> Option<Span> {
    let is_held = |fault: &&Diagnostic| fault.kind.as_ref().is_some_and(|kind| kind.plural == HELD);
    let (span, _) = description.faults.iter().find(is_held)?.labels.first()?;
    Some(*span)
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
    /// Adds an equation, the other way round where its joint is tied already; of two that say the same the first is enough.
    pub(in crate::description::mjcf) fn add(&mut self, reader: &mut Reader, equation: &Equation) {
        let ways = [Some(equation.clone()), turned(equation)];
        let ways: Vec<Equation> = ways.into_iter().flatten().collect();
        let first_of = |way: &Equation| self.joints.get(&way.joint.value);
        let same = |way: &&Equation| first_of(way).is_some_and(|first| first.ties_as(way));
        if let Some(way) = ways.iter().find(same) {
            let first = &self.joints[&way.joint.value];
            if !first.is_as(way) {
                reader.faults.push(twice(first, equation));
            }
            return;
        }
        if let Some(way) = ways.iter().find(|way| first_of(way).is_none()) {
            self.joints.insert(way.joint.value.clone(), way.clone());
        } else {
            let first = &self.joints[&equation.joint.value];
            reader.faults.push(twice(first, equation));
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
        let named = places(bodies);
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
                reader.faults.push(note.one_of(HELD, &joint_name));
                continue;
            }
            let Some((name, Some(leader))) = leader else {
                continue;
            };
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

/// The first body of each joint's name.
fn places(bodies: &[WrittenBody]) -> BTreeMap<String, usize> {
    let mut places = BTreeMap::new();
    for (index, body) in bodies.iter().enumerate() {
        if let Some(name) = &body.joint.name {
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

impl Equation {
    /// True where the other one ties the same joint to the same.
    fn ties_as(&self, other: &Self) -> bool {
        let leader = |own: &Self| own.leader.as_ref().map(|leader| leader.value.clone());
        self.joint.value == other.joint.value && leader(self) == leader(other)
    }

    /// True where it has the same numbers too.
    fn is_as(&self, other: &Self) -> bool {
        self.ties_as(other) && (self.shift, self.factor) == (other.shift, other.factor)
    }
}

/// The fault of a second equation of a joint.
fn twice(first: &Equation, second: &Equation) -> Diagnostic {
    let name = shown(&second.joint.value);
    let message = format!(
        "{} ties joint `{name}`, which another one ties already",
        second.owner
    );
    let fault = Diagnostic::error(message).at(second.span, "the second one");
    let fault = fault.at(first.span, "the first one");
    fault.help("a joint can follow one other: delete one of the two, or give it a `name` and leave it out with `--leave-out NAME`")
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
