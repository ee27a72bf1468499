//! Joints as written become six motions, each free or held, between two constant frames.
//!
//! In: kinds, axes, lists of coordinates, and the user's changes. Out: a [`Resolved`] joint for every body.
//! Afterwards: every free motion is about or along a coordinate axis of the joint's aligned frame.
//! Does not: judge what is free; that is `joint_check`.

use crate::description::{Axis, Chart, Description, JointKind, Rotation, Speeds, WrittenJoint};
use crate::diagnostic::{Diagnostic, Span, nearest};
use crate::geometry;
use crate::tree::Changes;
use crate::tree::names::{self, shown};
use crate::tree::rotations::snap as rotation;

/// A joint whose motions are about and along coordinate axes.
#[derive(Clone, Debug)]
pub(crate) struct Resolved {
    /// From the joint's axes, as written, to those of its coordinates.
    pub(crate) align: Rotation,
    /// By how much snapping changed an entry of the axis.
    pub(crate) axis_change: f64,
    /// The six motions: about, then along the three axes.
    pub(crate) motions: [Freedom; 6],
    /// How the orientation is described.
    pub(crate) chart: Chart,
    /// What its speeds are.
    pub(crate) speeds: Speeds,
    /// What stands before the names of its coordinates.
    pub(crate) identifier: String,
    /// The place of its only free motion, as it is written: what others can follow, also where it is then held.
    pub(crate) leading: Option<usize>,
}

/// Whether a motion is free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Freedom {
    /// It is, as is written here.
    Free(Span),
    /// It is `multiplier` times that motion of that body (a place in the user's list), plus `offset`.
    Follows {
        /// The other body's place in the user's list.
        body: usize,
        /// The place among its six motions.
        motion: usize,
        /// Times the other.
        multiplier: f64,
        /// Plus, rad or m.
        offset: f64,
        /// Where its joint is written.
        span: Span,
    },
    /// It is held at this value, rad or m.
    Locked(f64),
}

impl Resolved {
    /// The places of the free motions.
    pub(crate) fn free(&self) -> impl Iterator<Item = usize> + '_ {
        (0..6).filter(|motion| matches!(self.motions[*motion], Freedom::Free(_)))
    }

    /// The place of the only free motion.
    pub(crate) fn only(&self) -> Option<usize> {
        let mut free = self.free();
        free.next().filter(|_| free.next().is_none())
    }

    /// True where nothing moves: the body is part of its lower body.
    pub(crate) fn is_fixed(&self) -> bool {
        self.motions
            .iter()
            .all(|motion| matches!(motion, Freedom::Locked(_)))
    }

    /// The values of the three angles, or of the three translations; zero where they are free.
    pub(crate) fn locked(&self, first: usize) -> [f64; 3] {
        std::array::from_fn(|i| match self.motions[first + i] {
            Freedom::Locked(value) => value,
            Freedom::Free(_) | Freedom::Follows { .. } => 0.0,
        })
    }

    /// True for a joint that turns in every direction and whose speeds are no rates.
    pub(crate) fn has_angular_velocity(&self) -> bool {
        self.speeds == Speeds::AngularVelocity
    }
}

/// The joint of every body; `None` for one that is not known, which is then a fault.
pub(crate) fn joints(description: &Description, snap: f64) -> Vec<Option<Resolved>> {
    let identifiers = names::joint_identifiers(description);
    let joints = description.bodies.iter().zip(identifiers);
    joints
        .map(|(body, identifier)| resolved(&body.joint, identifier, snap))
        .collect()
}

/// Locks and removes what the user wants.
pub(crate) fn change(
    description: &Description,
    joints: &mut [Resolved],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) {
    let mut locked = Vec::new();
    for (name, value) in &changes.lock {
        locked.extend(lock(description, joints, name, *value, findings));
    }
    for name in &changes.remove {
        remove(description, joints, name, &locked, findings);
    }
}

fn resolved(joint: &WrittenJoint, identifier: String, snap: f64) -> Option<Resolved> {
    let kind = joint.kind.as_ref()?;
    let (align, place, axis_change) = match (&joint.axis, kind.value.has_axis()) {
        (Some(axis), true) => rotation::toward(axis.value, snap),
        (None, true) => return None,
        (_, false) => (geometry::IDENTITY, 0, 0.0),
    };
    let mut motions = [Freedom::Locked(0.0); 6];
    for (axis, value) in &joint.locked {
        motions[axis.value.index()] = Freedom::Locked(value.as_ref()?.value);
    }
    for (motion, span) in free(&kind.value, place, kind.span) {
        motions[motion] = Freedom::Free(span);
    }
    let chart = joint.chart.map_or(Chart::Angles, |chart| chart.value);
    let natural = match chart {
        Chart::Angles => Speeds::Rates,
        Chart::Quaternion => Speeds::AngularVelocity,
    };
    let mut resolved = Resolved {
        align,
        axis_change,
        motions,
        chart,
        speeds: joint.speeds.map_or(natural, |speeds| speeds.value),
        identifier,
        leading: None,
    };
    resolved.leading = resolved.only();
    Some(resolved)
}

/// The free motions of a kind of joint, given the place of its axis, and where they are written.
fn free(kind: &JointKind, place: usize, span: Span) -> Vec<(usize, Span)> {
    let others = ((place + 1) % 3, (place + 2) % 3);
    let motions = match kind {
        JointKind::Fixed => vec![],
        JointKind::Revolute | JointKind::Continuous => vec![place],
        JointKind::Prismatic => vec![3 + place],
        JointKind::Cylindrical => vec![place, 3 + place],
        JointKind::Planar => vec![place, 3 + others.0, 3 + others.1],
        JointKind::Universal => vec![0, 1],
        JointKind::Spherical => vec![0, 1, 2],
        JointKind::Free => vec![0, 1, 2, 3, 4, 5],
        JointKind::List(axes) => {
            let places = axes.iter().map(|axis| (axis.value.index(), axis.span));
            return places.collect();
        }
    };
    motions.into_iter().map(|motion| (motion, span)).collect()
}

/// The name of a joint as written: its own, or its body's.
pub(crate) fn joint_name(description: &Description, body: usize) -> Option<&str> {
    let body = description.bodies.get(body)?;
    let name = body.joint.name.as_ref().or(body.name.as_ref())?;
    Some(&name.value)
}

/// A name under which a motion can be locked.
struct Lockable {
    name: String,
    body: usize,
    motion: usize,
}

/// Everything that can be locked: by the names of coordinates, and those of joints that have only one.
fn lockable(description: &Description, joints: &[Resolved]) -> Vec<Lockable> {
    let mut known = Vec::new();
    for (body, joint) in joints.iter().enumerate() {
        let is_named = description.bodies[body].joint.name.is_some();
        let are_coordinates = |motion: &usize| *motion > 2 || !joint.has_angular_velocity();
        for motion in joint.free().filter(are_coordinates) {
            let is_only = joint.leading == Some(motion);
            let kind = Axis::NAMES[motion];
            let of_coordinate = if is_named && is_only {
                joint.identifier.clone()
            } else {
                format!("{}_{kind}", joint.identifier)
            };
            let of_joint = joint_name(description, body).map(str::to_owned);
            let of_joint = of_joint.filter(|name| is_only && *name != of_coordinate);
            let names = [Some(of_coordinate), of_joint];
            known.extend(
                names
                    .into_iter()
                    .flatten()
                    .map(|name| Lockable { name, body, motion }),
            );
        }
    }
    known
}

/// Holds a coordinate at a value; the result is its body.
fn lock(
    description: &Description,
    joints: &mut [Resolved],
    name: &str,
    value: f64,
    findings: &mut Vec<Diagnostic>,
) -> Option<usize> {
    let known = lockable(description, joints);
    let mut meant = known.iter().filter(|known| known.name == name);
    let Some(&Lockable { body, motion, .. }) = meant.next() else {
        let known: Vec<&str> = known.iter().map(|known| known.name.as_str()).collect();
        let fault = format!("nothing free to lock is called `{}`", name.escape_debug());
        let fault = Diagnostic::error(fault);
        findings.push(with_known(fault, name, &known, "the free coordinates"));
        return None;
    };
    let first = shown(description, body);
    if let Some(other) = meant.find(|other| (other.body, other.motion) != (body, motion)) {
        let fault = format!(
            "what `{}` locks is not clear: a coordinate of {first}, or one of {}",
            name.escape_debug(),
            shown(description, other.body)
        );
        findings.push(Diagnostic::error(fault));
        return None;
    }
    joints[body].motions[motion] = Freedom::Locked(value + 0.0);
    let kind = Axis::NAMES[motion];
    findings.push(Diagnostic::note(format!(
        "`{kind}` of {first} is locked at {value:?}"
    )));
    Some(body)
}

/// Fixes a joint where its coordinates are zero.
fn remove(
    description: &Description,
    joints: &mut [Resolved],
    name: &str,
    locked: &[usize],
    findings: &mut Vec<Diagnostic>,
) {
    let known: Vec<&str> = (0..joints.len())
        .filter_map(|body| joint_name(description, body))
        .collect();
    let of_body = |body: &crate::description::WrittenBody| {
        body.name.as_ref().is_some_and(|known| known.value == name)
    };
    let place = (0..joints.len())
        .find(|body| joint_name(description, *body) == Some(name))
        .or_else(|| description.bodies.iter().position(of_body));
    let Some(body) = place else {
        let fault = format!("no joint to remove is called `{}`", name.escape_debug());
        findings.push(with_known(
            Diagnostic::error(fault),
            name,
            &known,
            "the joints",
        ));
        return;
    };
    if locked.contains(&body) {
        let shown = shown(description, body);
        findings.push(Diagnostic::error(format!(
            "the joint of {shown} is both locked and removed"
        )));
    }
    for motion in &mut joints[body].motions {
        if let Freedom::Free(_) = motion {
            *motion = Freedom::Locked(0.0);
        }
    }
    (joints[body].chart, joints[body].speeds) = (Chart::Angles, Speeds::Rates);
    let shown = shown(description, body);
    findings.push(Diagnostic::note(format!(
        "the joint of {shown} is removed: it is fixed"
    )));
}

/// The most names that a help lists.
const MOST_NAMED: usize = 40;

fn with_known(fault: Diagnostic, name: &str, known: &[&str], what: &str) -> Diagnostic {
    match nearest(name, known) {
        Some(near) => fault.help(format!("did you mean `{near}`?")),
        None if known.is_empty() => fault,
        None => {
            let listed = known[..known.len().min(MOST_NAMED)].join(", ");
            let more = if known.len() > MOST_NAMED {
                ", ..."
            } else {
                ""
            };
            fault.help(format!("{what} are {listed}{more}"))
        }
    }
}
