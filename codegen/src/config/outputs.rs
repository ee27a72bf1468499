//! The files that systems write: under names that all of them can have, and no file twice.

use std::{
    collections::{BTreeMap, BTreeSet},
    ffi::OsStr,
    path::{Path, PathBuf},
};

use crate::{
    description::toml_reader::{Reader, Table},
    diagnostic::{Diagnostic, Spanned},
    options::companion::{self, Abi, CompanionKind},
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
    /// True where programs in C call its functions.
    is_for_c: bool,
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
            is_for_c: companions.contains(&CompanionKind::Abi(Abi::C)),
        }
    }
}

/// Two systems that write one file would each undo the other, and two modules of one name are one to C.
pub(super) fn check(reader: &mut Reader, outputs: &[Output]) {
    let mut first: BTreeMap<String, (&PathBuf, &Spanned<String>)> = BTreeMap::new();
    for Output { module, files, .. } in outputs {
        let known = files
            .iter()
            .find_map(|file| Some((file, *first.get(&place(file))?)));
        if let Some((file, (other, first))) = known {
            let [shown, other] = [file, other].map(|file| path::clean_path(file));
            let fault = if shown == other {
                format!("two systems write `{}`", file.display())
            } else {
                format!(
                    "two systems write `{}` and `{}`, one file where the case of letters does not count",
                    other.display(),
                    file.display()
                )
            };
            push(reader, fault, [first, module]);
        }
        first.extend(files.iter().map(|file| (place(file), (file, module))));
    }
    let mut first: BTreeMap<String, &Spanned<String>> = BTreeMap::new();
    for output in outputs.iter().filter(|output| output.is_for_c) {
        let name = output.name.to_ascii_lowercase();
        if let Some(first) = first.get(&name) {
            let fault = format!(
                "two systems with `abi = \"c\"` have modules called `{}`: functions in C begin with that name",
                output.name
            );
            push(reader, fault, [*first, &output.module]);
        }
        first.entry(name).or_insert(&output.module);
    }
}

/// A file's place, where the case of letters does not count.
fn place(file: &Path) -> String {
    path::clean_path(file).to_string_lossy().to_lowercase()
}

fn push(reader: &mut Reader, fault: String, [first, second]: [&Spanned<String>; 2]) {
    let fault = Diagnostic::error(fault);
    reader.faults.push(
        fault
            .at(second.span, "the second one")
            .at(first.span, "the first one"),
    );
}
