//! What a function of a frame is of: the frame, and the axes of its outputs.

use crate::tree::{NamedFrame, Tree};

/// The frame that a function is of, on the tree of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subject {
    /// The frame's name, as the user wrote it in the model.
    pub name: String,
    /// The Rust identifier that stands for it in generated code.
    pub identifier: String,
    /// The frame.
    pub frame: NamedFrame,
    /// The axes of what is written.
    pub axes: Axes,
}

/// Along which axes a function of a frame writes vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axes {
    /// The inertial ones.
    Inertial,
    /// The frame's own: `velocity(tool0, local)`.
    Local,
}

impl Subject {
    /// The frame with this name, if the model has one.
    pub fn find(tree: &Tree, name: &str, axes: Axes) -> Option<Self> {
        let mut frames = tree.named_frames();
        let frame = frames.find(|frame| tree.frame_name(*frame) == name)?;
        Some(Self {
            name: name.to_owned(),
            identifier: tree.frame_identifier(frame).to_owned(),
            frame,
            axes,
        })
    }
}
