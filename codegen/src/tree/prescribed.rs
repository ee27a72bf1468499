//! Joints whose accelerations are prescribed: names become speeds of a tree.
//!
//! In: the tree of a description, and names of joints or of their bodies. Out: the tree with the speeds of these joints
//! [prescribed](Tree::prescribed). Does not: change anything else of it.

use std::collections::BTreeMap;

use crate::description::{Description, WrittenBody};
use crate::diagnostic::{Escaped, NearNames};
use crate::tree::names::{self, joint_named};
use crate::tree::system::Tree;

/// Why the accelerations of a joint cannot be prescribed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PrescribedFault {
    /// There is no such joint.
    #[error("`{}` is no joint of the model", name.escaped())]
    Unknown {
        /// The name.
        name: String,
        /// What was probably meant, or the joints that have speeds.
        help: String,
    },
    /// Two names mean one joint.
    #[error("{}", twice(first, name))]
    Twice {
        /// The second name.
        name: String,
        /// The first one.
        first: String,
    },
    /// No coordinate of the joint is free.
    #[error("the joint `{}` has no speed: {why}", name.escaped())]
    Held {
        /// The name.
        name: String,
        /// What holds it.
        why: &'static str,
    },
    /// The joint follows another one.
    #[error(
        "the joint `{}` has no speed of its own: it follows `{}`",
        name.escaped(),
        leader.escaped()
    )]
    Follows {
        /// The name.
        name: String,
        /// The joint whose speed moves it.
        leader: String,
    },
}

fn twice(first: &str, name: &str) -> String {
    let (shown, name_shown) = (first.escaped(), name.escaped());
    if first == name {
        format!("`{shown}` is named twice")
    } else {
        format!("`{shown}` and `{name_shown}` are one joint")
    }
}

impl PrescribedFault {
    /// The name that it is about.
    pub fn name(&self) -> &str {
        match self {
            Self::Unknown { name, .. }
            | Self::Twice { name, .. }
            | Self::Held { name, .. }
            | Self::Follows { name, .. } => name,
        }
    }

    /// What was expected in its place, in a few words.
    pub fn expected(&self) -> &'static str {
        match self {
            Self::Twice { .. } => "expected each joint once",
            Self::Unknown { .. } | Self::Held { .. } | Self::Follows { .. } => {
                "expected a joint with a speed of its own"
            }
        }
    }

    /// What to do about it.
    pub fn help(&self) -> String {
        match self {
            Self::Unknown { help, .. } => help.clone(),
            Self::Twice { .. } => "leave one of the two out".to_owned(),
            Self::Held { .. } => "leave it out: its acceleration is zero".to_owned(),
            Self::Follows { leader, .. } => {
                format!("prescribe `{}`, which moves both", leader.escaped())
            }
        }
    }
}

/// The tree with the speeds of these joints prescribed.
///
/// # Errors
/// Every name that is none of a joint with speeds of its own, and every second name of one joint.
pub fn prescribe(
    description: &Description,
    tree: Tree,
    names: &[String],
) -> Result<Tree, Vec<PrescribedFault>> {
    let mut tree = tree;
    let mut faults = Vec::new();
    let known = with_speeds(&tree);
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let mut near = NearNames::default();
    let mut first_names: BTreeMap<usize, &String> = BTreeMap::new();
    for name in names {
        let Some(place) = joint_named(description, name) else {
            faults.push(unknown(name, &known, &mut near));
            continue;
        };
        if let Some(first) = first_names.get(&place) {
            let (name, first) = (name.clone(), (*first).clone());
            faults.push(PrescribedFault::Twice { name, first });
            continue;
        }
        first_names.insert(place, name);
        let body = &description.bodies[place];
        match moving(&tree, body) {
            None => faults.push(held(body, name)),
            Some(moving) => match tree.bodies[moving].joint.speeds() {
                speeds if speeds.is_empty() => faults.push(follows(&tree, moving, name)),
                speeds => tree
                    .prescribed
                    .extend(speeds.into_iter().map(|(_, speed)| speed)),
            },
        }
    }
    if faults.is_empty() {
        Ok(tree)
    } else {
        Err(faults)
    }
}

/// The body of the tree that moves by the joint of this one; `None` where it is part of another.
fn moving(tree: &Tree, body: &WrittenBody) -> Option<usize> {
    let name = &body.name.as_ref()?.value;
    tree.bodies.iter().position(|own| own.name == *name)
}

/// The joints that have speeds.
fn with_speeds(tree: &Tree) -> Vec<String> {
    let bodies = tree.bodies.iter();
    let with_speeds = bodies.filter(|body| !body.joint.speeds().is_empty());
    with_speeds.map(|body| body.joint.name.clone()).collect()
}

fn unknown(name: &str, known: &[&str], near: &mut NearNames) -> PrescribedFault {
    let help = names::meant(name, known, near, "joints with speeds");
    PrescribedFault::Unknown {
        name: name.to_owned(),
        help: help.unwrap_or_else(|| {
            "no joint of the model has a speed: leave `prescribed` out".to_owned()
        }),
    }
}

fn held(body: &WrittenBody, name: &str) -> PrescribedFault {
    let kind = body.joint.kind.as_ref();
    let is_fixed = kind.is_some_and(|kind| kind.value.is_fixed());
    PrescribedFault::Held {
        name: name.to_owned(),
        why: match &body.joint.mimic {
            _ if is_fixed => "it is fixed in the model",
            Some(_) => "it is locked or removed, or follows a joint that is",
            None => "it is locked or removed",
        },
    }
}

fn follows(tree: &Tree, moving: usize, name: &str) -> PrescribedFault {
    let bodies = tree.speed_bodies();
    let mut motions = tree.bodies[moving].joint.motions().into_iter().flatten();
    let leader = motions.next().map(|motion| bodies[motion.speed.index()]);
    let leader = leader.map(|body| tree.body(body).joint.name.clone());
    PrescribedFault::Follows {
        name: name.to_owned(),
        leader: leader.unwrap_or_default(),
    }
}
