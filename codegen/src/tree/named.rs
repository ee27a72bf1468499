//! Frames that have names: every body, what is fixed to it and part of it, and what only marks a place.

use crate::id::BodyId;
use crate::tree::body::Pose;
use crate::tree::frames::Frame;
use crate::tree::system::Tree;
use crate::tree::value::Value;

/// A frame of a [`Tree`] that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NamedFrame {
    /// The user's frame of a body.
    Body(BodyId),
    /// One of [`Tree::frames`].
    Fixed(usize),
    /// One of [`Tree::markers`].
    Marker(usize),
}

impl Tree {
    /// All frames that have names: bodies, then what is fixed, then what only marks a place.
    pub fn named_frames(&self) -> impl Iterator<Item = NamedFrame> + use<> {
        let bodies = self.body_ids().map(NamedFrame::Body);
        let fixed = (0..self.frames.len()).map(NamedFrame::Fixed);
        let markers = (0..self.markers.len()).map(NamedFrame::Marker);
        bodies.chain(fixed).chain(markers)
    }

    /// The name, as the user wrote it.
    pub fn frame_name(&self, frame: NamedFrame) -> &str {
        match self.fixed(frame) {
            Ok(frame) => &frame.name,
            Err(body) => &self.body(body).name,
        }
    }

    /// The Rust identifier that stands for the name in generated code.
    pub fn frame_identifier(&self, frame: NamedFrame) -> &str {
        match self.fixed(frame) {
            Ok(frame) => &frame.identifier,
            Err(body) => &self.body(body).identifier,
        }
    }

    /// The body in which it is fixed; `None` for the inertial frame.
    pub fn frame_body(&self, frame: NamedFrame) -> Option<BodyId> {
        match self.fixed(frame) {
            Ok(frame) => frame.body,
            Err(body) => Some(body),
        }
    }

    /// Where it stands in that body, internal axes and origin.
    pub fn frame_pose(&self, frame: NamedFrame) -> &Pose {
        match self.fixed(frame) {
            Ok(frame) => &frame.pose,
            Err(body) => &self.body(body).pose,
        }
    }

    /// A rotation that is set at run time, from the axes of [`Self::frame_pose`] to the frame's.
    pub fn frame_turn(&self, frame: NamedFrame) -> Option<&[[Value; 3]; 3]> {
        self.fixed(frame).ok()?.turn.as_ref()
    }

    fn fixed(&self, frame: NamedFrame) -> Result<&Frame, BodyId> {
        match frame {
            NamedFrame::Body(body) => Err(body),
            NamedFrame::Fixed(place) => Ok(&self.frames[place]),
            NamedFrame::Marker(place) => Ok(&self.markers[place]),
        }
    }
}
