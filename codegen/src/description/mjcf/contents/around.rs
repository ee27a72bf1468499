//! What is around an element, on its way into a body.

use std::rc::Rc;

use crate::description::mjcf::model::defaults::Class;
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span};
use crate::limits::NAME_CHARACTERS;

/// What is around an element: frames, a class, the model in which it is written, and copies.
#[derive(Clone, Debug)]
pub(in crate::description::mjcf) struct Around {
    pub(in crate::description::mjcf) frame: Placement,
    pub(in crate::description::mjcf) class: Class,
    /// The number of the model in which the element stands.
    pub(in crate::description::mjcf) model: usize,
    /// What stands before the names in what is attached.
    pub(in crate::description::mjcf) prefix: Rc<str>,
    /// What stands behind the names in a copy that `replicate` makes.
    pub(in crate::description::mjcf) suffix: Rc<str>,
}

impl Around {
    /// The main model's world.
    pub(in crate::description::mjcf) fn world() -> Self {
        Self {
            frame: Placement::SAME,
            class: Class::MAIN,
            model: 0,
            prefix: Rc::from(""),
            suffix: Rc::from(""),
        }
    }

    /// The name of an element that is written so.
    pub(in crate::description::mjcf) fn name(&self, written: &str) -> String {
        format!("{}{written}{}", self.prefix, self.suffix)
    }

    /// True where both stand in the same copy, or in none.
    pub(in crate::description::mjcf) fn is_same_copy(&self, other: &Self) -> bool {
        self.model == other.model && self.prefix == other.prefix && self.suffix == other.suffix
    }

    /// True for elements that stand in the file once and in the tree more often.
    pub(in crate::description::mjcf) fn is_copy(&self) -> bool {
        self.model != 0 || !self.prefix.is_empty() || !self.suffix.is_empty()
    }
}

/// Whether what is added to names of copies is no longer than a name may be.
pub(in crate::description::mjcf) fn fits(
    reader: &mut Reader,
    added: &str,
    what: &str,
    place: Span,
) -> bool {
    let n_characters = added.chars().count();
    if n_characters <= NAME_CHARACTERS {
        return true;
    }
    let message = format!(
        "{what} add {n_characters} characters to names; expected at most {NAME_CHARACTERS}"
    );
    let fault = Diagnostic::error(message).at(place, "too long");
    reader.faults.push(fault);
    false
}
