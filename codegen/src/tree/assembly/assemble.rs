//! The stages from joints that stand to a whole tree.

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Spanned};
use crate::limits::FOLLOWING;
use crate::tree::assembly::markers::markers;
use crate::tree::assembly::merging::{Moving, merge};
use crate::tree::assembly::placing::{Placed, Placing};
use crate::tree::body::{Body, Pose};
use crate::tree::frames::{Frame, FrameName, note_merged};
use crate::tree::joint::Joint;
use crate::tree::joints::ResolvedJoint;
use crate::tree::names;
use crate::tree::numbering::{JointCoordinates, Outward, note_moved, number};
use crate::tree::rotations::ConstantRotations;
use crate::tree::system::Tree;
use crate::tree::values::{BodyValues, Known, KnownFrame, values};

/// A description whose bodies form a tree and whose joints stand.
#[derive(Clone, Copy)]
pub(crate) struct Settled<'a> {
    pub(crate) description: &'a Description,
    pub(crate) outward: &'a Outward,
    /// Of each body, by its place in the user's list.
    pub(crate) joints: &'a [ResolvedJoint],
    /// Of each body, by its place in the user's list.
    pub(crate) rotations: &'a [ConstantRotations],
    /// How near to 0, 1 or -1 entries of constant rotations are made exact.
    pub(crate) snap: f64,
}

/// The tree; `None` where a value is missing, or where it would be too large.
pub(crate) fn assemble(settled: Settled<'_>, findings: &mut Vec<Diagnostic>) -> Option<Tree> {
    let Settled {
        description,
        outward,
        joints,
        snap,
        ..
    } = settled;
    let order = description.order?.value;
    let names = names(description, &outward.places)?;
    let identifiers = names::identifiers(&names, findings);
    let merged = merge(outward, joints);
    let moving: Vec<usize> = merged
        .bodies
        .iter()
        .map(|body| outward.places[body.written])
        .collect();
    let known = outward.places.iter().zip(&identifiers).zip(&merged.hosts);
    let known = known.map(|((&place, identifier), &host)| Known {
        written: &description.bodies[place],
        joint: &joints[place],
        identifier,
        host,
    });
    let marked = markers(description, outward, &merged.hosts)?;
    let marker_names = marked.iter().map(|marker| marker.name.as_str());
    let marker_identifiers = names::frame_identifiers(marker_names, &identifiers);
    let frames = description.frames.iter().zip(&marked);
    let frames = frames.zip(&marker_identifiers);
    let frames = frames.map(|((written, marker), identifier)| KnownFrame {
        written,
        identifier,
        host: marker.host,
    });
    let values = values(description, known, frames, findings)?;
    let numbered = number(joints, &moving, order);
    if joints.iter().any(ResolvedJoint::follows) {
        check_size(moving.len(), numbered.n_speeds, findings)?;
    }
    let placed = place(settled, &values.bodies);
    let parts = Parts {
        settled,
        names: &names,
        identifiers: &identifiers,
        values: &values.bodies,
        placed: &placed,
    };
    let numbered_bodies = merged.bodies.iter().zip(numbered.joints);
    let bodies: Vec<Body> = numbered_bodies
        .map(|(moving, coordinates)| parts.body(moving, coordinates))
        .collect();
    let frames: Vec<Frame> = merged
        .fixed
        .iter()
        .map(|&written| {
            let host = merged.hosts[written];
            let name = FrameName {
                name: names[written].value.clone(),
                identifier: identifiers[written].clone(),
            };
            let base = host.map_or_else(Pose::internal, |host| bodies[host.index()].pose.clone());
            let poses = [&base, &placed[written].pose];
            Frame::new(name, host, poses, &values.parameters, snap)
        })
        .collect();
    let markers = marked.iter().zip(marker_identifiers).zip(&values.frames);
    let markers: Vec<Frame> = markers
        .map(|((marker, identifier), own)| {
            let bodies = (&placed[..], &bodies[..]);
            marker.frame(identifier, own, bodies, &values.parameters, snap)
        })
        .collect();
    note_moved(description, &moving, findings);
    note_merged(&frames, &bodies, findings);
    let tree = Tree {
        name: description.name.as_ref()?.value.clone(),
        gravity: values.gravity,
        order,
        bodies,
        frames,
        markers,
        snap,
        parameters: values.parameters,
        n_coordinates: numbered.n_coordinates,
        n_speeds: numbered.n_speeds,
    };
    names::check_coordinates(&tree, findings);
    names::note_order(&tree, findings);
    Some(tree)
}

/// The names of the bodies, outward.
fn names(description: &Description, places: &[usize]) -> Option<Vec<Spanned<String>>> {
    let names = places
        .iter()
        .map(|&place| description.bodies[place].name.clone());
    names.collect()
}

/// Whether coordinates of bodies that follow others are few enough to judge.
fn check_size(n_bodies: usize, n_speeds: usize, findings: &mut Vec<Diagnostic>) -> Option<()> {
    if n_bodies.max(n_speeds) <= FOLLOWING {
        return Some(());
    }
    findings.push(Diagnostic::error(format!(
        "the system, in which joints follow others, has {n_bodies} bodies that move and {n_speeds} speeds; \
        expected at most {FOLLOWING} of each"
    )));
    None
}

/// The written bodies where they stand, outward.
fn place(settled: Settled<'_>, values: &[BodyValues]) -> Vec<Placed> {
    let Settled {
        outward,
        joints,
        rotations,
        snap,
        ..
    } = settled;
    let mut placed: Vec<Placed> = Vec::with_capacity(values.len());
    for ((&place, lower), values) in outward.places.iter().zip(&outward.lowers).zip(values) {
        let placing = Placing {
            values,
            rotations: &rotations[place],
            joint: &joints[place],
            snap,
        };
        let below = lower.map_or_else(Pose::internal, |lower| placed[lower].pose.clone());
        placed.push(placing.on(&below));
    }
    placed
}

/// What bodies are made from; each list is outward.
struct Parts<'a> {
    settled: Settled<'a>,
    names: &'a [Spanned<String>],
    identifiers: &'a [String],
    values: &'a [BodyValues],
    placed: &'a [Placed],
}

impl Parts<'_> {
    fn body(&self, moving: &Moving, coordinates: JointCoordinates) -> Body {
        let written = moving.written;
        let parts = std::iter::once(written).chain(moving.fixed.iter().copied());
        Body {
            name: self.names[written].value.clone(),
            identifier: self.identifiers[written].clone(),
            user_number: self.settled.outward.places[written] + 1,
            lower: moving.lower,
            uppers: moving.uppers.clone(),
            parts: parts.map(|part| self.placed[part].part.clone()).collect(),
            joint: self.joint(written, coordinates),
            pose: self.placed[written].pose.clone(),
        }
    }

    fn joint(&self, written: usize, coordinates: JointCoordinates) -> Joint {
        let place = self.settled.outward.places[written];
        let own_name = self.settled.description.bodies[place].joint.name.as_ref();
        let seat = &self.placed[written].seat;
        Joint {
            name: own_name.unwrap_or(&self.names[written]).value.clone(),
            identifier: self.settled.joints[place].identifier.clone(),
            is_named: own_name.is_some(),
            rotation: seat.rotation,
            attachment: seat.attachment.clone(),
            orientation: coordinates.orientation,
            translations: coordinates.translations,
            mechanics: self.values[written].mechanics,
        }
    }
}
