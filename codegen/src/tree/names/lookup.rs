//! Names that a user gives: the joint that has one, and what to say of one that is none.

use crate::description::{Description, WrittenBody};
use crate::diagnostic::{Escaped, NearNames, shown_name};
use crate::tree::names::shown::{by_joints, joint_name};

/// The place in the user's list of the body whose joint has this name, or which has it itself.
pub(crate) fn joint_named(description: &Description, name: &str) -> Option<usize> {
    let mut bodies = by_joints(description);
    let of_joint = bodies.find(|body| joint_name(description, *body) == Some(name));
    let is_named = |body: &WrittenBody| body.name.as_ref().is_some_and(|known| known.value == name);
    of_joint.or_else(|| description.bodies.iter().position(is_named))
}

/// Which of the known names was probably meant, or which there are: `what` says of what. `None` where there are none.
pub(crate) fn meant(
    name: &str,
    known: &[&str],
    near: &mut NearNames,
    what: &str,
) -> Option<String> {
    let mut several = name.split([',', '=']).map(str::trim);
    if name.contains(',') && several.any(|one| known.contains(&one)) {
        return Some("these are several names: give each by itself".to_owned());
    }
    match near.nearest(name, known.iter().copied()) {
        Some(near) => Some(format!("did you mean `{}`?", near.escaped())),
        None if known.is_empty() => None,
        None => Some(format!("{what} are {}", listed(known))),
    }
}

/// The most names that are listed.
const MOST_LISTED: usize = 40;

/// Names for people to read, and how many more there are.
pub(crate) fn listed(names: &[&str]) -> String {
    let first = names.iter().take(MOST_LISTED);
    let first: Vec<String> = first.map(|name| shown_name(name)).collect();
    let first = first.join(", ");
    match names.len().saturating_sub(MOST_LISTED) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}
