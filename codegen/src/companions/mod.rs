//! Files beside a module, for those who ask for them.
//!
//! In: a module ready to be emitted. Out: texts, each with its place beside the module. Afterwards: each begins with the sign
//! of its format, [`origin::SIGNS`](crate::origin::SIGNS), and follows from what the module follows from. Does not: change
//! the module's own text.

mod json;
mod manifest;
mod self_test;

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

use crate::emit::Module;

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
}

impl Companion {
    /// Its path, where the module goes to `module`.
    pub fn beside(&self, module: &Path) -> PathBuf {
        beside(module, self.ending)
    }
}

impl Kind {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 2] = [("manifest", Self::Manifest), ("tests", Self::Tests)];

    /// The endings of its files.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Manifest => &[".json"],
            Self::Tests => &["_tests.rs"],
        }
    }

    /// The paths of its files, where the module goes to `module`.
    pub fn beside(self, module: &Path) -> impl Iterator<Item = PathBuf> {
        self.endings().iter().map(|ending| beside(module, ending))
    }

    fn texts(self, module: &Module<'_>) -> Vec<String> {
        match self {
            Self::Manifest => vec![manifest::text(module)],
            Self::Tests => vec![self_test::text(module)],
        }
    }
}

/// The files of these kinds.
pub(crate) fn of(module: &Module<'_>, kinds: &BTreeSet<Kind>) -> Vec<Companion> {
    let companions = kinds.iter().flat_map(|kind| {
        let texts = kind.texts(module).into_iter();
        kind.endings().iter().zip(texts)
    });
    companions
        .map(|(&ending, text)| Companion { ending, text })
        .collect()
}

fn beside(module: &Path, ending: &str) -> PathBuf {
    let mut name = module.file_stem().unwrap_or_default().to_owned();
    name.push(ending);
    module.with_file_name(name)
}
