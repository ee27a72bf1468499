//! Input files: their texts, and places in them.

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

    /// `file:line:column` of a place, counted from 1, columns in characters.
    pub fn line_and_column(&self, place: usize) -> String {
        let file = self.file_at(place);
        let at = file.clamp(Span::from(place..place)).start;
        let (line, column) = file.line_and_column(at);
        format!("{}:{line}:{column}", file.name)
    }

    /// The file in which the place lies.
    pub(super) fn file_at(&self, place: usize) -> &SourceFile {
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

    /// The lines from one byte of the text to another, with their ends. The end of the file is the end of its last line, though that
    /// ends in a line's end.
    pub(super) fn lines(&self, first: usize, last: usize) -> std::ops::Range<usize> {
        let before = match self.text[..first].strip_suffix('\n') {
            Some(before) if first == self.text.len() => before,
            _ => &self.text[..first],
        };
        let start = before.rfind('\n').map_or(0, |at| at + 1);
        let rest = self.text[last..].find('\n');
        start..rest.map_or(self.text.len(), |at| last + at + 1)
    }

    /// The number of the line that starts at this byte, from 1.
    pub(super) fn line(&self, start: usize) -> usize {
        1 + self.text[..start].matches('\n').count()
    }

    /// The number of the line in which a byte of the text stands, and of the character in it, from 1.
    pub(super) fn line_and_column(&self, at: usize) -> (usize, usize) {
        let start = self.lines(at, at).start;
        (self.line(start), 1 + self.text[start..at].chars().count())
    }

    /// The bytes of the text where the span lies in it at character boundaries, else what of it does.
    pub(super) fn clamp(&self, span: Span) -> std::ops::Range<usize> {
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
