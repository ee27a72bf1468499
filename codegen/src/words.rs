//! Reserved words of languages, which generated names avoid. Names are made once for all languages, so they
//! are the same in each. A printer escapes further words that its language reserves.

use crate::steps::Step;

/// Strict and reserved keywords of Rust up to edition 2024.
const RUST_KEYWORDS: [&str; 52] = [
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// What C's structures are called behind a module's name: of parameters, of what is prepared from them, of sines and cosines.
pub(crate) const C_STRUCTURES: [&str; 3] = ["parameters", "prepared", "sines_cosines"];

pub(crate) const Q_PLUS: &str = "q_plus";
pub(crate) const Q_MINUS: &str = "q_minus";
pub(crate) const SCALE_QUATERNIONS: &str = "scale_quaternions";

/// True for what C may call of the runtime crate, behind a module's name.
pub(crate) fn is_c_runtime(name: &str) -> bool {
    let is_step = || Step::all().any(|step| step.name() == name);
    [Q_PLUS, Q_MINUS, SCALE_QUATERNIONS].contains(&name) || is_step()
}

/// The function of C that tells from which input a library was generated, behind a module's name.
pub(crate) const C_INPUT: &str = "input";

/// The crates that generated Rust names.
pub(crate) const RUST_CRATES: [&str; 2] = ["kane", "core"];

/// True for a keyword of Rust.
pub(crate) fn is_rust_keyword(word: &str) -> bool {
    RUST_KEYWORDS.contains(&word)
}
