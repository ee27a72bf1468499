//! Which written bodies move, and which are part of others.
//!
//! In: the bodies outward, and their joints. Out: the bodies of the tree, each with the written ones of which it is made.

use crate::id::BodyId;
use crate::tree::joints::ResolvedJoint;
use crate::tree::numbering::Outward;

/// The bodies of the tree; written bodies are meant by their places in the outward order.
pub(super) struct Merged {
    /// Of each written body the body of the tree in which it is; `None` is the inertial frame.
    pub(super) hosts: Vec<Option<BodyId>>,
    /// The bodies of the tree.
    pub(super) bodies: Vec<MovingBody>,
    /// The written bodies that are part of others.
    pub(super) fixed: Vec<usize>,
}

/// A body of the tree.
pub(super) struct MovingBody {
    /// The written body whose joint moves it.
    pub(super) written: usize,
    /// Its lower body; `None` is the inertial frame.
    pub(super) lower: Option<BodyId>,
    /// The bodies whose lower body it is.
    pub(super) uppers: Vec<BodyId>,
    /// The written bodies that are fixed to it.
    pub(super) fixed: Vec<usize>,
}

/// Merges every body that is fixed into what it is fixed to.
pub(super) fn merge(outward: &Outward, joints: &[ResolvedJoint]) -> Merged {
    let mut hosts: Vec<Option<BodyId>> = Vec::with_capacity(outward.places.len());
    let mut moving = Vec::new();
    let mut fixed = Vec::new();
    for (written, (place, lower)) in outward.places.iter().zip(&outward.lowers).enumerate() {
        let below = lower.and_then(|lower| hosts[lower]);
        hosts.push(if joints[*place].is_fixed() {
            fixed.push(written);
            below
        } else {
            moving.push((written, below));
            Some(BodyId::new(moving.len() - 1))
        });
    }
    let mut uppers = vec![Vec::new(); moving.len()];
    for (body, (_, lower)) in moving.iter().enumerate() {
        if let Some(lower) = lower {
            uppers[lower.index()].push(BodyId::new(body));
        }
    }
    let mut fixed_to = vec![Vec::new(); moving.len()];
    for &written in &fixed {
        if let Some(host) = hosts[written] {
            fixed_to[host.index()].push(written);
        }
    }
    let bodies = moving.into_iter().zip(uppers).zip(fixed_to);
    let bodies = bodies.map(|(((written, lower), uppers), fixed)| MovingBody {
        written,
        lower,
        uppers,
        fixed,
    });
    Merged {
        hosts,
        bodies: bodies.collect(),
        fixed,
    }
}
