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

/// Bytes of the longest word for which one that is near is looked for.
const LONGEST: usize = 100;

/// Letters of the shortest word that tells with which name it begins.
const SHORTEST: usize = 3;

/// The candidate that `word` was probably meant to be: one that is near enough, or the only one that begins so.
pub fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let lower = word.to_lowercase();
    // A very long word is near nothing, and the distance costs the product of both lengths.
    if lower.len() > LONGEST {
        return None;
    }
    candidates
        .iter()
        .filter(|candidate| candidate.len() <= 2 * LONGEST)
        .map(|candidate| (edits(&lower, &candidate.to_lowercase()), *candidate))
        .filter(|(edits, candidate)| *edits <= candidate.chars().count() / 3)
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
        .or_else(|| begun(&lower, candidates))
}

/// The one candidate that begins so.
fn begun<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let is_begun = |candidate: &&&str| candidate.to_lowercase().starts_with(word);
    let mut begun = candidates.iter().filter(is_begun);
    let only = begun.next().filter(|_| begun.next().is_none());
    only.filter(|_| word.chars().count() >= SHORTEST).copied()
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
