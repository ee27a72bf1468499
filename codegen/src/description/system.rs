//! A multibody system, as the user wrote it.

use crate::description::body::WrittenBody;
use crate::description::frame::WrittenFrame;
use crate::description::value::{Given, Scalar};
use crate::diagnostic::{Diagnostic, Source, Span, Spanned};

/// A multibody system as the user wrote it.
///
/// The readers make it. A description made in memory has to be as they leave it: all numbers finite, rotations orthonormal, axes not zero,
/// a mass, a mass centre, an inertia and an attachment for each body; no later stage checks that. Written as a file
/// ([`toml::write`](crate::description::toml::write)) and read again, it gets every check.
#[derive(Clone, Debug)]
pub struct Description {
    /// The file.
    pub source: Source,
    /// The system's name.
    pub name: Given<String>,
    /// Gravity, inertial components, m/s²; zero where the file says nothing.
    pub gravity: [Given<Scalar>; 3],
    /// The body-connection array: for each body the number of its lower body (parent) from 1, or 0 for the inertial frame.
    pub lower_bodies: Given<Vec<Given<i64>>>,
    /// The order of coordinates and speeds; body after body where the file says nothing.
    pub order: Given<Order>,
    /// The bodies, in the numbering of the body-connection array.
    pub bodies: Vec<WrittenBody>,
    /// Frames that only mark places.
    pub frames: Vec<WrittenFrame>,
    /// What was wrong already while reading.
    pub faults: Vec<Diagnostic>,
}

impl Description {
    /// A file of which nothing could be read.
    pub(crate) fn none(source: &Source, faults: Vec<Diagnostic>) -> Self {
        let start = Span { start: 0, end: 0 };
        Self {
            source: source.clone(),
            name: None,
            gravity: [None; 3],
            lower_bodies: None,
            order: Some(Spanned::new(Order::Body, start)),
            bodies: Vec::new(),
            frames: Vec::new(),
            faults,
        }
    }
}

/// The order of coordinates and speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Body after body; in a body its free angles, then its free translations.
    Body,
    /// All free angles, body after body, then all free translations: Eq. (1).
    Notes,
}

impl Order {
    /// Both, with their names.
    pub const NAMED: [(&str, Self); 2] = [("body", Self::Body), ("notes", Self::Notes)];
}
