//! One fault: how much it matters, what is wrong, where, and what to do.

use super::Span;

/// How much a fault matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The input cannot be used.
    Error,
    /// The input can be used, but is probably not what was meant.
    Warning,
    /// Something was decided that the user should know.
    Note,
}

/// One fault of an input file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// What was found and what was expected.
    pub message: String,
    /// The places it is about, the main one first, each with a few words; may be empty.
    pub labels: Vec<(Span, String)>,
    /// What to do about it.
    pub help: Option<String>,
    /// What it and others like it are told as, on one line.
    pub kind: Option<Box<Kind>>,
    /// What it is about, where that stands beside the source.
    pub entry: Option<Box<Entry>>,
    /// True for a note that numbers are computed with others than the input has: results are told with it.
    pub changes_numbers: bool,
}

/// What the user gave beside a source: a name in a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The list, as `kane.toml` calls it.
    pub list: &'static str,
    /// The name.
    pub name: String,
}

/// What several diagnostics have in common, and what this one is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kind {
    /// What they are, in the plural, as it stands after a number: "joints without `limit`".
    pub plural: String,
    /// The names of what this one is about.
    pub subjects: Vec<String>,
}

impl Diagnostic {
    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            message: message.into(),
            labels: Vec::new(),
            help: None,
            kind: None,
            entry: None,
            changes_numbers: false,
        }
    }

    /// A warning.
    pub fn warning(message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            ..Self::error(message)
        }
    }

    /// A note.
    pub fn note(message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Note,
            ..Self::error(message)
        }
    }

    /// The main place.
    pub(super) fn place(&self) -> Option<Span> {
        self.labels.first().map(|(span, _)| *span)
    }

    /// The same with one more place; the first is the main one.
    #[must_use]
    pub fn at(mut self, span: Span, label: impl Into<String>) -> Self {
        self.labels.push((span, label.into()));
        self
    }

    /// The same with one more place where there is one.
    #[must_use]
    pub fn at_if(self, span: Option<Span>, label: impl Into<String>) -> Self {
        match span {
            Some(span) => self.at(span, label),
            None => self,
        }
    }

    /// The same about a name that was given beside the source.
    #[must_use]
    pub fn of_entry(mut self, list: &'static str, name: impl Into<String>) -> Self {
        let name = name.into();
        self.entry = Some(Box::new(Entry { list, name }));
        self
    }

    /// The same as news wherever numbers are shown.
    #[must_use]
    pub fn that_changes_numbers(self) -> Self {
        Self {
            changes_numbers: true,
            ..self
        }
    }

    /// The same with advice.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same where there is something to do about it.
    #[must_use]
    pub fn help_if(self, help: Option<impl Into<String>>) -> Self {
        match help {
            Some(help) => self.help(help),
            None => self,
        }
    }

    /// The same as one of a kind, of which many are told on one line: `plural` stands after a number, `subject` is the name
    /// of what this one is about.
    #[must_use]
    pub fn one_of(self, plural: impl Into<String>, subject: impl Into<String>) -> Self {
        self.all_of(plural, [subject.into()])
    }

    /// The same where it is about several.
    #[must_use]
    pub fn all_of(
        mut self,
        plural: impl Into<String>,
        subjects: impl IntoIterator<Item = String>,
    ) -> Self {
        self.kind = Some(Box::new(Kind {
            plural: plural.into(),
            subjects: subjects.into_iter().collect(),
        }));
        self
    }

    /// The same with its places moved.
    #[must_use]
    pub(crate) fn moved(mut self, by: usize) -> Self {
        for (span, _) in &mut self.labels {
            *span = Span::from(span.start + by..span.end + by);
        }
        self
    }

    /// True for an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
