//! Frames that only mark places: in which body each is, and where there.

use std::collections::BTreeMap;

use crate::description::{Carrier, Description, WrittenFrame};
use crate::diagnostic::Diagnostic;
use crate::geometry;
use crate::id::BodyId;
use crate::tree::assembly::placing::Placed;
use crate::tree::body::{Body, Pose};
use crate::tree::frames::{Frame, FrameName};
use crate::tree::names;
use crate::tree::numbering::Outward;
use crate::tree::offset::Offset;
use crate::tree::rotations::{orthonormal, snapped};
use crate::tree::value::Parameter;
use crate::tree::values::FrameValues;

/// A frame whose body is known.
pub(super) struct Marker {
    /// What it is called.
    pub(super) name: FrameName,
    /// The written body that carries it, by its place in the outward order; `None` is the inertial frame.
    pub(super) carrier: Option<usize>,
    /// The body of the tree in which that is.
    pub(super) host: Option<BodyId>,
}

/// The frames of a description, called unlike the bodies, which have these identifiers; `None` where a name is missing, or a
/// body is not there.
pub(super) fn markers(
    description: &Description,
    outward: &Outward,
    hosts: &[Option<BodyId>],
    bodies: &[String],
    findings: &mut Vec<Diagnostic>,
) -> Option<Vec<Marker>> {
    let frames = description.frames.iter();
    let written = frames.clone().map(|frame| frame.name.as_ref());
    let written: Vec<_> = written.collect::<Option<_>>()?;
    let identifiers = names::frame_identifiers(&written, bodies, findings);
    let names = written
        .iter()
        .zip(identifiers)
        .map(|(name, identifier)| FrameName {
            name: name.value.clone(),
            identifier,
        });
    let places = outward.places.iter().enumerate();
    let places = places.filter_map(|(place, &body)| {
        let name = description.bodies[body].name.as_ref()?;
        Some((&name.value, place))
    });
    let places: BTreeMap<&String, usize> = places.collect();
    let marker = |(frame, name): (&WrittenFrame, FrameName)| {
        let carrier = match &frame.body {
            Carrier::Inertial => None,
            Carrier::Body(name) => Some(*places.get(&name.as_ref()?.value)?),
        };
        Some(Marker {
            name,
            carrier,
            host: carrier.and_then(|carrier| hosts[carrier]),
        })
    };
    frames.zip(names).map(marker).collect()
}

impl Marker {
    /// The frame, in the internal axes of the body in which it is.
    pub(super) fn frame(
        self,
        values: &FrameValues,
        (placed, bodies): (&[Placed], &[Body]),
        parameters: &[Parameter],
        snap: f64,
    ) -> Frame {
        let below = self.carrier.map(|carrier| placed[carrier].pose.clone());
        let below = below.unwrap_or_else(Pose::internal);
        let own = snapped(&orthonormal(&values.rotation), snap).0;
        let position = Offset::new(below.rotation, values.position);
        let pose = Pose {
            rotation: snapped(&geometry::then(&below.rotation, &own), snap).0,
            origin: below.origin.clone().join(&position, false),
        };
        let base = self.host.map(|host| bodies[host.index()].pose.clone());
        let base = base.unwrap_or_else(Pose::internal);
        let frame = Frame::new(self.name, self.host, [&base, &pose], parameters, snap);
        match values.turn {
            Some(turn) => frame.turned(turn, parameters),
            None => frame,
        }
    }
}
