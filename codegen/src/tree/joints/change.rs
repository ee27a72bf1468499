//! Joints that the user locks or removes.
//!
//! In: joints, and the names of what is to be changed. Out: the joints with these motions held. Does not: know of motions
//! that follow others; a locked one holds its followers later.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::{Chart, CoordinateName, Description, Speeds};
use crate::diagnostic::{Diagnostic, Escaped, NearNames};
use crate::tree::changes::Changes;
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};
use crate::tree::names::{self, joint_name, joint_named, shown, shown_joint};
use crate::tree::units::is_large;

/// The joints with what the user locks and removes held.
pub(crate) fn change(
    description: &Description,
    joints: Vec<ResolvedJoint>,
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) -> Vec<ResolvedJoint> {
    let locked = locked(description, &joints, &changes.lock, findings);
    let removed = removed(description, &changes.remove, &locked, findings);
    let joints = joints.into_iter().enumerate();
    joints
        .map(|(body, joint)| {
            let joint = joint.with_motions(|motion, freedom| {
                locked
                    .get(&(body, motion))
                    .map_or(freedom, |value| Freedom::Locked(*value))
            });
            if removed.contains(&body) {
                fixed(joint)
            } else {
                joint
            }
        })
        .collect()
}

/// The joints with these motions, by their bodies and their places among the six, held at zero; what follows one of them is
/// held where that takes it.
pub(crate) fn hold(
    joints: Vec<ResolvedJoint>,
    held: &BTreeSet<(usize, usize)>,
) -> Vec<ResolvedJoint> {
    let joints = joints.into_iter().enumerate();
    joints
        .map(|(place, joint)| {
            let joint = joint.with_motions(|motion, freedom| match freedom {
                Freedom::Free(_) if held.contains(&(place, motion)) => Freedom::Locked(0.0),
                Freedom::Follows {
                    body,
                    motion,
                    offset,
                    ..
                } if held.contains(&(body, motion)) => Freedom::Locked(offset + 0.0),
                other => other,
            });
            let is_free = |angle: usize| matches!(joint.motions[angle], Freedom::Free(_));
            if (0..3).all(is_free) {
                joint
            } else {
                by_angles(joint)
            }
        })
        .collect()
}

/// A joint whose free motions are held at zero.
fn fixed(joint: ResolvedJoint) -> ResolvedJoint {
    let joint = joint.with_motions(|_, freedom| match freedom {
        Freedom::Free(_) => Freedom::Locked(0.0),
        held => held,
    });
    by_angles(joint)
}

/// A joint whose orientation, no longer free, is that of three angles.
fn by_angles(joint: ResolvedJoint) -> ResolvedJoint {
    ResolvedJoint {
        chart: Chart::Angles,
        speeds: Speeds::Rates,
        ..joint
    }
}

/// The values at which motions are locked, by their bodies and their places among the six.
type Locked = BTreeMap<(usize, usize), f64>;

/// A name under which a motion can be locked.
struct Lockable {
    name: String,
    /// Its body, and its place among the six.
    motion: (usize, usize),
}

/// Everything that can be locked: by the names of coordinates, and those of joints that have only one.
fn lockable(description: &Description, joints: &[ResolvedJoint]) -> Vec<Lockable> {
    let mut known = Vec::new();
    for (body, joint) in joints.iter().enumerate() {
        let are_coordinates = |motion: &usize| *motion > 2 || !joint.has_angular_velocity();
        for motion in joint.free().filter(are_coordinates) {
            let is_only = joint.leading == Some(motion);
            let names = names_of((description, joints), (body, motion), is_only);
            let motion = (body, motion);
            known.extend(names.map(|name| Lockable { name, motion }));
        }
    }
    known
}

/// The names of a motion: that of its coordinate, and that of its joint where it is the only one.
fn names_of(
    (description, joints): (&Description, &[ResolvedJoint]),
    (body, motion): (usize, usize),
    is_only: bool,
) -> impl Iterator<Item = String> {
    let identifier = &joints[body].identifier;
    let of_coordinate = if is_only && description.bodies[body].joint.name.is_some() {
        identifier.clone()
    } else {
        format!("{identifier}_{}", CoordinateName::NAMES[motion])
    };
    let of_joint = joint_name(description, body).map(str::to_owned);
    let of_joint = of_joint.filter(|name| is_only && *name != of_coordinate);
    std::iter::once(of_coordinate).chain(of_joint)
}

/// The names that a joint's last free motion has once the others are locked.
fn of_last(
    (description, joints): (&Description, &[ResolvedJoint]),
    free: &[Lockable],
    locked: &Locked,
    body: usize,
) -> Vec<Lockable> {
    let left = joints[body].free().map(|motion| (body, motion));
    let left: Vec<_> = left.filter(|motion| !locked.contains_key(motion)).collect();
    let [motion] = left[..] else {
        return Vec::new();
    };
    let names = names_of((description, joints), motion, true);
    let new = names.filter(|name| free.iter().all(|known| known.name != *name));
    new.map(|name| Lockable { name, motion }).collect()
}

/// True for the name of a coordinate of an orientation that has an angular velocity.
fn is_of_orientation(description: &Description, joints: &[ResolvedJoint], name: &str) -> bool {
    let Some((joint, coordinate)) = name.rsplit_once('_') else {
        return false;
    };
    let body = joint_named(description, joint);
    let turns = body.is_some_and(|body| joints[body].has_angular_velocity());
    turns && ["e0", "e1", "e2", "e3", "theta1", "theta2", "theta3"].contains(&coordinate)
}

/// What is locked by these names. What one of them locks is no longer free for those after it.
fn locked(
    description: &Description,
    joints: &[ResolvedJoint],
    names: &[(String, f64)],
    findings: &mut Vec<Diagnostic>,
) -> Locked {
    let mut free = lockable(description, joints);
    let mut locked = Locked::new();
    let mut near = NearNames::default();
    for (name, value) in names {
        match meant((description, joints), &free, name, &mut near) {
            Ok((body, motion)) => {
                free.retain(|known| known.motion != (body, motion));
                locked.insert((body, motion), value + 0.0);
                free.extend(of_last((description, joints), &free, &locked, body));
                let (kind, shown) = (CoordinateName::NAMES[motion], shown(description, body));
                let unit = if motion < 3 { "rad" } else { "m" };
                let joint = description.bodies[body].joint.name.as_ref();
                let who = match joint.filter(|joint| joint.value == *name) {
                    Some(joint) => format!("joint `{}`", joint.value.escaped()),
                    None => format!("`{kind}` of {shown}"),
                };
                let at = format!("{who} is locked at {value:?} {unit}");
                let subject = format!("{who} at {value:?} {unit}");
                let follows = description.bodies[body].joint.mimic.is_some();
                let cut = if follows {
                    ", and follows no other joint any more"
                } else {
                    ""
                };
                findings.push(match beyond(description, (body, motion), *value) {
                    None if motion < 3 && is_large(*value) => {
                        Diagnostic::warning(format!("{at}{cut}; is it in degrees?"))
                            .one_of("motions are locked at what looks like degrees", subject)
                    }
                    None if follows => Diagnostic::warning(format!("{at}{cut}"))
                        .one_of("motions that followed others are locked", subject),
                    None => Diagnostic::note(at).one_of("motions are locked", subject),
                    Some([lower, upper]) => Diagnostic::warning(format!(
                        "{at}, beyond its limits {lower:?} and {upper:?} {unit}{cut}"
                    ))
                    .one_of("motions are locked beyond their limits", subject),
                });
            }
            Err(fault) => findings.push(fault),
        }
    }
    locked
}

/// The limits of a motion, where a value is beyond them.
fn beyond(
    description: &Description,
    (body, motion): (usize, usize),
    value: f64,
) -> Option<[f64; 2]> {
    let limits = description.bodies[body].joint.limits.at(motion)?;
    let lower = limits.lower.map_or(f64::NEG_INFINITY, |limit| limit.value);
    let upper = limits.upper.map_or(f64::INFINITY, |limit| limit.value);
    (value < lower || value > upper).then_some([lower, upper])
}

/// The motion that has this name.
fn meant(
    (description, joints): (&Description, &[ResolvedJoint]),
    free: &[Lockable],
    name: &str,
    near: &mut NearNames,
) -> Result<(usize, usize), Diagnostic> {
    let mut meant = free.iter().filter(|known| known.name == name);
    let Some(&Lockable { motion, .. }) = meant.next() else {
        let known: Vec<&str> = free.iter().map(|known| known.name.as_str()).collect();
        let fault = format!(
            "`lock` names `{}`; no free coordinate is called so",
            name.escaped()
        );
        let fault = Diagnostic::error(fault).of_entry(Changes::LOCK, name);
        return Err(match joint_named(description, name) {
            None if is_of_orientation(description, joints, name) => fault.help(
                "it is part of an orientation, of which no coordinate can be held at a value; `remove` fixes the joint at zero",
            ),
            None => with_known(fault, name, (&known, near), "the free coordinates"),
            Some(body) => {
                let own = free.iter().filter(|known| known.motion.0 == body);
                let own: Vec<&str> = own.map(|known| known.name.as_str()).collect();
                let is_fixed = joints[body].free().next().is_none();
                let help = match &own[..] {
                    [] if is_fixed => "that joint is fixed".to_owned(),
                    [] => "no coordinate of that joint can be held at a value".to_owned(),
                    [one] => format!("the coordinate of that joint is {one}"),
                    several => format!("the coordinates of that joint are {}", several.join(", ")),
                };
                fault.help(help + &of_quaternion(&joints[body], name))
            }
        });
    };
    match meant.find(|other| other.motion != motion) {
        None => Ok(motion),
        Some(other) => {
            let fault = format!(
                "what `{}` locks is not clear: a coordinate of {}, or one of {}",
                name.escaped(),
                shown(description, motion.0),
                shown(description, other.motion.0)
            );
            Err(Diagnostic::error(fault).of_entry(Changes::LOCK, name))
        }
    }
}

/// What to do with an orientation, as it stands after other advice; nothing where there is none that turns freely.
fn of_quaternion(joint: &ResolvedJoint, name: &str) -> String {
    if !joint.has_angular_velocity() {
        return String::new();
    }
    let orientation = match joint.chart {
        Chart::Quaternion => "a quaternion",
        Chart::Angles => "an orientation with an angular velocity",
    };
    format!(
        "; {orientation} cannot be locked: `--remove {}`, or `{}` in `kane.toml`, fixes the joint at zero",
        name.escaped(),
        Changes::REMOVE
    )
}

/// The bodies whose joints are removed by these names.
fn removed(
    description: &Description,
    names: &[String],
    locked: &Locked,
    findings: &mut Vec<Diagnostic>,
) -> BTreeSet<usize> {
    let bodies = 0..description.bodies.len();
    let known = bodies.filter_map(|body| joint_name(description, body));
    let known: Vec<&str> = known.collect();
    let mut near = NearNames::default();
    let mut removed = BTreeSet::new();
    for name in names {
        if let Some(body) = joint_named(description, name) {
            findings.extend(of_removed(description, name, body, locked));
            removed.insert(body);
        } else {
            let fault = format!("`remove` names `{}`; no joint is called so", name.escaped());
            let fault = Diagnostic::error(fault).of_entry(Changes::REMOVE, name);
            findings.push(with_known(fault, name, (&known, &mut near), "the joints"));
        }
    }
    removed
}

/// What is said of a joint that is removed.
fn of_removed(
    description: &Description,
    name: &str,
    body: usize,
    locked: &Locked,
) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    let shown = shown_joint(description, body);
    if locked.keys().any(|(of, _)| *of == body) {
        let fault = format!("{shown} is both locked and removed");
        findings.push(Diagnostic::error(fault).of_entry(Changes::REMOVE, name));
    }
    let kind = description.bodies[body].joint.kind.as_ref();
    if kind.is_some_and(|kind| kind.value.is_fixed()) {
        let fault = format!("`remove` changes nothing: {shown} is fixed already");
        findings.push(Diagnostic::warning(fault).of_entry(Changes::REMOVE, name));
        return findings;
    }
    let note = format!("{shown} is removed: it is fixed");
    findings.push(Diagnostic::note(note).one_of("joints are removed: they are fixed", shown));
    findings
}

fn with_known(
    fault: Diagnostic,
    name: &str,
    (known, near): (&[&str], &mut NearNames),
    what: &str,
) -> Diagnostic {
    fault.help_if(names::meant(name, known, near, what))
}
