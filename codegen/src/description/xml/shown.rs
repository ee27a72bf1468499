//! Text of a file in messages.

/// Characters of a value shown in a message.
const MOST_SHOWN: usize = 40;

/// Text for a message: escaped, and cut where it is long.
pub(crate) fn shown(text: &str) -> String {
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}...", text[..end].escape_debug()),
        None => text.escape_debug().to_string(),
    }
}
