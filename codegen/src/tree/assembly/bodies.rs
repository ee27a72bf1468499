//! Bodies, joints and frames, each made at once of all that belongs to it.

use crate::diagnostic::Spanned;
use crate::tree::assembly::merging::{Merged, MovingBody};
use crate::tree::assembly::placing::Placed;
use crate::tree::assembly::settled::Settled;
use crate::tree::body::{Body, Pose};
use crate::tree::frames::{Frame, FrameName};
use crate::tree::joint::Joint;
use crate::tree::numbering::JointCoordinates;
use crate::tree::value::Parameter;
use crate::tree::values::BodyValues;

/// What bodies are made from; each list is outward.
pub(super) struct Pieces<'a> {
    pub(super) settled: Settled<'a>,
    pub(super) names: &'a [Spanned<String>],
    pub(super) identifiers: &'a [String],
    pub(super) values: &'a [BodyValues],
    pub(super) placed: &'a [Placed],
}

impl Pieces<'_> {
    /// The bodies of the tree, each with its coordinates.
    pub(super) fn bodies(&self, merged: &Merged, coordinates: Vec<JointCoordinates>) -> Vec<Body> {
        let bodies = merged.bodies.iter().zip(coordinates);
        let bodies = bodies.map(|(moving, coordinates)| self.body(moving, coordinates));
        bodies.collect()
    }

    /// The frames of the written bodies that are part of these.
    pub(super) fn frames(
        &self,
        merged: &Merged,
        bodies: &[Body],
        parameters: &[Parameter],
    ) -> Vec<Frame> {
        let frame = |&written: &usize| {
            let host = merged.hosts[written];
            let base = host.map_or_else(Pose::internal, |host| bodies[host.index()].pose.clone());
            let poses = [&base, &self.placed[written].pose];
            let name = FrameName {
                name: self.names[written].value.clone(),
                identifier: self.identifiers[written].clone(),
            };
            Frame {
                joint: self.joint_name(written).map(|name| name.value.clone()),
                ..Frame::new(name, host, poses, parameters, self.settled.snap)
            }
        };
        merged.fixed.iter().map(frame).collect()
    }

    fn body(&self, moving: &MovingBody, coordinates: JointCoordinates) -> Body {
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
        let own_name = self.joint_name(written);
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

    /// The name of a written body's joint, where it has one of its own.
    fn joint_name(&self, written: usize) -> Option<&Spanned<String>> {
        let place = self.settled.outward.places[written];
        self.settled.description.bodies[place].joint.name.as_ref()
    }
}
