//! The constant rotations and axes of a description, made exact.
//!
//! In: rotations and axes as written. Out: those of every body, by its place in the user's list, and which of them were
//! changed. Afterwards: rotations are orthonormal, and entries near 0, 1 and -1 are exact.

use crate::description::{Description, JointKind, WrittenBody, WrittenJoint};
use crate::diagnostic::{Diagnostic, Escaped, Spanned};
use crate::geometry::{IDENTITY, Rotation};
use crate::tree::rotations::alignment::Alignment;
use crate::tree::rotations::orthonormal::orthonormal;
use crate::tree::rotations::snap::snapped;

/// The constant rotations of a body and its joint.
#[derive(Clone, Debug)]
pub(crate) struct ConstantRotations {
    /// From the body's axes to those of its inertia.
    pub(crate) inertia: Rotation,
    /// Axes with the joint's axis among them, where it has one.
    pub(crate) axis: Option<Alignment>,
    /// From the lower body's axes to the joint's, as written.
    pub(crate) attachment: Rotation,
    /// From the joint's axes, as written and moved, to the body's.
    pub(crate) body: Rotation,
}

/// What was changed.
#[derive(Clone, Debug)]
pub(crate) struct Snapped {
    tolerance: f64,
    /// For each body, by its place in the user's list, what of it.
    changed: Vec<Vec<&'static str>>,
    /// The largest change of an entry.
    most: f64,
}

/// Makes all constant rotations and axes exact where they are within `tolerance`.
pub(crate) fn exact(
    description: &Description,
    tolerance: f64,
) -> (Vec<ConstantRotations>, Snapped) {
    let mut snapped = Snapped {
        tolerance,
        changed: Vec::with_capacity(description.bodies.len()),
        most: 0.0,
    };
    let bodies = description.bodies.iter();
    let rotations = bodies.map(|body| snapped.body(body)).collect();
    (rotations, snapped)
}

impl Snapped {
    fn body(&mut self, written: &WrittenBody) -> ConstantRotations {
        self.changed.push(Vec::new());
        let joint = &written.joint;
        ConstantRotations {
            inertia: self.rotation(written.inertia_rotation.as_ref(), "inertia_rotation"),
            axis: self.axis(joint),
            attachment: self.rotation(joint.attachment_rotation.as_ref(), "attachment_rotation"),
            body: self.rotation(joint.body_rotation.as_ref(), "body_rotation"),
        }
    }

    fn rotation(&mut self, written: Option<&Spanned<Rotation>>, what: &'static str) -> Rotation {
        let Some(written) = written else {
            return IDENTITY;
        };
        let (rotation, change) = snapped(&orthonormal(&written.value), self.tolerance);
        self.note_change(what, change);
        rotation
    }

    fn axis(&mut self, joint: &WrittenJoint) -> Option<Alignment> {
        let kind = &joint.kind.as_ref()?.value;
        let axis = joint.axis.filter(|_| kind.has_axis())?;
        let (alignment, change) = if *kind == JointKind::Planar {
            Alignment::with_directions(axis.value, self.tolerance)
        } else {
            Alignment::of(axis.value, self.tolerance)
        };
        self.note_change("axis", change);
        Some(alignment)
    }

    /// An entry of what the last body says was changed by this much.
    fn note_change(&mut self, what: &'static str, change: f64) {
        if change > 0.0 {
            self.changed
                .last_mut()
                .expect("a body is being read")
                .push(what);
            self.most = self.most.max(change);
        }
    }

    /// True where an axis was changed.
    pub(crate) fn has_axis(&self) -> bool {
        self.changed.iter().flatten().any(|what| *what == "axis")
    }

    /// True where nothing was changed.
    pub(crate) fn is_nothing(&self) -> bool {
        self.changed.iter().all(Vec::is_empty)
    }

    /// Tells what was changed, body by body in this order of places in the user's list.
    pub(crate) fn note(&self, description: &Description, order: &[usize]) -> Option<Diagnostic> {
        let of_body = |&place: &usize| {
            let name = description.bodies[place].name.as_ref();
            let name = name.map_or_else(String::new, |name| name.value.escaped());
            let changed = self.changed[place].iter();
            changed.map(move |what| format!("`{what}` of `{name}`"))
        };
        let changed: Vec<String> = order.iter().flat_map(of_body).collect();
        (!changed.is_empty()).then(|| {
            let note = Diagnostic::note(format!(
                "entries of constant rotations and axes nearer than {:?} to 0, 1 or -1 were made exact, which changed none by more than {:.1e}: {}",
                self.tolerance,
                self.most,
                changed.join(", ")
            ));
            let plural = format!(
                "constant rotations and axes were made exact, which changed no entry by more than {:.1e}",
                self.most
            );
            note.all_of(plural, changed).that_changes_numbers()
        })
    }
}
