//! Words that a language has for itself, of which generated names keep clear. Names are made once for all languages; these words
//! are avoided where they are made, so that they read the same in all. What others reserve, their printers escape.

/// Strict and reserved keywords of Rust up to edition 2024.
const RUST_KEYWORDS: [&str; 51] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// The crates that generated Rust names.
pub(crate) const RUST_CRATES: [&str; 2] = ["kane", "core"];

/// True for a keyword of Rust.
pub(crate) fn is_rust_keyword(word: &str) -> bool {
    RUST_KEYWORDS.contains(&word)
}
