//! How much `replicate` and `attach` copy, which is bounded: a few letters can ask for very much.

use std::cell::Cell;

use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span};
use crate::limits::XML_NODES;

/// How many elements were copied so far.
#[derive(Debug, Default)]
pub(in crate::description::mjcf) struct Copies(Cell<u32>);

impl Copies {
    /// True once there were too many.
    pub(in crate::description::mjcf) fn is_exhausted(&self) -> bool {
        self.0.get() > XML_NODES
    }

    /// Counts an element that is copied; false where there are too many, which is told once.
    pub(in crate::description::mjcf) fn count(&self, reader: &mut Reader, span: Span) -> bool {
        let count = self.0.get();
        if count > XML_NODES {
            return false;
        }
        self.0.set(count + 1);
        if count == XML_NODES {
            let message = format!("`replicate` and `attach` make more than {XML_NODES} elements");
            reader
                .faults
                .push(Diagnostic::error(message).at(span, "one too many"));
        }
        count < XML_NODES
    }
}
