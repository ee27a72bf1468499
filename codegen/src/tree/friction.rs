//! Friction of a tree, which is data.

use crate::diagnostic::{Diagnostic, Escaped};
use crate::tree::joint::Joint;
use crate::tree::system::Tree;

/// Tells that friction is in no equation, though models give it: a user of another tool may expect it there.
pub(crate) fn note(tree: &Tree, findings: &mut Vec<Diagnostic>) {
    let joints = tree.bodies.iter().map(|body| &body.joint);
    let rubbing: Vec<String> = joints
        .filter(|joint| has_friction(joint))
        .map(|joint| joint.name.clone())
        .collect();
    if rubbing.is_empty() {
        return;
    }
    let quoted: Vec<String> = rubbing
        .iter()
        .map(|name| format!("`{}`", name.escaped()))
        .collect();
    let note = format!(
        "the friction of {} is in no equation of motion; the constant `FRICTION` holds it, for your program to add",
        quoted.join(", ")
    );
    findings.push(Diagnostic::note(note).all_of(
        "joints have friction, which is in no equation of motion; the constant `FRICTION` holds it",
        rubbing,
    ));
}

/// True where a motion that is not held has friction.
fn has_friction(joint: &Joint) -> bool {
    let mut motions = joint.motions().into_iter().zip(&joint.mechanics);
    motions.any(|(motion, mechanics)| motion.is_some() && mechanics.friction != 0.0)
}
