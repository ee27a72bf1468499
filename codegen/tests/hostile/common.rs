//! Models of this repository, and what is said of texts.

use std::{
    fs,
    path::{Path, PathBuf},
};

use kane_codegen::{
    companions::CompanionKind,
    config::Functions,
    description::{self, Reading, no_includes},
    diagnostic::Source,
    options::Options,
    tree,
};

/// Everything, with all that can stand beside a module.
pub(crate) fn everything() -> Options {
    Options {
        functions: Functions::All(Vec::new()),
        companions: CompanionKind::ALL.into(),
        module: "hostile".to_owned(),
        ..Options::default()
    }
}

pub(crate) fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The files of a folder and of those in it with this ending, with their names.
pub(crate) fn files(path: &str, ending: &str) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut folders = vec![folder(path)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if name.ends_with(ending) {
                let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
                files.push((name, text));
            }
        }
    }
    files.sort();
    files
}

/// As many texts, one after the other.
pub(crate) fn numbered(count: usize, one: impl Fn(usize) -> String) -> String {
    (0..count).map(one).collect()
}

/// What is wrong with a model.
pub(crate) fn faults(name: &str, text: &str) -> String {
    let source = Source::new(name, text);
    let description = description::read(&source, &Reading::default(), &no_includes);
    tree::build(&description).unwrap_err().to_string()
}
