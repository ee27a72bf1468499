//! The motions that move no mass, in the words of the user.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::{CoordinateName, Description, JointKind, WrittenBody};
use crate::diagnostic::{Diagnostic, Escaped, Span, Spanned};
use crate::id::BodyId;
use crate::tree::Tree;
use crate::tree::body::Inertia;
use crate::tree::changes::Changes;
use crate::tree::joint::Orientation;
use crate::tree::mobility::definite::indefinite;
use crate::tree::mobility::idle::{Combination, holdable, idle_motions};
use crate::tree::mobility::oversized::oversized;
use crate::tree::names::shown;
use crate::tree::value::Value;

/// The most motions that are reported: a tree without any mass has one for every coordinate.
const MOST_REPORTED: usize = 100;
/// What takes such motions out.
const REMOVE: &str = "`--remove-massless`, or `remove_massless = true` in `kane.toml`, fixes at zero all that move none";
/// What moves none only because of what is set at run time.
const NOMINAL: &str = "other nominal values of what is set at run time would do too";
/// The most coordinates of one message that are named.
const MOST_NAMED: usize = 8;

/// Reports every free coordinate, or combination of free coordinates, that moves no mass: what moves none by itself in one
/// message, and what moves none with others in one for all that are bound up with one another.
pub(crate) fn check(
    tree: &Tree,
    description: &Description,
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) {
    if is_massless(tree) {
        findings.push(without_mass(description));
        return;
    }
    let motions = idle_motions(tree, MOST_REPORTED);
    let below = indefinite(tree);
    if !motions.is_empty() || below.is_some() {
        let faults = oversized(description);
        if !faults.is_empty() {
            findings.extend(faults);
            return;
        }
    }
    let is_all = motions.len() < MOST_REPORTED;
    let (alone, dependent): (Vec<Combination>, Vec<Combination>) =
        motions.into_iter().partition(|motion| motion.len() == 1);
    let whatever_is_set = holdable(tree, MOST_REPORTED);
    let told = |fault: Diagnostic, motion: &Combination| {
        let more = if !motion.iter().any(|one| whatever_is_set.contains(one)) {
            NOMINAL
        } else if changes.remove_massless || !can_be_held(tree, motion) {
            return fault;
        } else {
            REMOVE
        };
        let help = fault.help.clone().unwrap_or_default();
        fault.help(format!("{help}; {more}"))
    };
    for group in bound_up(dependent) {
        let fault = together(tree, description, &group);
        findings.push(told(fault, &group.coordinates));
    }
    let mut alone: Combination = alone.into_iter().flatten().collect();
    alone.sort_by_key(|(body, coordinate)| (*body, coordinate.index()));
    if !alone.is_empty() {
        let fault = separately(tree, description, &alone, is_all);
        findings.push(told(fault, &alone));
    }
    if let Some(motion) = below {
        findings.push(below_zero(tree, description, motion));
    }
}

/// True where some motion is more than a single angle of an orientation that is described otherwise.
fn can_be_held(tree: &Tree, motion: &Combination) -> bool {
    motion.iter().any(|(body, coordinate)| {
        let angles = motion
            .iter()
            .filter(|(other, other_coordinate)| other == body && other_coordinate.is_angle());
        let orientation = &tree.body(*body).joint.orientation;
        let has_rates = matches!(orientation, Orientation::Rates(_));
        has_rates || !coordinate.is_angle() || angles.count() == 3
    })
}

/// True where nothing that moves has a mass, an inertia or a rotor.
pub(crate) fn is_massless(tree: &Tree) -> bool {
    let is_zero = |value: Value| tree.nominal(value) == 0.0;
    tree.bodies.iter().all(|body| {
        let mut mechanics = body.joint.mechanics.iter();
        mechanics.all(|own| is_zero(own.armature))
            && body.parts.iter().all(|part| {
                let Inertia {
                    xx,
                    yy,
                    zz,
                    xy,
                    xz,
                    yz,
                } = part.inertia;
                [part.mass, xx, yy, zz, xy, xz, yz].into_iter().all(is_zero)
            })
    })
}

fn without_mass(description: &Description) -> Diagnostic {
    let fault = Diagnostic::error(
        "nothing that moves has a mass or an inertia, so forces would move nothing",
    );
    let name = description.name.as_ref().map(|name| name.span);
    let fault = fault.at_if(name, "no mass moves in this system");
    fault.help(
        "give its bodies masses and inertias: a model that is only to be looked at often has none",
    )
}

/// Motions that have coordinates in common, each coordinate once, and how many motions they are.
struct Group {
    coordinates: Combination,
    n_motions: usize,
}

fn bound_up(motions: Vec<Combination>) -> Vec<Group> {
    // By the place of each group's first motion; and of each coordinate the group in which it was last seen.
    let mut groups: BTreeMap<usize, Group> = BTreeMap::new();
    let mut group_of: BTreeMap<(BodyId, usize), usize> = BTreeMap::new();
    for (place, motion) in motions.into_iter().enumerate() {
        let key = |(body, coordinate): &(BodyId, CoordinateName)| (*body, coordinate.index());
        let bound: BTreeSet<usize> = motion
            .iter()
            .filter_map(|one| group_of.get(&key(one)).copied())
            .collect();
        let mut group = Group {
            coordinates: motion,
            n_motions: 1,
        };
        for other in bound.iter().filter_map(|other| groups.remove(other)) {
            group.coordinates.extend(other.coordinates);
            group.n_motions += other.n_motions;
        }
        group.coordinates.sort_by_key(key);
        group.coordinates.dedup();
        group_of.extend(group.coordinates.iter().map(|one| (key(one), place)));
        groups.insert(place, group);
    }
    groups.into_values().collect()
}

/// Coordinates of which each by itself moves no mass; whether these are all.
fn separately(
    tree: &Tree,
    description: &Description,
    motion: &Combination,
    is_all: bool,
) -> Diagnostic {
    let is_one_joint = motion.iter().all(|(body, _)| *body == motion[0].0);
    let (verb, them) = if motion.len() == 1 {
        ("moves", "it")
    } else {
        ("move", "them")
    };
    let join = if is_one_joint { Join::With } else { Join::And };
    let fault = Diagnostic::error(format!(
        "{} {verb} no mass",
        named(tree, description, motion, join, is_all)
    ));
    let help = if is_one_joint {
        let chain = beyond(tree, description, motion[0].0);
        let n_free = tree.body(motion[0].0).joint.speeds().len();
        let hold = if motion.len() == n_free {
            "fix the joint".to_owned()
        } else {
            format!("leave {them} out of the joint")
        };
        format!("{hold}, or give {chain} the mass or inertia that would move")
    } else {
        format!("give the bodies beyond {them} mass or inertia")
    };
    at_joints(tree, description, motion, fault, "moves no mass").help(help)
}

/// A motion that would have energy below zero.
fn below_zero(
    tree: &Tree,
    description: &Description,
    motion: (BodyId, CoordinateName),
) -> Diagnostic {
    let motion = vec![motion];
    let fault = Diagnostic::error(format!(
        "the mass matrix is positive definite in no state that was tried: {} moves less than no mass",
        named(tree, description, &motion, Join::With, true)
    ));
    let chain = beyond(tree, description, motion[0].0);
    let help = format!("correct the inertias below zero that it moves, of {chain}");
    at_joints(tree, description, &motion, fault, "moves less than no mass").help(help)
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

/// Coordinates that move no mass if they move in certain proportions.
fn together(tree: &Tree, description: &Description, group: &Group) -> Diagnostic {
    let Group {
        coordinates,
        n_motions,
    } = group;
    let (motions, move_, of_them) = match n_motions {
        1 => ("a motion".to_owned(), "moves", "one"),
        _ => (format!("{n_motions} motions"), "move", "as many"),
    };
    let fault = Diagnostic::error(format!(
        "{motions} of {} {move_} no mass",
        named(tree, description, coordinates, Join::With, true)
    ));
    let help = format!(
        "leave {of_them} of them out of {} joint{}, or give a body the mass or inertia that would move",
        if *n_motions == 1 { "its" } else { "their" },
        if *n_motions == 1 { "" } else { "s" },
    );
    let help = if has_own_base(tree, description, coordinates) {
        format!("the model has a base of its own: read it with `--base fixed`; or {help}")
    } else {
        help
    };
    let label = "moves no mass with the others";
    at_joints(tree, description, coordinates, fault, label).help(help)
}

/// How groups of coordinates are joined in a sentence.
#[derive(Clone, Copy, PartialEq)]
enum Join {
    /// They move together.
    With,
    /// Each of them moves.
    And,
}

/// "`theta1` and `s2` of body `a` together with `s1` of body `b`"; whether these are all that there are.
fn named(
    tree: &Tree,
    description: &Description,
    motion: &Combination,
    join: Join,
    is_all: bool,
) -> String {
    let mut groups = Vec::new();
    for coordinates in
        motion[..motion.len().min(MOST_NAMED)].chunk_by(|one, other| one.0 == other.0)
    {
        let (body, _) = coordinates[0];
        let joint = &tree.body(body).joint;
        if joint.is_named && joint.coordinates().len() == 1 {
            groups.push(format!("joint `{}`", joint.name.escaped()));
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
        let at_least = if is_all { "" } else { "at least " };
        groups.push(format!("{at_least}{} more", motion.len() - MOST_NAMED));
    }
    match join {
        Join::With => together_in_words(&groups),
        Join::And => and(&groups),
    }
}

/// "a", "a together with b", "a, b and c together"; of joints alone "joints `a` and `b` together".
fn together_in_words(groups: &[String]) -> String {
    let joints: Option<Vec<String>> = groups
        .iter()
        .map(|group| group.strip_prefix("joint ").map(str::to_owned))
        .collect();
    match (joints, groups) {
        (_, [] | [_]) => groups.concat(),
        (Some(joints), _) => format!("joints {} together", and(&joints)),
        (None, [first, second]) => format!("{first} together with {second}"),
        (None, _) => format!("{} together", and(groups)),
    }
}

/// True where the model has its own base, and the user gave it another: what moves in vain is the joint that no file has, and
/// a joint such as bases have.
fn has_own_base(tree: &Tree, description: &Description, motion: &Combination) -> bool {
    let bodies = motion.iter().map(|(body, _)| user_place(tree, *body));
    let bodies = bodies.map(|place| &description.bodies[place]);
    let joints = bodies.filter_map(|body| Some((&body.name, body.joint.kind.as_ref()?)));
    // A joint that no file has stands at the name of its link.
    let (given, others): (Vec<_>, Vec<_>) = joints.partition(|(name, kind)| {
        let name = name.as_ref().map(|name| name.span);
        kind.value == JointKind::Free && name == Some(kind.span)
    });
    let is_of_base = |kind: &JointKind| {
        matches!(
            kind,
            JointKind::Free | JointKind::Planar | JointKind::Prismatic
        )
    };
    !given.is_empty() && others.iter().any(|(_, kind)| is_of_base(&kind.value))
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
