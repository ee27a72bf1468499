//! What is around an element, on its way into a body.

use std::rc::Rc;

use crate::description::mjcf::defaults::Class;
use crate::description::mjcf::placement::Placement;

/// What is around an element: frames, a class, and copies.
#[derive(Clone, Debug)]
pub(super) struct Around {
    pub(super) frame: Placement,
    pub(super) class: Class,
    /// What stands behind the names in a copy that `replicate` makes.
    pub(super) suffix: Rc<str>,
}

impl Around {
    /// Nothing but a class.
    pub(super) fn class(class: Class) -> Self {
        Self {
            frame: Placement::SAME,
            class,
            suffix: Rc::from(""),
        }
    }
}
