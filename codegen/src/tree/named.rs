//! Frames that have names: every body, what is fixed to it and part of it, and what only marks a place.

use crate::{
    geometry::IDENTITY,
    id::BodyId,
    tree::{Frame, Offset, Pose, Tree},
};

/// A frame of a [`Tree`] that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NamedFrame {
    /// The user's frame of a body.
    Body(BodyId),
    /// One of [`Tree::frames`].
    Fixed(usize),
}

impl Tree {
    /// All frames that have names: bodies, then what is fixed.
    pub fn named_frames(&self) -> impl Iterator<Item = NamedFrame> {
        let bodies = self.body_ids().map(NamedFrame::Body);
        bodies.chain((0..self.frames.len()).map(NamedFrame::Fixed))
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

    fn fixed(&self, frame: NamedFrame) -> Result<&Frame, BodyId> {
        match frame {
            NamedFrame::Body(body) => Err(body),
            NamedFrame::Fixed(place) => Ok(&self.frames[place]),
        }
    }
}

impl Pose {
    /// The inertial frame's own.
    pub fn inertial() -> Self {
        Self {
            rotation: IDENTITY,
            origin: Offset::default(),
        }
    }
}
