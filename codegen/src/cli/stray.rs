//! Files that nothing in `kane.toml` produces.
//!
//! A folder named `generated` holds nothing but what is generated, so every file below it counts, but for `mod.rs`, which may
//! declare modules, and hidden files. Other folders may hold what people wrote beside what we wrote: there the file's
//! beginning tells.

use std::{
    collections::{BTreeMap, BTreeSet},
    ffi::OsStr,
    fs::{self, File},
    io::{self, Read},
    path::{Path, PathBuf},
};

use kane_codegen::{companions::CompanionKind, config::clean_path, error::Error, ownership};

use crate::cli::{Failures, job::Job, paths, target::Target};

/// Which files of a folder nothing may have produced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FolderKind {
    /// Nothing but what is generated, folders within included.
    Generated,
    /// What is generated, and other files.
    Mixed,
}

/// The files that no job writes in folders where jobs write, in order; `root` is the folder of `kane.toml`.
pub(crate) fn find(jobs: &[Job], root: &Path) -> Result<Vec<PathBuf>, Failures> {
    let mut produced = BTreeSet::new();
    let mut folders = BTreeMap::new();
    for job in jobs {
        for path in job.files() {
            produced.insert(clean_path(&path));
            let (folder, kind) = folder(&path, root);
            folders.insert(folder, kind);
        }
    }
    let (mut strays, mut failures) = (BTreeSet::new(), Failures::default());
    for (folder, kind) in folders {
        failures.keep(visit(&folder, kind, &produced, &mut strays));
    }
    failures.none()?;
    Ok(strays.into_iter().collect())
}

/// Files beside the modules of jobs that we wrote and that no job writes now, each with what would ask for it.
pub(crate) fn beside(jobs: &[Job]) -> Result<Vec<(PathBuf, String)>, Failures> {
    let produced: BTreeSet<PathBuf> = jobs.iter().flat_map(Job::files).collect();
    let mut found = Vec::new();
    for job in jobs {
        let Target::File(module) = &job.target else {
            continue;
        };
        for kind in CompanionKind::ALL {
            for path in kind.beside(module).filter(|path| !produced.contains(path)) {
                let io = |source| Error::Io {
                    path: path.clone(),
                    source,
                };
                if path.is_file() && is_ours(&path).map_err(io)? {
                    found.push((path, job.asks_by(kind)));
                }
            }
        }
    }
    Ok(found)
}

/// The outermost folder named `generated` between `root` and the file, else the file's own folder.
fn folder(file: &Path, root: &Path) -> (PathBuf, FolderKind) {
    let own = paths::parent(file);
    let below_root = own.strip_prefix(root).unwrap_or(own);
    let is_generated = |folder: &&Path| folder.file_name() == Some(OsStr::new("generated"));
    match below_root.ancestors().filter(is_generated).last() {
        Some(folder) => (clean_path(&root.join(folder)), FolderKind::Generated),
        None => (clean_path(own), FolderKind::Mixed),
    }
}

fn visit(
    folder: &Path,
    kind: FolderKind,
    produced: &BTreeSet<PathBuf>,
    strays: &mut BTreeSet<PathBuf>,
) -> Result<(), Error> {
    let io = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::Io { path, source }
    };
    let opened = if folder == Path::new("") {
        Path::new(".")
    } else {
        folder
    };
    let entries = match fs::read_dir(opened) {
        // Its files are missing, and reported as such.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(io(opened))?,
    };
    for entry in entries {
        let entry = entry.map_err(io(opened))?;
        let path = folder.join(entry.file_name());
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        let file_type = entry.file_type().map_err(io(&path))?;
        if is_hidden || produced.contains(&path) {
            continue;
        }
        let is_stray = match kind {
            FolderKind::Generated if file_type.is_dir() => {
                visit(&path, kind, produced, strays)?;
                false
            }
            FolderKind::Generated => {
                entry.file_name() != "mod.rs"
                    || path.is_file() && is_ours(&path).map_err(io(&path))?
            }
            FolderKind::Mixed => file_type.is_file() && is_ours(&path).map_err(io(&path))?,
        };
        if is_stray {
            strays.insert(path);
        }
    }
    Ok(())
}

fn is_ours(path: &Path) -> io::Result<bool> {
    let mut start = Vec::new();
    File::open(path)?
        .take(ownership::SIGN_BYTES)
        .read_to_end(&mut start)?;
    Ok(ownership::is_ours(&start))
}
