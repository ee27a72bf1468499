//! Files beside a module, for those who ask for them.
//!
//! In: a module ready to be emitted. Out: texts, each with its place beside the module. Afterwards: each begins with the sign
//! of its format, [`SIGNS`](crate::ownership::SIGNS), and follows from what the module follows from. Does not: change
//! the module's own text.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

pub use crate::options::companion::{Abi, CompanionKind, HEADER, can_be_beside};

use crate::{
    compile::Compiled,
    error::Error,
    listing::Module,
    options::companion::beside,
    printers::{c, json, rust},
    samples,
    tree::Tree,
};

/// A file beside a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Companion {
    /// What follows the module's stem in its name: `.json` for `panda.json` beside `panda.rs`.
    pub ending: &'static str,
    /// Its text.
    pub text: String,
}

impl Companion {
    /// Its path, where the module goes to `module`.
    pub fn beside(&self, module: &Path) -> PathBuf {
        beside(module, self.ending)
    }
}

/// What files are made from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ingredients<'a> {
    /// The system.
    pub(crate) tree: &'a Tree,
    /// Its programs.
    pub(crate) compiled: &'a Compiled,
    /// Its module.
    pub(crate) module: &'a Module,
}

/// The files of these kinds, beside the module `name`, or why one of them cannot be.
pub(crate) fn of(
    given: &Ingredients<'_>,
    kinds: &BTreeSet<CompanionKind>,
    name: &str,
) -> Result<Vec<Companion>, Error> {
    let mut companions = Vec::new();
    let prefix = kinds.contains(&CompanionKind::Abi(Abi::C)).then_some(name);
    for kind in kinds {
        let texts = texts(*kind, given, name, prefix)?;
        let texts = kind.endings().iter().zip(texts);
        companions.extend(texts.map(|(&ending, text)| Companion { ending, text }));
    }
    Ok(companions)
}

/// The texts of the files of one kind; `prefix` is what names in C begin with, if functions can be called from there.
fn texts(
    kind: CompanionKind,
    given: &Ingredients<'_>,
    name: &str,
    prefix: Option<&str>,
) -> Result<Vec<String>, Error> {
    let module = given.module;
    Ok(match kind {
        CompanionKind::Manifest => vec![json::manifest(module, prefix)],
        CompanionKind::Tests => {
            let (samples, values) = samples::of(given.tree, given.compiled, module)?;
            vec![rust::self_tests(module, name, &samples, &values)]
        }
        CompanionKind::Abi(Abi::C) => vec![rust::interface(module, name), c::header(module, name)],
    })
}
