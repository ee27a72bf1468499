//! All faults of a file: collected as they are found, then in the order in which they stand there.

use std::{collections::BTreeSet, fmt};

use super::{Diagnostic, Severity, Source};
use crate::limits::TOLD;

/// Faults shown by `Display`; the rest are only counted, for a broken file can hold thousands.
const MOST_SHOWN: usize = 100;

/// The faults of a file as they are found; of very many the first.
#[derive(Debug, Default)]
pub struct Faults {
    told: Vec<Diagnostic>,
    n_errors: usize,
    n_others: usize,
}

impl Faults {
    /// Adds one.
    pub fn push(&mut self, fault: Diagnostic) {
        let count = match fault.severity {
            Severity::Error => &mut self.n_errors,
            _ => &mut self.n_others,
        };
        *count += 1;
        // An error among very many warnings is one of the first errors.
        if *count <= TOLD {
            self.told.push(fault);
        }
    }

    /// Adds several.
    pub fn extend(&mut self, faults: impl IntoIterator<Item = Diagnostic>) {
        for fault in faults {
            self.push(fault);
        }
    }

    /// How many there are, with those that are not told.
    pub fn count(&self) -> usize {
        self.n_errors + self.n_others
    }

    /// True where no more of this severity are told, and need not be looked for.
    pub fn is_full(&self, severity: Severity) -> bool {
        match severity {
            Severity::Error => self.n_errors >= TOLD,
            _ => self.n_others >= TOLD,
        }
    }

    /// True once there is an error among them.
    pub fn has_errors(&self) -> bool {
        self.n_errors > 0
    }

    /// Those that are told, in the order in which they were found.
    pub fn into_told(self) -> Vec<Diagnostic> {
        self.told
    }
}

/// The faults of one source, in the order in which they stand there.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    source: Source,
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// The faults of `source`, put into the order of their main places; those without a place come first.
    pub fn new(source: Source, mut list: Vec<Diagnostic>) -> Self {
        list.sort_by_key(Diagnostic::place);
        Self { source, list }
    }

    /// Adds faults, put into the order of places too.
    pub fn extend(&mut self, more: impl IntoIterator<Item = Diagnostic>) {
        self.list.extend(more);
        self.list.sort_by_key(Diagnostic::place);
    }

    /// Those that others do not have, by what they say: places move when a file is edited.
    #[must_use]
    pub fn without(&self, others: &Self) -> Self {
        let says = |one: &Diagnostic| (one.severity, one.message.clone());
        let told: BTreeSet<(Severity, String)> = others.list.iter().map(says).collect();
        let list = self.list.iter().filter(|one| !told.contains(&says(one)));
        Self {
            source: self.source.clone(),
            list: list.cloned().collect(),
        }
    }

    /// The source that they are about.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The faults.
    pub fn list(&self) -> &[Diagnostic] {
        &self.list
    }

    /// True where there is nothing to report.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// True where at least one is an error.
    pub fn has_error(&self) -> bool {
        self.list
            .iter()
            .any(|diagnostic| diagnostic.severity == Severity::Error)
    }
}

impl fmt::Display for Diagnostics {
    /// Errors in full, after warnings and notes, a line a kind; without errors, all in full. An empty line between two; of more than a
    /// hundred the first hundred.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let has_error = self.has_error();
        let mut paragraphs = Vec::new();
        if has_error {
            let lines = self.brief().lines.into_iter();
            let lines: Vec<String> = lines.map(|(_, line)| line).collect();
            paragraphs.extend((!lines.is_empty()).then(|| lines.join("\n")));
        }
        let in_full = self.list.iter();
        let in_full = in_full.filter(|one| !has_error || one.severity == Severity::Error);
        let n_hidden = in_full.clone().count().saturating_sub(MOST_SHOWN);
        let shown = in_full.take(MOST_SHOWN);
        paragraphs.extend(shown.map(|one| one.render(&self.source)));
        if n_hidden > 0 {
            let name = self.source.name();
            paragraphs.push(format!("{name}: {n_hidden} more faults are not shown"));
        }
        f.write_str(&paragraphs.join("\n\n"))
    }
}

impl std::error::Error for Diagnostics {}
