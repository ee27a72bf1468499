//! Motions that move no mass, held at zero where the user asks for that.
//!
//! In: what is settled of a description. Out: its joints, with these motions held. Afterwards: no motion is left that moves no
//! mass whatever is set at run time, but for single angles of joints that have a quaternion. What was held is among the
//! findings.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::{CoordinateName, Description};
use crate::diagnostic::{Diagnostic, Escaped};
use crate::tree::assembly::{Settled, assemble};
use crate::tree::joints::{self, ResolvedJoint};
use crate::tree::mobility;
use crate::tree::names::{joint_name, shown};
use crate::tree::system::Tree;

/// How often is looked for more: where one motion is held, another may be left that moves nothing.
const ROUNDS: usize = 20;
/// The most motions that are held at once.
const MOST_HELD: usize = 1000;
/// The most motions that are named.
const MOST_NAMED: usize = 100;

/// Motions, by their bodies' places in the user's list, and their places among the six.
type Motions = BTreeSet<(usize, usize)>;

/// The joints with what moves no mass held.
pub(crate) fn hold(settled: Settled<'_>, findings: &mut Vec<Diagnostic>) -> Vec<ResolvedJoint> {
    let mut joints = settled.joints.to_vec();
    let mut held = Motions::new();
    for _ in 0..ROUNDS {
        // What is wrong with it is told where it is made for good.
        let tree = assemble(
            Settled {
                joints: &joints,
                ..settled
            },
            &mut Vec::new(),
        );
        let Some(tree) = tree.filter(|tree| !mobility::is_massless(tree)) else {
            break;
        };
        let more = holdable(&tree, &joints);
        if more.is_empty() {
            break;
        }
        joints = joints::hold(joints, &more);
        held.extend(more);
    }
    if !held.is_empty() {
        findings.push(told(settled, &held));
    }
    joints
}

/// What can be held of a tree with these joints.
fn holdable(tree: &Tree, joints: &[ResolvedJoint]) -> Motions {
    let holdable = mobility::holdable(tree, MOST_HELD).into_iter();
    let motions = holdable.map(|(body, coordinate): (_, CoordinateName)| {
        (tree.body(body).user_number - 1, coordinate.index())
    });
    let motions: Motions = motions.collect();
    // Of an orientation that is no three angles, all is held or nothing.
    let can_be = |&(body, motion): &(usize, usize)| {
        motion > 2
            || !joints[body].has_angular_velocity()
            || (0..3).all(|angle| motions.contains(&(body, angle)))
    };
    motions.iter().copied().filter(can_be).collect()
}

/// What is held, on one line.
fn told(settled: Settled<'_>, held: &Motions) -> Diagnostic {
    let Settled { description, .. } = settled;
    let mut of_body: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for &(body, motion) in held {
        of_body.entry(body).or_default().push(motion);
    }
    let named = of_body.iter().take(MOST_NAMED);
    let mut names: Vec<String> = named
        .map(|(&body, motions)| name(description, &settled.joints[body], body, motions))
        .collect();
    if of_body.len() > MOST_NAMED {
        names.push(format!("{} more", of_body.len() - MOST_NAMED));
    }
    Diagnostic::note(format!(
        "held at zero, for it moves no mass: {}",
        names.join(", ")
    ))
}

/// "`elbow`" for the only motion of a joint, else "`theta1` and `s1` of body `a`".
fn name(
    description: &Description,
    joint: &ResolvedJoint,
    body: usize,
    motions: &[usize],
) -> String {
    if let Some(name) = joint_name(description, body).filter(|_| joint.leading.is_some()) {
        return format!("`{}`", name.escaped());
    }
    let names = motions.iter();
    let names = names.map(|motion| format!("`{}`", CoordinateName::NAMES[*motion]));
    let names: Vec<String> = names.collect();
    format!("{} of {}", names.join(", "), shown(description, body))
}
