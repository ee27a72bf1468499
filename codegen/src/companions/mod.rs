//! Files beside a module, for those who ask for them.
//!
//! In: a module ready to be emitted. Out: texts, each with its place beside the module. Afterwards: each begins with the sign
//! of its format, [`origin::SIGNS`](crate::origin::SIGNS), and follows from what the module follows from. Does not: change
//! the module's own text.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

use crate::{
    compile::Compiled,
    error::Error,
    functions::{Function, Request},
    listing::Module,
    printers::{c, json, rust},
    samples::{self, SCALES},
    tree::Tree,
    words::is_rust_keyword,
};

/// A file beside a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Companion {
    /// What follows the module's stem in its name: `.json` for `panda.json` beside `panda.rs`.
    pub ending: &'static str,
    /// Its text.
    pub text: String,
}

/// What can stand beside a module: a file, or several that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
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

impl Abi {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 1] = [("c", Self::C)];
}

impl Companion {
    /// Its path, where the module goes to `module`.
    pub fn beside(&self, module: &Path) -> PathBuf {
        beside(module, self.ending)
    }
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Manifest, Self::Tests, Self::Abi(Abi::C)];

    /// The endings of its files.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Manifest => &[".json"],
            Self::Tests => &["_tests.rs"],
            Self::Abi(Abi::C) => &["_c.rs", ".h"],
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

    /// True where its files know the module by its name, with which names in C begin.
    fn names_module(self) -> bool {
        matches!(self, Self::Abi(_))
    }

    fn texts(self, given: &Given<'_>, name: &str) -> Result<Vec<String>, Error> {
        let module = given.module;
        Ok(match self {
            Self::Manifest => vec![json::manifest(module)],
            Self::Tests => {
                let (samples, values) = samples::of(given.tree, given.compiled, module)?;
                vec![rust::self_tests(module, &samples, &values)]
            }
            Self::Abi(Abi::C) => vec![rust::interface(module, name), c::header(module, name)],
        })
    }
}

/// What files are made from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'a> {
    /// The system.
    pub(crate) tree: &'a Tree,
    /// Its programs.
    pub(crate) compiled: &'a Compiled,
    /// Its module.
    pub(crate) module: &'a Module,
}

/// What [`can_be_beside`] asks of a name.
pub const EXPECTED_NAME: &str =
    "expected ASCII letters, digits and `_`, a letter first, and no keyword of Rust";

/// True where files of these kinds can stand beside a module of this name.
pub fn can_be_beside(kinds: &BTreeSet<Kind>, name: &str) -> bool {
    !kinds.iter().any(|kind| kind.names_module()) || is_of_c(name)
}

/// True for a name with which those in C can begin.
fn is_of_c(name: &str) -> bool {
    let is_of_name = |character: char| character.is_ascii_alphanumeric() || character == '_';
    name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.chars().all(is_of_name)
        && !is_rust_keyword(name)
}

/// The files of these kinds, beside the module `name`, or why one of them cannot be.
pub(crate) fn of(
    given: &Given<'_>,
    kinds: &BTreeSet<Kind>,
    name: &str,
) -> Result<Vec<Companion>, Error> {
    let mut companions = Vec::new();
    for kind in kinds {
        let texts = kind.endings().iter().zip(kind.texts(given, name)?);
        companions.extend(texts.map(|(&ending, text)| Companion { ending, text }));
    }
    Ok(companions)
}

fn beside(module: &Path, ending: &str) -> PathBuf {
    let mut name = module.file_stem().unwrap_or_default().to_owned();
    name.push(ending);
    module.with_file_name(name)
}
