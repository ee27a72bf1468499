//! Mesh files that are text.

use std::borrow::Cow;

use crate::diagnostic::Escaped;

/// The text of a file, whatever bytes are no text.
pub(super) fn of(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(without_mark(bytes))
}

/// What stands behind a byte-order mark.
pub(super) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes)
}

/// The words of each line that has some, with the line's number. Lines end in a line feed, or all of them in a carriage return alone.
pub(super) fn lines(
    text: &str,
) -> impl Iterator<Item = (usize, std::str::SplitAsciiWhitespace<'_>)> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let lines = text.split(end).enumerate();
    lines.map(|(index, line)| (index + 1, line.split_ascii_whitespace()))
}

/// The beginning of a word, as a message may have it.
pub(super) fn shown(word: &str) -> String {
    let word: String = word.chars().take(20).collect();
    word.escaped()
}
