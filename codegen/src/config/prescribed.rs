//! Joints whose accelerations a `kane.toml` prescribes.

use crate::{
    description::toml_reader::{Reader, Table},
    diagnostic::{Diagnostic, Spanned},
    tree::PrescribedFault,
};

use super::changes;

/// The joints that a system prescribes, where they stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prescribed {
    /// The list, in the words of messages.
    what: String,
    entries: Vec<Spanned<String>>,
}

/// Reads `prescribed` of a system.
pub(super) fn read(reader: &mut Reader, system: &Table<'_, '_>) -> Prescribed {
    Prescribed {
        what: system.what("prescribed"),
        entries: changes::names(reader, system, "prescribed"),
    }
}

impl Prescribed {
    /// The names, as they stand there.
    pub fn names(&self) -> Vec<String> {
        let entries = self.entries.iter();
        entries.map(|entry| entry.value.clone()).collect()
    }

    /// What is wrong with one of them on a model, at its place; `None` where it is none of them.
    pub fn fault(&self, fault: &PrescribedFault) -> Option<Diagnostic> {
        let entry = |name: &str| self.entries.iter().find(|entry| entry.value == name);
        let shown = Diagnostic::error(format!("{}: {fault}", self.what));
        let shown = shown.at(entry(fault.name())?.span, fault.expected());
        let shown = shown.help(fault.help());
        let first = match fault {
            PrescribedFault::Twice { first, .. } => entry(first),
            _ => None,
        };
        Some(shown.at_if(first.map(|first| first.span), "the first one"))
    }
}
