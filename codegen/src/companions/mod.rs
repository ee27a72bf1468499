//! Files beside a module, for those who ask for them.
//!
//! In: a module ready to be emitted. Out: texts, each with its place beside the module. Afterwards: each begins with the sign
//! of its format, [`origin::SIGNS`](crate::origin::SIGNS), and follows from what the module follows from. Does not: change
//! the module's own text.

mod header;
mod json;
mod manifest;
mod parameters;
mod sample;
mod self_test;

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

pub use crate::options::companion::{Abi, Kind, can_be_beside};

use crate::{
    emit::{self, Module},
    error::Error,
    options::companion::beside,
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

/// The files of these kinds, beside the module `name`, or why one of them cannot be.
pub(crate) fn of(
    module: &Module<'_>,
    kinds: &BTreeSet<Kind>,
    name: &str,
) -> Result<Vec<Companion>, Error> {
    let mut companions = Vec::new();
    for kind in kinds {
        let texts = kind.endings().iter().zip(texts(*kind, module, name)?);
        companions.extend(texts.map(|(&ending, text)| Companion { ending, text }));
    }
    Ok(companions)
}

/// The texts of the files of one kind.
fn texts(kind: Kind, module: &Module<'_>, name: &str) -> Result<Vec<String>, Error> {
    Ok(match kind {
        Kind::Manifest => vec![manifest::text(module)],
        Kind::Tests => vec![self_test::text(module)?],
        Kind::Abi(Abi::C) => vec![emit::interface(module, name), header::text(module, name)],
    })
}
