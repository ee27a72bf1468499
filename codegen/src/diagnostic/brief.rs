//! What is no error, a line a kind: how many there are, and the first of them.

use super::{Diagnostic, Diagnostics, Severity, first_few, printable};

/// Warnings and notes, a line a kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Brief {
    /// Each with its severity: warnings first, otherwise in the order of the file.
    pub lines: Vec<(Severity, String)>,
    /// True where the full text says more than the lines.
    pub is_shortened: bool,
}

impl Diagnostics {
    /// Warnings and notes, a line a kind. One that is alone of its kind is told by its message, with its place.
    pub fn brief(&self) -> Brief {
        let mut brief = Brief::default();
        for (severity, level) in [(Severity::Warning, "warning"), (Severity::Note, "note")] {
            let of_severity = self.list().iter();
            let of_severity = of_severity.filter(|one| one.severity == severity);
            for alike in by_kind(of_severity) {
                let (line, is_shortened) = self.line(&alike);
                let line = format!("{level}: {line}");
                brief.lines.push((severity, printable(&line).into_owned()));
                brief.is_shortened |= is_shortened;
            }
        }
        brief
    }

    /// A line about diagnostics of one kind, and whether it leaves something out.
    fn line(&self, alike: &[&Diagnostic]) -> (String, bool) {
        let first = alike[0];
        let subjects = alike.iter().filter_map(|one| one.kind.as_ref());
        let subjects: Vec<&str> = subjects
            .flat_map(|kind| kind.subjects.iter().map(String::as_str))
            .collect();
        match &first.kind {
            Some(kind) if subjects.len() > 1 => {
                let (count, plural, place) = (subjects.len(), &kind.plural, self.place(first));
                let line = format!("{place}: {count} {plural}: {}", first_few(&subjects));
                (line, true)
            }
            _ => {
                let (place, message) = (self.place(first), first.message.replace('\n', " "));
                let help = first.help.as_ref();
                let help = help.map_or_else(String::new, |help| format!("; {help}"));
                let again = match alike.len() {
                    1 => String::new(),
                    times => format!(" ({times} times)"),
                };
                (format!("{place}: {message}{help}{again}"), alike.len() > 1)
            }
        }
    }

    /// The file of a diagnostic, with line and column where it has a place.
    fn place(&self, of: &Diagnostic) -> String {
        match of.labels.first() {
            None => self.source().name().to_owned(),
            Some((span, _)) => self.source().line_and_column(span.start),
        }
    }
}

/// Diagnostics of one kind together, each kind where its first one stands; those without a kind alone, and once where they
/// say the same.
fn by_kind<'a>(all: impl Iterator<Item = &'a Diagnostic>) -> Vec<Vec<&'a Diagnostic>> {
    let mut kinds: Vec<Vec<&Diagnostic>> = Vec::new();
    let mut places = std::collections::BTreeMap::new();
    for one in all {
        let key = one.kind.as_ref().map_or(&one.message, |kind| &kind.plural);
        let place = *places.entry(key).or_insert(kinds.len());
        if place == kinds.len() {
            kinds.push(Vec::new());
        }
        kinds[place].push(one);
    }
    kinds
}
