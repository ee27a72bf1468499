//! The stages from joints that stand to a whole tree.

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Spanned};
use crate::limits::FOLLOWING;
use crate::tree::assembly::bodies::Pieces;
use crate::tree::assembly::markers::{Marker, markers};
use crate::tree::assembly::merging::{Merged, merge};
use crate::tree::assembly::placing::place;
use crate::tree::assembly::settled::Settled;
use crate::tree::frames::note_merged;
use crate::tree::joints::ResolvedJoint;
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
    let marked = markers(description, settled.outward, &merged.hosts)?;
    let marker_names = marked.iter().map(|marker| marker.name.as_str());
    let marker_identifiers = names::frame_identifiers(marker_names, &identifiers);
    let known = Known {
        settled,
        identifiers: &identifiers,
        merged: &merged,
        marked: &marked,
        marker_identifiers: &marker_identifiers,
    };
    let values = known.values(findings)?;
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
    let bodies = pieces.bodies(&merged, numbered.joints);
    let frames = pieces.frames(&merged, &bodies, &values.parameters);
    let markers = pieces.markers(
        &marked,
        marker_identifiers,
        &values.frames,
        &bodies,
        &values.parameters,
    );
    note_moved(description, &moving, findings);
    note_merged(&frames, &bodies, findings);
    let tree = Tree {
        name: description.name.as_ref()?.value.clone(),
        gravity: values.gravity,
        order,
        bodies,
        frames,
        markers,
        snap: settled.snap,
        parameters: values.parameters,
        n_coordinates: numbered.n_coordinates,
        n_speeds: numbered.n_speeds,
    };
    names::check_coordinates(&tree, findings);
    names::note_order(&tree, findings);
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

/// What is known of bodies and frames before their values; each list of bodies is outward.
struct Known<'a> {
    settled: Settled<'a>,
    identifiers: &'a [String],
    merged: &'a Merged,
    marked: &'a [Marker],
    marker_identifiers: &'a [String],
}

impl Known<'_> {
    /// The values of all bodies, outward, and of all frames.
    fn values(&self, findings: &mut Vec<Diagnostic>) -> Option<Values> {
        let Settled {
            description,
            outward,
            joints,
            ..
        } = self.settled;
        let places = outward.places.iter();
        let bodies = places.zip(self.identifiers).zip(&self.merged.hosts);
        let bodies = bodies.map(|((&place, identifier), &host)| HostedBody {
            written: &description.bodies[place],
            joint: &joints[place],
            identifier,
            host,
        });
        let frames = description.frames.iter().zip(self.marked);
        let frames = frames.zip(self.marker_identifiers);
        let frames = frames.map(|((written, marker), identifier)| KnownFrame {
            written,
            identifier,
            host: marker.host,
        });
        values(description, bodies, frames, findings)
    }
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
