//! What links and joints have in common: a name, and elements inside that say nothing about the dynamics.

use std::collections::BTreeMap;

use crate::description::Given;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// Elements without influence on the dynamics, wherever they stand.
pub(super) const IGNORED: [&str; 9] = [
    "visual",
    "collision",
    "material",
    "transmission",
    "gazebo",
    "ros2_control",
    "safety_controller",
    "calibration",
    "sensor",
];

/// The names of links, or of joints, that are taken.
pub(super) struct Names<'d> {
    /// What has them: `link`.
    what: &'static str,
    first: BTreeMap<&'d str, Spanned<&'d str>>,
    /// How many elements were named, or were to be.
    count: usize,
}

/// What an element is called.
pub(super) struct Named<'d> {
    /// Its name, unless it has none, or that of another.
    pub(super) name: Given<&'d str>,
    /// The words for it in messages: "link `hub`", or "link 3" without a name.
    pub(super) words: String,
}

impl<'d> Names<'d> {
    pub(super) fn of(what: &'static str) -> Self {
        Self {
            what,
            first: BTreeMap::new(),
            count: 0,
        }
    }

    /// Whether a name is taken.
    pub(super) fn has(&self, name: &str) -> bool {
        self.first.contains_key(name)
    }

    /// The name of the next element.
    pub(super) fn next(&mut self, reader: &mut Reader, element: Element<'d>) -> Named<'d> {
        self.count += 1;
        let name = element.attribute("name");
        if let Some(name) = name.filter(|name| !name.value.is_empty()) {
            return Named {
                name: self.unless_taken(reader, name),
                words: format!("{} `{}`", self.what, shown(name.value)),
            };
        }
        let words = format!("{} {}", self.what, self.count);
        if let Some(name) = reader.required(element, &words, "name") {
            let fault = Diagnostic::error(format!("the name of {words} is empty"));
            reader.faults.push(fault.at(name.span, "expected a name"));
        }
        Named { name: None, words }
    }

    fn unless_taken(&mut self, reader: &mut Reader, name: Spanned<&'d str>) -> Given<&'d str> {
        let Some(first) = self.first.get(name.value) else {
            self.first.insert(name.value, name);
            return Some(name);
        };
        let (what, shown) = (self.what, shown(name.value));
        let fault = Diagnostic::error(format!("two {what}s have the name `{shown}`"));
        reader.faults.push(
            fault
                .at(name.span, "the second one")
                .at(first.span, "the first one"),
        );
        None
    }
}
