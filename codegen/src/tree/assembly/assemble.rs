//! The stages from joints that stand to a whole tree.

use std::collections::BTreeSet;

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Spanned};
use crate::limits::FOLLOWING;
use crate::tree::assembly::bodies::Pieces;
use crate::tree::assembly::markers::{Marker, markers};
use crate::tree::assembly::merging::{Merged, merge};
use crate::tree::assembly::placing::place;
use crate::tree::assembly::settled::Settled;
use crate::tree::base_parameter::BaseParameters;
use crate::tree::frames::note_merged;
use crate::tree::friction;
use crate::tree::joints::ResolvedJoint;
use crate::tree::lifted;
use crate::tree::names;
use crate::tree::numbering::{Numbered, note_moved, number};
use crate::tree::system::Tree;
use crate::tree::values::{HostedBody, KnownFrame, Values, values};

/// The tree; `None` where a value is missing, or where it would be too large.
pub(crate) fn assemble(settled: Settled<'_>, findings: &mut Vec<Diagnostic>) -> Option<Tree> {
    let description = settled.description;
    let order = description.order?.value;
    let names = written_names(settled)?;
    let identifiers = names::identifiers(&names, findings);
    let merged = merge(settled.outward, settled.joints);
    let markers = markers(
        description,
        settled.outward,
        &merged.hosts,
        &identifiers,
        findings,
    )?;
    let values = values_of(settled, (&identifiers, &markers), &merged, findings)?;
    let moving = places_of_moving(settled, &merged);
    let numbered = number(settled.joints, &moving, order);
    check_size(settled, moving.len(), &numbered, findings)?;
    let placed = place(settled, &values.bodies);
    let pieces = Pieces {
        settled,
        names: &names,
        identifiers: &identifiers,
        values: &values.bodies,
        placed: &placed,
    };
    let mut bodies = pieces.bodies(&merged, numbered.joints);
    let lifted = lifted::of_all(&mut bodies);
    let frames = pieces.frames(&merged, &bodies, &values.parameters);
    let markers = markers.into_iter().zip(&values.frames);
    let markers = markers.map(|(marker, own)| {
        let standing = (&placed[..], &bodies[..]);
        marker.frame(own, standing, &values.parameters, settled.snap)
    });
    let markers = markers.collect();
    names::note_joints(description, &moving, settled.joints, findings);
    note_moved(description, &moving, findings);
    note_merged(&frames, &bodies, findings);
    let tree = Tree {
        name: description.name.as_ref()?.value.clone(),
        gravity: values.gravity,
        lifted,
        order,
        bodies,
        frames,
        markers,
        snap: settled.snap,
        parameters: values.parameters,
        prescribed: BTreeSet::new(),
        n_coordinates: numbered.n_coordinates,
        n_speeds: numbered.n_speeds,
        base_parameters: BaseParameters::default(),
    };
    names::check_coordinates(&tree, findings);
    names::note_order(&tree, findings);
    friction::note(&tree, findings);
    Some(tree)
}

/// The names of the bodies, outward.
fn written_names(settled: Settled<'_>) -> Option<Vec<Spanned<String>>> {
    let Description { bodies, .. } = settled.description;
    let names = settled.outward.places.iter();
    names.map(|&place| bodies[place].name.clone()).collect()
}

/// The places in the user's list of the bodies that move, outward.
fn places_of_moving(settled: Settled<'_>, merged: &Merged) -> Vec<usize> {
    let bodies = merged.bodies.iter();
    let places = bodies.map(|body| settled.outward.places[body.written]);
    places.collect()
}

/// The values of all bodies, outward, and of the frames that mark places.
fn values_of(
    settled: Settled<'_>,
    (identifiers, markers): (&[String], &[Marker]),
    merged: &Merged,
    findings: &mut Vec<Diagnostic>,
) -> Option<Values> {
    let places = settled.outward.places.iter();
    let known = places.zip(identifiers).zip(&merged.hosts);
    let known = known.map(|((&place, identifier), &host)| HostedBody {
        written: &settled.description.bodies[place],
        joint: &settled.joints[place],
        identifier,
        host,
    });
    let frames = settled.description.frames.iter().zip(markers);
    let frames = frames.map(|(written, marker)| KnownFrame {
        written,
        identifier: &marker.name.identifier,
        host: marker.host,
    });
    values(settled.description, known, frames, findings)
}

/// Where coordinates follow others, bodies and speeds must be few enough to judge them.
fn check_size(
    settled: Settled<'_>,
    n_bodies: usize,
    numbered: &Numbered,
    findings: &mut Vec<Diagnostic>,
) -> Option<()> {
    let n_speeds = numbered.n_speeds;
    let is_any_following = settled.joints.iter().any(ResolvedJoint::follows);
    if !is_any_following || n_bodies.max(n_speeds) <= FOLLOWING {
        return Some(());
    }
    findings.push(Diagnostic::error(format!(
        "the system, in which joints follow others, has {n_bodies} bodies that move and {n_speeds} speeds; \
        expected at most {FOLLOWING} of each"
    )));
    None
}
