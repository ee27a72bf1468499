//! Frames with names of their own: bodies that are fixed to others, and are part of those; and markers, which have no mass.
//!
//! In: where such a frame stands in the internal axes of the body that it is part of. Out: a [`Frame`] in the user's axes of
//! that body.

use crate::diagnostic::{Diagnostic, shown_name};
use crate::geometry::{self, Rotation};
use crate::id::BodyId;
use crate::tree::body::{Body, Pose};
use crate::tree::value::{Parameter, Value};

/// A frame that the user gave a name: a body that is fixed to another, and is part of that, or a marker.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The name, as the user wrote it.
    pub name: String,
    /// The Rust identifier that stands for the name in generated code: unique among bodies and frames.
    pub identifier: String,
    /// The name of the joint that fixes it, where there is one and it has a name of its own.
    pub joint: Option<String>,
    /// The body of which it is part; `None` is the inertial frame.
    pub body: Option<BodyId>,
    /// From the user's axes of that body to the frame's; at the nominal values.
    pub rotation: Rotation,
    /// From the user's origin of that body to the frame's, that body's axes, m; at the nominal values.
    pub position: [f64; 3],
    /// Where it stands along that body's internal axes, but for `turn`.
    pub pose: Pose,
    /// A rotation that is set at run time, from the axes of `pose` to the frame's.
    pub turn: Option<[[Value; 3]; 3]>,
}

/// What a frame is called.
pub(crate) struct FrameName {
    pub(crate) name: String,
    pub(crate) identifier: String,
}

impl Frame {
    /// The frame that stands at `pose` in a body, or in the inertial frame, of which `base` are the user's axes and origin.
    pub(crate) fn new(
        FrameName { name, identifier }: FrameName,
        body: Option<BodyId>,
        [base, pose]: [&Pose; 2],
        parameters: &[Parameter],
        snap: f64,
    ) -> Self {
        Self {
            name,
            identifier,
            joint: None,
            body,
            rotation: pose.rotation_from(base, snap),
            position: pose.position_from(base, parameters),
            pose: pose.clone(),
            turn: None,
        }
    }
}

impl Frame {
    /// The frame, turned by what is set at run time.
    pub(crate) fn turned(self, turn: [[Value; 3]; 3], parameters: &[Parameter]) -> Self {
        let nominal = turn.map(|row| row.map(|entry| entry.nominal(parameters)));
        Self {
            rotation: geometry::then(&self.rotation, &nominal),
            turn: Some(turn),
            ..self
        }
    }
}

/// Tells which bodies are part of others.
pub(crate) fn note_merged(frames: &[Frame], bodies: &[Body], findings: &mut Vec<Diagnostic>) {
    let merged: Vec<String> = frames
        .iter()
        .map(|frame| {
            let name = shown_name(&frame.name);
            match frame.body {
                Some(body) => {
                    let body = shown_name(&bodies[body.index()].name);
                    format!("`{name}` of `{body}`")
                }
                None => format!("`{name}` of the inertial frame"),
            }
        })
        .collect();
    if !merged.is_empty() {
        let note = format!(
            "bodies that are fixed are part of what they are fixed to: {}",
            merged.join(", ")
        );
        let plural = "fixed bodies are part of what they are fixed to";
        findings.push(Diagnostic::note(note).all_of(plural, merged));
    }
}
