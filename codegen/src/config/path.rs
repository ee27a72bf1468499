//! Paths, as a `kane.toml` writes them.

use std::path::{Component, Path, PathBuf};

use crate::{
    description::toml_reader::{Item, Reader},
    diagnostic::{Diagnostic, Escaped, Spanned},
};

/// A path that means the same on every machine: relative, and written with `/`.
pub(super) fn read(reader: &mut Reader, item: &Item<'_>, what: &str) -> Option<Spanned<String>> {
    let path = reader.string(item, what)?;
    let fault = if path.value.is_empty() {
        Some((format!("{what} is empty"), "expected a path"))
    } else if Path::new(&path.value).file_name().is_none() {
        Some((
            format!("{what} is `{}`, a folder", path.value.escaped()),
            "expected a file",
        ))
    } else if path.value.chars().any(char::is_control) {
        Some((
            format!("{what} holds a character that cannot be shown"),
            "expected printable characters",
        ))
    } else if path.value.contains('\\') {
        Some((
            format!("{what} holds a backslash; expected `/` between folders"),
            "backslash",
        ))
    } else if path.value.starts_with('/') || path.value.chars().nth(1) == Some(':') {
        Some((
            format!("{what} is an absolute path; expected one relative to this file"),
            "absolute path",
        ))
    } else {
        None
    };
    match fault {
        Some((fault, label)) => {
            reader
                .faults
                .push(Diagnostic::error(fault).at(path.span, label));
            None
        }
        None => Some(path),
    }
}

/// The path, where `.` and `folder/..` make no difference.
pub fn clean_path(path: &Path) -> PathBuf {
    let mut parts = Vec::new();
    for part in path.components() {
        match (part, parts.last()) {
            (Component::CurDir, _) | (Component::ParentDir, Some(Component::RootDir)) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.into_iter().collect()
}
