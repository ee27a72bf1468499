//! The motions that move no mass, in the words of the user.

use crate::description::{CoordinateName, Description, JointKind, WrittenBody};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::id::BodyId;
use crate::tree::Tree;
use crate::tree::mobility::idle::{Combination, idle_motions};
use crate::tree::names::shown;

/// The most motions that are reported: a tree without any mass has one for every coordinate.
const MOST_REPORTED: usize = 100;
/// The most coordinates of one motion that are named.
const MOST_NAMED: usize = 8;

/// Reports every free coordinate, or combination of free coordinates, that moves no mass.
pub(crate) fn check(tree: &Tree, description: &Description, findings: &mut Vec<Diagnostic>) {
    let mut alone: Vec<Combination> = Vec::new();
    for motion in idle_motions(tree, MOST_REPORTED) {
        match alone.last_mut() {
            // Coordinates of one body that are each idle are one finding.
            Some(last) if motion.len() == 1 && last[0].0 == motion[0].0 => last.extend(motion),
            _ if motion.len() == 1 => alone.push(motion),
            _ => findings.push(together(tree, description, &motion)),
        }
    }
    findings.extend(
        alone
            .iter()
            .map(|motion| separately(tree, description, motion)),
    );
}

/// Coordinates of one body, of which each by itself moves no mass.
fn separately(tree: &Tree, description: &Description, motion: &Combination) -> Diagnostic {
    let (verb, them) = if motion.len() == 1 {
        ("moves", "it")
    } else {
        ("move", "them")
    };
    let fault = Diagnostic::error(format!(
        "{} {verb} no mass",
        named(tree, description, motion)
    ));
    let chain = beyond(tree, description, motion[0].0);
    let help = format!(
        "leave {them} out of the joint, or give {chain} the mass or inertia that would move"
    );
    at_joints(tree, description, motion, fault, "moves no mass").help(help)
}

/// A body and those beyond it: "body `a`", or "one of body `a`, body `b` and body `c`".
fn beyond(tree: &Tree, description: &Description, first: BodyId) -> String {
    let mut carried = vec![false; tree.bodies.len()];
    carried[first.index()] = true;
    let mut chain = vec![first];
    for body in tree.body_ids().skip(first.index() + 1) {
        if tree.lower(body).is_some_and(|lower| carried[lower.index()]) {
            carried[body.index()] = true;
            chain.push(body);
        }
    }
    let mut names: Vec<String> = chain
        .iter()
        .take(MOST_NAMED)
        .map(|body| shown(description, user_place(tree, *body)))
        .collect();
    if chain.len() > MOST_NAMED {
        names.push(format!("{} more", chain.len() - MOST_NAMED));
    }
    match &names[..] {
        [only] => only.clone(),
        _ => format!("one of {}", and(&names)),
    }
}

/// Coordinates that move no mass if they move in a certain proportion.
fn together(tree: &Tree, description: &Description, motion: &Combination) -> Diagnostic {
    let fault = Diagnostic::error(format!(
        "a motion of {} moves no mass",
        named(tree, description, motion)
    ));
    let help =
        "leave one of them out of its joint, or give a body the mass or inertia that would move";
    at_joints(
        tree,
        description,
        motion,
        fault,
        "moves no mass with the others",
    )
    .help(help)
}

/// "`theta1` and `s2` of body `a` together with `s1` of body `b`".
fn named(tree: &Tree, description: &Description, motion: &Combination) -> String {
    let mut groups = Vec::new();
    for coordinates in
        motion[..motion.len().min(MOST_NAMED)].chunk_by(|one, other| one.0 == other.0)
    {
        let (body, _) = coordinates[0];
        let joint = &tree.body(body).joint;
        if joint.is_named && joint.coordinates().len() == 1 {
            groups.push(format!("joint `{}`", joint.name.escape_debug()));
            continue;
        }
        let named: Vec<String> = coordinates
            .iter()
            .map(|(body, coordinate)| {
                let names = tree.body(*body).joint.motion_names();
                format!("`{}`", names[coordinate.index()])
            })
            .collect();
        groups.push(format!(
            "{} of {}",
            and(&named),
            shown(description, user_place(tree, coordinates[0].0))
        ));
    }
    if motion.len() > MOST_NAMED {
        groups.push(format!("{} more", motion.len() - MOST_NAMED));
    }
    groups.join(" together with ")
}

fn at_joints(
    tree: &Tree,
    description: &Description,
    motion: &Combination,
    fault: Diagnostic,
    label: &str,
) -> Diagnostic {
    let mut places: Vec<Span> = Vec::new();
    for (body, coordinate) in motion.iter().take(MOST_NAMED) {
        let body = &description.bodies[user_place(tree, *body)];
        let place = free_coordinates(body)
            .into_iter()
            .find(|free| free.value == *coordinate)
            .map(|free| free.span);
        // All six coordinates of "free" stand in one place.
        places.extend(place.filter(|place| !places.contains(place)));
    }
    places
        .into_iter()
        .fold(fault, |fault, place| fault.at(place, label))
}

fn user_place(tree: &Tree, body: BodyId) -> usize {
    tree.body(body).user_number - 1
}

/// "a", "a and b", "a, b and c".
fn and(names: &[String]) -> String {
    match names {
        [names @ .., last] if !names.is_empty() => format!("{} and {last}", names.join(", ")),
        _ => names.concat(),
    }
}

/// The free coordinates as written.
fn free_coordinates(body: &WrittenBody) -> Vec<Spanned<CoordinateName>> {
    match &body.joint.kind {
        Some(kind) => match &kind.value {
            JointKind::List(coordinates) => coordinates.clone(),
            _ => CoordinateName::ALL
                .map(|coordinate| Spanned::new(coordinate, kind.span))
                .to_vec(),
        },
        None => Vec::new(),
    }
}
