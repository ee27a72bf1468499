//! Words as they may be shown, and words that are near one another.

use std::borrow::Cow;

use crate::limits::NAME_CHARACTERS;

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

/// All of a few, of more the first three and how many more there are.
pub fn first_few<S: AsRef<str>>(names: &[S]) -> String {
    // Never "and 1 more", which takes as much room as what it is.
    let n_shown = if names.len() > 4 { 3 } else { names.len() };
    let shown = names.iter().take(n_shown).map(AsRef::as_ref);
    let shown = shown.collect::<Vec<&str>>().join(", ");
    match names.len() - n_shown {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

/// A number of things: `1 line`, `2 lines`.
pub fn count(number: usize, one: &str) -> String {
    match number {
        1 => format!("1 {one}"),
        _ => format!("{number} {one}s"),
    }
}

/// Names in backquotes, with commas.
pub(crate) fn backquoted(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

/// Text of users, in messages.
pub trait Escaped {
    /// What could not be read, or would steer a terminal, is escaped; quotes are not.
    fn escaped(&self) -> String;
}

impl Escaped for str {
    fn escaped(&self) -> String {
        let escaped = self.escape_debug().to_string();
        // Every quote has a `\` of its own before it.
        escaped.replace("\\'", "'").replace("\\\"", "\"")
    }
}

/// Characters of a value shown in a message.
const MOST_SHOWN: usize = 40;

/// Text for a message: escaped, and cut where it is long.
pub(crate) fn shown(text: &str) -> String {
    cut(text, MOST_SHOWN)
}

/// A name for a message: escaped, and cut where no name may be as long.
pub(crate) fn shown_name(text: &str) -> String {
    cut(text, NAME_CHARACTERS)
}

fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}...", text[..end].escaped()),
        None => text.escaped(),
    }
}
