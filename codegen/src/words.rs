//! Reserved words of languages, which generated names avoid. Names are made once for all languages, so they
//! are the same in each. A printer escapes further words that its language reserves.

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
/// Under which conditions C steps: as the word before a step's name, `""` for none.
pub(crate) const STEP_CONDITIONS: [&str; 3] = ["", "loaded_", "driven_"];
/// What is in the middle of a step's name: the module of `kane::discrete`.
pub(crate) const STEP_SCHEMES: [&str; 2] = ["euler", "rk4"];
/// What a step's name ends with: the function of that module.
pub(crate) const STEP_WAYS: [&str; 7] = [
    "step",
    "linearized",
    "forward",
    "adjoint",
    "by_parameters",
    "forward_with_parameters",
    "adjoint_with_parameters",
];

/// True for what C may call of the runtime crate, behind a module's name.
pub(crate) fn is_c_runtime(name: &str) -> bool {
    let is_step = |name: &str| {
        let behind = |scheme: &&str| name.strip_prefix(*scheme)?.strip_prefix('_');
        let way = STEP_SCHEMES.iter().find_map(behind);
        way.is_some_and(|way| STEP_WAYS.contains(&way))
    };
    let unconditional = STEP_CONDITIONS.iter();
    [Q_PLUS, Q_MINUS, SCALE_QUATERNIONS].contains(&name)
        || unconditional
            .filter_map(|condition| name.strip_prefix(condition))
            .any(is_step)
}

/// The function of C that tells from which input a library was generated, behind a module's name.
pub(crate) const C_INPUT: &str = "input";

/// The crates that generated Rust names.
pub(crate) const RUST_CRATES: [&str; 2] = ["kane", "core"];

/// True for a keyword of Rust.
pub(crate) fn is_rust_keyword(word: &str) -> bool {
    RUST_KEYWORDS.contains(&word)
}
