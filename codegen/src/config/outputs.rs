//! The files that systems write: under names that all of them can have, and no file twice.

use std::{
    collections::{BTreeMap, BTreeSet},
    ffi::OsStr,
    path::{Path, PathBuf},
};

use crate::{
    description::toml_reader::{Reader, Table},
    diagnostic::{Diagnostic, Spanned},
    options::companion::{self, CompanionKind},
};

use super::path;

/// What one system writes.
pub(super) struct Output {
    /// The path of its module.
    pub(super) module: Spanned<String>,
    /// The module's name.
    pub(super) name: String,
    /// The module and what is beside it.
    files: Vec<PathBuf>,
}

/// Reads `output` of a system.
pub(super) fn module(reader: &mut Reader, system: &Table<'_, '_>) -> Option<Spanned<String>> {
    let item = reader.required(system, "output", "output = \"generated/pendulum.rs\"")?;
    let what = system.what("output");
    let module = path::read(reader, item, &what)?;
    if Path::new(&module.value).extension() != Some(OsStr::new("rs")) {
        let fault = format!(
            "{what} is `{}`; expected a file that ends in `.rs`",
            module.value
        );
        let fault = Diagnostic::error(fault);
        reader.faults.push(fault.at(module.span, "no Rust file"));
    }
    Some(module)
}

impl Output {
    /// What is written where the module goes there and these are beside it; refuses a name that one of them cannot have.
    pub(super) fn new(
        reader: &mut Reader,
        system: &Table<'_, '_>,
        module: Spanned<String>,
        companions: &BTreeSet<CompanionKind>,
    ) -> Self {
        let path = Path::new(&module.value);
        let name = path.file_stem().unwrap_or_default();
        let name = name.to_string_lossy().into_owned();
        if !companion::can_be_beside(companions, &name) {
            let fault = Diagnostic::error(format!(
                "{} is `{}`; the files beside the module contain its name",
                system.what("output"),
                module.value
            ));
            reader.faults.push(
                fault
                    .at(module.span, "no name that C and Rust can have")
                    .help(companion::EXPECTED_NAME),
            );
        }
        let beside = companions.iter().flat_map(|kind| kind.beside(path));
        let files = std::iter::once(path.to_owned()).chain(beside).collect();
        Self {
            module,
            name,
            files,
        }
    }
}

/// Two systems that write one file would each undo the other.
pub(super) fn check(reader: &mut Reader, outputs: &[Output]) {
    let mut first: BTreeMap<PathBuf, &Spanned<String>> = BTreeMap::new();
    for Output { module, files, .. } in outputs {
        let known = |file: &PathBuf| Some((file.clone(), *first.get(&path::clean_path(file))?));
        if let Some((file, first)) = files.iter().find_map(known) {
            let fault = Diagnostic::error(format!("two systems write `{}`", file.display()));
            reader.faults.push(
                fault
                    .at(module.span, "the second one")
                    .at(first.span, "the first one"),
            );
        }
        first.extend(files.iter().map(|file| (path::clean_path(file), module)));
    }
}
