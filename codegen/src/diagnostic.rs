//! Faults of an input file, in the user's words, with the place where each stands.
//!
//! In: a [`Source`] and what is wrong with it. Out: text that shows `file:line:column`, the line and a
//! label below it, of each file that it is about. Afterwards: the faults stand in the order of the file. Does not: decide what is a fault.
//!
//! Messages are lower case, without a final stop, with the user's own names, and say what was found and what was expected.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use crate::limits::TOLD;

/// Faults shown by `Display`; the rest are only counted, for a broken file can hold thousands.
const MOST_SHOWN: usize = 100;
/// Bytes of the longest line that is shown.
const LONGEST_LINE: usize = 2_000;

/// The text of an input file and the name under which it is shown, and those of the files that it includes.
///
/// Spans count the bytes of all of them on one line: first those of the file itself, then those of each included file
/// from the place that [`Source::append`] gave it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    file: SourceFile,
    /// In the order of their places.
    included: Vec<SourceFile>,
}

/// One file of a [`Source`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    name: String,
    text: String,
    base: usize,
}

impl Source {
    /// A source; `name` is the path as the user should see it. A byte-order mark at the start of `text` is dropped.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            file: SourceFile::new(name.into(), text.into(), 0),
            included: Vec::new(),
        }
    }

    /// Adds a file that is included, and gives the place of its first byte.
    pub fn append(&mut self, name: impl Into<String>, text: impl Into<String>) -> usize {
        let last = self.included.last().unwrap_or(&self.file);
        // One byte between two files, so that the end of one is not the beginning of the next.
        let base = last.base + last.text.len() + 1;
        self.included
            .push(SourceFile::new(name.into(), text.into(), base));
        base
    }

    /// The path as the user should see it.
    pub fn name(&self) -> &str {
        &self.file.name
    }

    /// The text of the file itself.
    pub fn text(&self) -> &str {
        &self.file.text
    }

    /// The file itself, then those that it includes, in the order in which they were added.
    pub fn files(&self) -> impl Iterator<Item = &SourceFile> {
        std::iter::once(&self.file).chain(&self.included)
    }

    /// The file in which the place lies.
    fn file_at(&self, place: usize) -> &SourceFile {
        let after = self.included.partition_point(|file| file.base <= place);
        match after.checked_sub(1) {
            Some(index) => &self.included[index],
            None => &self.file,
        }
    }
}

impl SourceFile {
    fn new(name: String, mut text: String, base: usize) -> Self {
        if text.starts_with('\u{feff}') {
            text.remove(0);
        }
        Self { name, text, base }
    }

    /// The path as the user should see it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The place of the first byte.
    pub fn base(&self) -> usize {
        self.base
    }

    /// The bytes of the text where the span lies in it at character boundaries, else what of it does.
    fn clamp(&self, span: Span) -> std::ops::Range<usize> {
        let boundary = |at: usize| {
            (0..=at.min(self.text.len()))
                .rev()
                .find(|at| self.text.is_char_boundary(*at))
                .unwrap_or(0)
        };
        let end = boundary(span.end.saturating_sub(self.base));
        boundary(span.start.saturating_sub(self.base).min(end))..end
    }
}

/// A byte range of a source's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl From<std::ops::Range<usize>> for Span {
    fn from(range: std::ops::Range<usize>) -> Self {
        Self {
            start: range.start,
            end: range.end,
        }
    }
}

/// A value and where it stands in its source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Its place.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// The value at this place.
    pub fn new(value: T, span: impl Into<Span>) -> Self {
        Self {
            value,
            span: span.into(),
        }
    }
}

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
    pub kind: Option<Kind>,
}

/// What several diagnostics have in common, and what this one is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kind {
    /// What they are, in the plural, as it stands after a number: "joints without `limit`".
    pub plural: String,
    /// The name of what this one is about.
    pub subject: String,
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

    /// The same with one more place; the first is the main one.
    #[must_use]
    pub fn at(mut self, span: Span, label: impl Into<String>) -> Self {
        self.labels.push((span, label.into()));
        self
    }

    /// The same with advice.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same as one of a kind, of which many are told on one line: `plural` stands after a number, `subject` is the name
    /// of what this one is about.
    #[must_use]
    pub fn one_of(mut self, plural: impl Into<String>, subject: impl Into<String>) -> Self {
        self.kind = Some(Kind {
            plural: plural.into(),
            subject: subject.into(),
        });
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

    /// The text to show: message, `file:line:column`, line, labels, advice.
    pub fn render(&self, source: &Source) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Note => Level::NOTE,
        };
        let title = level.primary_title(&self.message);
        let mut group: Group<'_> = if self.labels.is_empty() {
            title.element(Origin::path(source.name()))
        } else {
            title.elements(self.places(source))
        };
        if let Some(help) = &self.help {
            group = group.element(Level::HELP.message(help));
        }
        printable(&Renderer::plain().render(&[group])).into_owned()
    }

    /// Of each file in which a label stands the lines from the first to the last one, that of the main one first.
    fn places<'a>(&'a self, source: &'a Source) -> Vec<Element<'a>> {
        let mut files: Vec<&SourceFile> = Vec::new();
        for (span, _) in &self.labels {
            let file = source.file_at(span.start);
            if !files.iter().any(|known| known.base == file.base) {
                files.push(file);
            }
        }
        let place = |file: &'a SourceFile| {
            let labels = self.labels.iter().enumerate();
            let here = labels.filter(|(_, (span, _))| source.file_at(span.start).base == file.base);
            let here = here.map(|(index, (span, label))| {
                let kind = if index == 0 {
                    AnnotationKind::Primary
                } else {
                    AnnotationKind::Context
                };
                (kind, file.clamp(*span), label)
            });
            snippet(file, &here.collect::<Vec<_>>())
        };
        files.into_iter().map(place).collect()
    }
}

/// The lines of a file with labels; where one of them is very long, the place of the first label alone.
fn snippet<'a>(
    file: &'a SourceFile,
    labels: &[(AnnotationKind, Range<usize>, &'a String)],
) -> Element<'a> {
    let text = file.text();
    let places = || labels.iter().map(|(_, place, _)| place);
    let first = places().map(|place| place.start).min().unwrap_or(0);
    let last = places().map(|place| place.end).max().unwrap_or(0);
    let lines = lines(text, first, last);
    let mut each = text[lines.clone()].split('\n');
    if each.any(|line| line.len() > LONGEST_LINE) {
        let main = places().next().map_or(0, |place| place.start);
        return place_alone(file, main).into();
    }
    let annotations = labels.iter().map(|(kind, place, label)| {
        let here = place.start - lines.start..place.end - lines.start;
        kind.span(here).label(label.as_str())
    });
    Snippet::source(&text[lines.clone()])
        .line_start(number(text, lines.start))
        .path(file.name())
        .annotations(annotations)
        .into()
}

/// The line and the column of a place.
fn place_alone(file: &SourceFile, at: usize) -> Origin<'_> {
    let text = file.text();
    let start = lines(text, at, at).start;
    Origin::path(file.name())
        .line(number(text, start))
        .char_column(1 + text[start..at].chars().count())
}

/// The lines from one place to another, with their ends. The end of the file is the end of its last line, though that ends
/// in a line's end.
fn lines(text: &str, first: usize, last: usize) -> Range<usize> {
    let before = match text[..first].strip_suffix('\n') {
        Some(before) if first == text.len() => before,
        _ => &text[..first],
    };
    let start = before.rfind('\n').map_or(0, |at| at + 1);
    let rest = text[last..].find('\n');
    start..rest.map_or(text.len(), |at| last + at + 1)
}

/// The number of the line that starts here.
fn number(text: &str, start: usize) -> usize {
    1 + text[..start].matches('\n').count()
}

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
        list.sort_by_key(|diagnostic| diagnostic.labels.first().map(|(span, _)| *span));
        Self { source, list }
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
    /// All faults, an empty line between two; of more than a hundred, the first hundred.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.list.iter().take(MOST_SHOWN).enumerate() {
            let space = if index == 0 { "" } else { "\n\n" };
            write!(f, "{space}{}", diagnostic.render(&self.source))?;
        }
        match self.list.len().saturating_sub(MOST_SHOWN) {
            0 => Ok(()),
            more => write!(
                f,
                "\n\n{}: {more} more faults are not shown",
                self.source.name()
            ),
        }
    }
}

impl std::error::Error for Diagnostics {}

/// The text as a terminal may be given it: what would steer it, or turn the direction of writing, becomes `\u{fffd}`; lines end
/// as they do.
pub fn printable(text: &str) -> Cow<'_, str> {
    let steers = |c: char| is_unprintable(c) && c != '\n';
    if text.contains(steers) {
        Cow::Owned(text.replace(steers, "\u{fffd}"))
    } else {
        Cow::Borrowed(text)
    }
}

/// True for what must not stand in a name: a line's end would leave a comment, other control characters would steer a terminal,
/// and a change of writing direction would show other code than is there.
pub(crate) fn is_unprintable(character: char) -> bool {
    character.is_control() || matches!(character, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The candidate that `word` was probably meant to be, if one is near enough.
pub fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let lower = word.to_lowercase();
    // A very long word is near nothing, and the distance costs its square.
    if lower.len() > 100 {
        return None;
    }
    candidates
        .iter()
        .map(|candidate| (edits(&lower, &candidate.to_lowercase()), *candidate))
        .filter(|(edits, candidate)| *edits <= candidate.chars().count() / 3)
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from one word to the other.
fn edits(from: &str, to: &str) -> usize {
    let from: Vec<char> = from.chars().collect();
    let to: Vec<char> = to.chars().collect();
    let mut rows = vec![vec![0_usize; to.len() + 1]; from.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    rows[0] = (0..=to.len()).collect();
    for i in 1..=from.len() {
        for j in 1..=to.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(from[i - 1] != to[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = least;
        }
    }
    rows[from.len()][to.len()]
}
