//! What is around an element, on its way into a body.

use std::rc::Rc;

use crate::description::mjcf::defaults::Class;
use crate::description::mjcf::placement::Placement;

/// What is around an element: frames, a class, the model in which it is written, and copies.
#[derive(Clone, Debug)]
pub(super) struct Around {
    pub(super) frame: Placement,
    pub(super) class: Class,
    /// The number of the model in which the element stands.
    pub(super) model: usize,
    /// What stands before the names in a model that is attached.
    pub(super) prefix: Rc<str>,
    /// What stands behind the names in a copy that `replicate` makes.
    pub(super) suffix: Rc<str>,
}

impl Around {
    /// The main model's world.
    pub(super) fn world() -> Self {
        Self {
            frame: Placement::SAME,
            class: Class::MAIN,
            model: 0,
            prefix: Rc::from(""),
            suffix: Rc::from(""),
        }
    }

    /// The name of an element that is written so.
    pub(super) fn name(&self, written: &str) -> String {
        format!("{}{written}{}", self.prefix, self.suffix)
    }

    /// True for elements that stand in the file once and in the tree more often.
    pub(super) fn is_copy(&self) -> bool {
        self.model != 0 || !self.suffix.is_empty()
    }
}
