//! Joints that the user locks or removes.
//!
//! In: joints, and the names of what is to be changed. Out: the joints with these motions held. Does not: know of motions
//! that follow others; a locked one holds its followers later.

use crate::description::{Axis, Chart, Description, Speeds, WrittenBody};
use crate::diagnostic::{Diagnostic, nearest};
use crate::tree::changes::Changes;
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};
use crate::tree::names::{joint_name, shown};

/// Locks and removes what the user wants.
pub(crate) fn change(
    description: &Description,
    joints: &mut [ResolvedJoint],
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

/// A name under which a motion can be locked.
struct Lockable {
    name: String,
    body: usize,
    motion: usize,
}

/// Everything that can be locked: by the names of coordinates, and those of joints that have only one.
fn lockable(description: &Description, joints: &[ResolvedJoint]) -> Vec<Lockable> {
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
    joints: &mut [ResolvedJoint],
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
    joints: &mut [ResolvedJoint],
    name: &str,
    locked: &[usize],
    findings: &mut Vec<Diagnostic>,
) {
    let known: Vec<&str> = (0..joints.len())
        .filter_map(|body| joint_name(description, body))
        .collect();
    let of_body = |body: &WrittenBody| body.name.as_ref().is_some_and(|known| known.value == name);
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
