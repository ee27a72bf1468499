//! What a function of frames is of: the frames, and how their motion is seen.

use super::shape::Dimension;
use crate::{
    id::{BodyId, SpeedId},
    tree::{NamedFrame, Tree},
};

/// The frames that a function is of, on the tree of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subject {
    /// One, but where a function is of several, or of one as it is seen from another, which stands last.
    pub frames: Vec<SubjectFrame>,
    /// How they are seen.
    pub view: View,
    /// How many speeds move them as they are seen.
    pub(super) n_speeds: usize,
}

/// A frame that a function is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubjectFrame {
    /// Its name, as the user wrote it in the model.
    pub name: String,
    /// The Rust identifier that stands for it in generated code.
    pub identifier: String,
    /// The frame.
    pub frame: NamedFrame,
}

/// From where the motion of frames is seen, and along which axes vectors are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum View {
    /// From the inertial frame, along its axes.
    Inertial,
    /// From the inertial frame, along the frame's own axes: `velocity(tool0, local)`.
    Local,
    /// From the last of the frames, along its axes, its own motion included: `jacobian(tool0, camera)`.
    Other,
}

impl SubjectFrame {
    /// The frame with this name, as the model has it or as generated code does, if there is one.
    pub fn find(tree: &Tree, name: &str) -> Option<Self> {
        let with = |own: for<'a> fn(&'a Tree, NamedFrame) -> &'a str| {
            let mut frames = tree.named_frames();
            frames.find(|frame| own(tree, *frame) == name)
        };
        let frame = with(Tree::frame_name).or_else(|| with(Tree::frame_identifier))?;
        Some(Self {
            name: tree.frame_name(frame).to_owned(),
            identifier: tree.frame_identifier(frame).to_owned(),
            frame,
        })
    }
}

impl Subject {
    /// Frames of a tree.
    pub(super) fn new(tree: Option<&Tree>, frames: Vec<SubjectFrame>, view: View) -> Self {
        let own = Self {
            frames,
            view,
            n_speeds: 0,
        };
        let n_speeds = tree.map_or(0, |tree| own.speeds(tree).len());
        Self { n_speeds, ..own }
    }

    /// The names of the frames, as the model has them.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.frames.iter().map(|frame| frame.name.as_str())
    }

    /// The length of a dimension that it decides.
    pub(super) fn length(&self, dimension: Dimension) -> Option<usize> {
        match dimension {
            Dimension::FrameSpeeds => Some(self.n_speeds),
            Dimension::FrameComponents => Some(6 * self.frames.len()),
            Dimension::FramePoints => Some(3 * self.frames.len()),
            _ => None,
        }
    }

    /// The frame, or the first of several.
    pub fn frame(&self) -> NamedFrame {
        self.frames[0].frame
    }

    /// The frame from which it is seen, where it is not the inertial one.
    pub fn other(&self) -> Option<NamedFrame> {
        let other = self.frames.last().filter(|_| self.view == View::Other);
        other.map(|other| other.frame)
    }

    /// The speeds that move the frames as they are seen, in their order.
    pub fn speeds(&self, tree: &Tree) -> Vec<SpeedId> {
        let mut carried = vec![0; tree.bodies.len()];
        let held = self
            .frames
            .iter()
            .filter_map(|own| tree.frame_body(own.frame));
        for body in held.flat_map(|body| tree.path(body)) {
            carried[body.index()] += 1;
        }
        let moves = |body: &BodyId| match (self.view, carried[body.index()]) {
            // What carries both moves neither against the other.
            (View::Other, count) => count == 1,
            (View::Inertial | View::Local, count) => count > 0,
        };
        let bodies = tree.body_ids().filter(moves);
        let motions = bodies.flat_map(|body| tree.body(body).joint.motions());
        let mut speeds: Vec<SpeedId> = motions.flatten().map(|motion| motion.speed).collect();
        speeds.sort_unstable();
        speeds.dedup();
        speeds
    }
}
