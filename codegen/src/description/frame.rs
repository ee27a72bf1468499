//! A frame that only marks a place, as the user wrote it.

use crate::description::value::{Given, Scalar};
use crate::diagnostic::{Span, Spanned};
use crate::geometry::Rotation;

/// A `[[frame]]`, or a site.
#[derive(Clone, Debug)]
pub struct WrittenFrame {
    /// Where it is written.
    pub span: Span,
    /// The name.
    pub name: Given<String>,
    /// The body in which it is fixed.
    pub body: Carrier,
    /// From the body's origin, body components, m.
    pub position: [Given<Scalar>; 3],
    /// From the body's axes to the frame's.
    pub rotation: Given<FrameRotation>,
}

/// What a frame is fixed in.
#[derive(Clone, Debug, PartialEq)]
pub enum Carrier {
    /// The inertial frame.
    Inertial,
    /// The body of this name; `None` where it cannot be read, which is then among the faults.
    Body(Given<String>),
}

/// The rotation of a frame, in one of its binding times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameRotation {
    /// Baked into the generated code.
    Baked(Rotation),
    /// Set by the user at run time, and used as it is given; these are its nominal values.
    Runtime([[f64; 3]; 3]),
}

impl WrittenFrame {
    /// A frame in the axes of the inertial one, in its origin.
    pub(crate) fn new(span: Span, name: Given<String>) -> Self {
        let identity = FrameRotation::Baked(crate::geometry::IDENTITY);
        Self {
            span,
            name,
            body: Carrier::Inertial,
            position: [Some(Spanned::new(Scalar::Baked(0.0), span)); 3],
            rotation: Some(Spanned::new(identity, span)),
        }
    }
}
