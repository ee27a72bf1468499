//! What can stand beside a module, for those who ask for it: how its files are called, and what it asks of the module.
//!
//! Does not: write any of it; that is [`companions`](crate::companions).

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

use crate::{
    functions::{Function, Request},
    words::is_rust_keyword,
};

/// What can stand beside a module: a file, or several that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CompanionKind {
    /// What the module holds, for programs: sizes, names, functions with their operations.
    Manifest,
    /// Tests of the module.
    Tests,
    /// Its functions for programs in other languages.
    Abi(Abi),
}

/// How programs in other languages call functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Abi {
    /// As C does: `extern "C"` functions, and a header that declares them.
    C,
}

/// The functions by which the states of tests are scaled: where mass centres are, and what forces motions take.
pub(crate) const SCALES: [&str; 2] = ["mass_center_position", "inverse_dynamics"];

/// The ending of the header, the file of [`Abi::C`] that programs in C include.
pub const HEADER: &str = ".h";

/// What [`can_be_beside`] asks of a name.
pub const EXPECTED_NAME: &str = "expected ASCII letters, digits and `_`, a letter first, and no keyword of Rust or header of C; nor `kane` for C";

/// The headers of the C library, which a program that looks for headers in the module's folder would miss.
const C_HEADERS: [&str; 31] = [
    "assert",
    "complex",
    "ctype",
    "errno",
    "fenv",
    "float",
    "inttypes",
    "iso646",
    "limits",
    "locale",
    "math",
    "setjmp",
    "signal",
    "stdalign",
    "stdarg",
    "stdatomic",
    "stdbit",
    "stdbool",
    "stdckdint",
    "stddef",
    "stdint",
    "stdio",
    "stdlib",
    "stdnoreturn",
    "string",
    "tgmath",
    "threads",
    "time",
    "uchar",
    "wchar",
    "wctype",
];

impl Abi {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 1] = [("c", Self::C)];
}

impl CompanionKind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Manifest, Self::Tests, Self::Abi(Abi::C)];

    /// Those that a key of their own in `kane.toml` asks for, `true` or `false`.
    pub const SWITCHED: [(&str, Self); 2] = [("manifest", Self::Manifest), ("tests", Self::Tests)];

    /// The endings of its files.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Manifest => &[".json"],
            Self::Tests => &["_tests.rs"],
            Self::Abi(Abi::C) => &["_c.rs", HEADER],
        }
    }

    /// What asks for it in `kane.toml`.
    pub fn key(self) -> &'static str {
        match self {
            Self::Manifest => "manifest = true",
            Self::Tests => "tests = true",
            Self::Abi(Abi::C) => "abi = \"c\"",
        }
    }

    /// The paths of its files, where the module goes to `module`.
    pub fn beside(self, module: &Path) -> impl Iterator<Item = PathBuf> {
        self.endings().iter().map(|ending| beside(module, ending))
    }

    /// What is evaluated for it by the notes' equations, beside a module with these functions.
    pub(crate) fn evaluated(self, functions: &[Request]) -> Vec<Request> {
        match self {
            Self::Tests => {
                let scales = SCALES.iter().copied().filter_map(Function::find);
                let own = functions.iter().cloned();
                own.chain(scales.map(Request::from)).collect()
            }
            Self::Manifest | Self::Abi(_) => Vec::new(),
        }
    }

    /// True where its files name the module.
    fn names_module(self) -> bool {
        matches!(self, Self::Tests | Self::Abi(_))
    }
}

/// The path of a file with this ending, where the module goes to `module`.
pub(crate) fn beside(module: &Path, ending: &str) -> PathBuf {
    let mut name = module.file_stem().unwrap_or_default().to_owned();
    name.push(ending);
    module.with_file_name(name)
}

/// True where files of these kinds can stand beside a module of this name.
pub fn can_be_beside(kinds: &BTreeSet<CompanionKind>, name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    // What several headers share begins with `kane`.
    let is_taken = C_HEADERS.contains(&&*lower) || lower == "kane";
    let is_taken = is_taken && kinds.contains(&CompanionKind::Abi(Abi::C));
    !kinds.iter().any(|kind| kind.names_module()) || is_name(name) && !is_taken
}

/// True for a name that a module of Rust can have, and with which names in C can begin.
fn is_name(name: &str) -> bool {
    let is_of_name = |character: char| character.is_ascii_alphanumeric() || character == '_';
    name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.chars().all(is_of_name)
        && !is_rust_keyword(name)
}
