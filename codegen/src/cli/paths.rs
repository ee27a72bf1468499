//! Where files stand, relative to one another.
//!
//! Paths are shown, and opened, as the user wrote them or relative to the current folder; what reaches a generated file is
//! relative to `kane.toml`.

use std::{
    fs,
    path::{Component, Path, PathBuf},
};

use kane_codegen::{config::clean_path, error::Error};

/// The name of the file that lists a repository's systems.
pub(crate) const CONFIG: &str = "kane.toml";

/// The folder or file that the path leads to, absolute, without links and `..`.
pub(crate) fn target(path: &Path) -> Result<PathBuf, Error> {
    fs::canonicalize(path).map_err(|source| Error::Io {
        path: path.to_owned(),
        source,
    })
}

/// The current folder.
pub(crate) fn here() -> Result<PathBuf, Error> {
    target(Path::new("."))
}

/// Where a folder will stand that is not there yet, absolute, without links.
pub(crate) fn of_new(folder: &Path) -> Result<PathBuf, Error> {
    let above = folder.ancestors().find(|above| above.is_dir());
    let above = above.unwrap_or(Path::new(""));
    let rest = folder.strip_prefix(above).unwrap_or(folder);
    Ok(target(&here()?.join(above))?.join(rest))
}

/// Where a file stands or will stand, absolute, without links to its folder.
pub(crate) fn place(file: &Path) -> Result<PathBuf, Error> {
    Ok(of_new(parent(file))?.join(file.file_name().unwrap_or_default()))
}

/// The folder of the file, as written; the current folder is `.`.
pub(crate) fn parent(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// The `kane.toml` in this folder or the nearest above.
pub(crate) fn config_above(folder: &Path) -> Option<PathBuf> {
    let mut files = folder.ancestors().map(|folder| folder.join(CONFIG));
    files.find(|file| file.is_file())
}

/// The path from one folder to a file or folder; both are absolute. `None` where no way leads there, as between two
/// drives.
pub(crate) fn relative(from: &Path, to: &Path) -> Option<PathBuf> {
    let [from, to] = [from, to].map(clean_path);
    let [from, to] = [&from, &to].map(|path| path.components().collect::<Vec<_>>());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = from[common..].iter().map(|_| Component::ParentDir);
    let down = to[common..].iter().copied();
    (common > 0).then(|| up.chain(down).collect())
}

/// The path from the current folder to `to`, which is absolute; the path itself where no way leads there.
pub(crate) fn shown(to: &Path) -> Result<PathBuf, Error> {
    Ok(relative(&here()?, to).unwrap_or_else(|| to.to_owned()))
}

/// The path with `/` between folders; `None` where it holds what cannot be shown.
pub(crate) fn with_slashes(path: &Path) -> Option<String> {
    let parts: Option<Vec<&str>> = path.iter().map(|part| part.to_str()).collect();
    let text = parts?.join("/");
    (!text.is_empty() && !text.chars().any(char::is_control)).then_some(text)
}
