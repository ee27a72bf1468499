//! Tests among sources, of which the library's own are not compiled.

use proc_macro2::{TokenStream, TokenTree};

use crate::{imports::QUOTES, walk::Sources};

/// How many there are in each file that has any, a line each; text of generated programs is none.
pub(crate) fn found(sources: &Sources) -> Vec<String> {
    let mut found = Vec::new();
    for (file, text) in &sources.0 {
        let tokens: TokenStream = text.parse().unwrap_or_else(|e| panic!("{file}: {e}"));
        let count = count(tokens);
        if count > 0 {
            found.push(format!("{file}: {count}"));
        }
    }
    found
}

/// How many attributes say that what follows is a test, or compiled for tests alone.
fn count(tokens: TokenStream) -> usize {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut count = 0;
    for (place, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        let before = tokens[place.saturating_sub(2)..place].iter();
        let before: Vec<String> = before.map(ToString::to_string).collect();
        count += match &before[..] {
            [quote, bang] if bang == "!" && QUOTES.contains(&&**quote) => 0,
            [hash, bang] if hash == "#" && bang == "!" => usize::from(is_test(&group.stream())),
            [.., hash] if hash == "#" => usize::from(is_test(&group.stream())),
            _ => self::count(group.stream()),
        };
    }
    count
}

/// Whether an attribute is `test`, or `cfg` of something with `test` in it.
fn is_test(attribute: &TokenStream) -> bool {
    let words = attribute.to_string();
    let mut words = words.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    match words.next() {
        Some("test") => true,
        Some("cfg") => words.any(|word| word == "test"),
        _ => false,
    }
}
