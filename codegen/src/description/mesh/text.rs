//! Mesh files that are text.

use std::borrow::Cow;
use std::str::SplitAsciiWhitespace;

use crate::diagnostic::Escaped;

/// The text of a file, whatever bytes are no text.
pub(super) fn of(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(without_mark(bytes))
}

/// What stands behind a byte-order mark.
pub(super) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes)
}

/// The words of each line, with the line's number. A line ends in a line feed, a carriage return, or both.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, SplitAsciiWhitespace<'_>)> {
    let mut rest = Some(text);
    let lines = std::iter::from_fn(move || {
        let line = rest?;
        let Some(end) = line.find(['\n', '\r']) else {
            rest = None;
            return Some(line);
        };
        let (line, after) = line.split_at(end);
        rest = after.strip_prefix("\r\n").or_else(|| after.get(1..));
        Some(line)
    });
    let lines = lines.enumerate();
    lines.map(|(index, line)| (index + 1, line.split_ascii_whitespace()))
}

/// The beginning of a word, as a message may have it.
pub(super) fn shown(word: &str) -> String {
    let word: String = word.chars().take(20).collect();
    word.escaped()
}
