//! Where a module goes.

use std::{
    fmt,
    path::{Path, PathBuf},
};

use crate::cli::paths;

/// Where a module goes.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// Standard output.
    StandardOutput,
    /// A file, to open and to show.
    File(PathBuf),
}

impl Target {
    /// What `--output` means.
    pub(crate) fn new(output: &Path) -> Self {
        if output == Path::new("-") {
            Self::StandardOutput
        } else {
            Self::File(output.to_owned())
        }
    }

    /// The module's name: that of its file, without the ending.
    pub(crate) fn module(&self) -> String {
        match self {
            Self::StandardOutput => String::new(),
            Self::File(module) => {
                let name = module.file_stem().unwrap_or_default();
                name.to_string_lossy().into_owned()
            }
        }
    }

    /// True where the target is the file to which `path` leads.
    pub(crate) fn is_same_file(&self, path: &Path) -> bool {
        match self {
            Self::StandardOutput => false,
            Self::File(file) => {
                let places = [file, path].map(|file| paths::place(file).ok());
                file == path || places[0].is_some() && places[0] == places[1]
            }
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StandardOutput => f.write_str("standard output"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}
