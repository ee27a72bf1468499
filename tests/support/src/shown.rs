//! What must not be shown.

/// True for what steers a terminal, or turns the direction of writing; lines may end.
pub fn steers(character: char) -> bool {
    character.is_control() && character != '\n'
        || matches!(character, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}
