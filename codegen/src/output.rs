//! Writing a file: whole or not at all, and never over a file that is not ours.

use std::{
    collections::BTreeSet,
    fs::{self, File},
    io::{self, Write as _},
    path::{Path, PathBuf},
};

use crate::{error::Error, input, limits::OUTPUT_BYTES, origin, ownership};

/// How the names of files begin and end that are not whole yet.
const PREFIX: &str = ".kane-generate-";
const SUFFIX: &str = ".tmp";

/// Which files may be overwritten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overwrite {
    /// None.
    Nothing,
    /// Only files that begin with our sign.
    Generated,
    /// Of these only those whose banner names the same model.
    OfModel,
    /// Any file.
    Anything,
}

/// A text that lies beside the file it will replace, so that of several files all can be replaced or none.
#[derive(Debug)]
pub struct Staged {
    path: PathBuf,
    /// `None` where the file holds the text already: it is left alone, so that nothing is compiled again for it.
    file: Option<tempfile::NamedTempFile>,
    /// The format of the file that it will replace, where that is newer than ours.
    newer: Option<u32>,
}

impl Staged {
    /// True where the file holds the text already.
    pub fn is_up_to_date(&self) -> bool {
        self.file.is_none()
    }

    /// The format of the file that it will replace, where a newer generator wrote that.
    pub fn replaces_newer(&self) -> Option<u32> {
        self.newer
    }

    /// Replaces the file, atomically.
    ///
    /// # Errors
    /// [`Error::Io`]. The old file is then as it was.
    pub fn commit(self) -> Result<(), Error> {
        let Self { path, file, .. } = self;
        let renamed = file.map_or(Ok(()), |file| file.persist(&path).map(drop));
        renamed.map_err(|error| Error::Io {
            path,
            source: error.error,
        })
    }
}

/// Replaces files by their texts, all or none as far as it can be known before; folders that are missing are made. A file
/// that holds its text already is left alone.
///
/// # Errors
/// [`Error::NotGenerated`], [`Error::OtherModel`], [`Error::Exists`] or [`Error::Link`] where a file may not be overwritten; [`Error::OutputTooLarge`]; [`Error::Io`].
pub fn write(files: &[(PathBuf, &str)], overwrite: Overwrite) -> Result<(), Error> {
    let staged = files.iter();
    let staged = staged.map(|(path, text)| stage(path, text, overwrite));
    let staged: Vec<Staged> = staged.collect::<Result<_, Error>>()?;
    staged.into_iter().try_for_each(Staged::commit)?;
    sweep(files.iter().map(|(path, _)| path.as_path()));
    Ok(())
}

/// Writes `text` beside the file at `path`, which stays as it is; folders that are missing are made.
///
/// # Errors
/// As of [`write()`].
pub fn stage(path: &Path, text: &str, overwrite: Overwrite) -> Result<Staged, Error> {
    let io = |source| Error::Io {
        path: path.to_owned(),
        source,
    };
    let staged = |file, newer| Staged {
        path: path.to_owned(),
        file,
        newer,
    };
    if text.len() > OUTPUT_BYTES {
        return Err(Error::OutputTooLarge {
            path: path.to_owned(),
            bytes: text.len(),
        });
    }
    // A rename would replace the link, and what it leads to would stay as it was.
    if overwrite != Overwrite::Anything && path.is_symlink() {
        return Err(Error::Link {
            path: path.to_owned(),
        });
    }
    let old = read(path)?;
    let newer = old.as_deref().and_then(newer_format);
    match old {
        Some(old) if old == text.as_bytes() => return Ok(staged(None, None)),
        Some(_) if overwrite == Overwrite::Nothing => {
            return Err(Error::Exists {
                path: path.to_owned(),
            });
        }
        Some(old) if overwrite != Overwrite::Anything && !ownership::is_ours(&old) => {
            return Err(Error::NotGenerated {
                path: path.to_owned(),
            });
        }
        Some(old) if overwrite == Overwrite::OfModel => {
            let models = [&old, text.as_bytes()].map(origin::model_of);
            if let [Some(model), Some(own)] = models
                && model != own
            {
                return Err(Error::OtherModel {
                    path: path.to_owned(),
                    model,
                });
            }
        }
        _ => {}
    }
    let folder = folder(path);
    fs::create_dir_all(folder).map_err(io)?;
    // What is there for a moment only has a name that says nothing to the user.
    let mut file = temporary(folder).map_err(|error| io(error.kind().into()))?;
    // Before anything is in it that others may not read.
    keep_permissions(path, file.path()).map_err(io)?;
    file.write_all(text.as_bytes()).map_err(io)?;
    file.as_file().sync_all().map_err(io)?;
    Ok(staged(Some(file), newer))
}

/// The format of a text that a newer generator wrote.
fn newer_format(text: &[u8]) -> Option<u32> {
    let format = origin::format_of(&String::from_utf8_lossy(text))?;
    (format > origin::OUTPUT_FORMAT).then_some(format)
}

fn folder(path: &Path) -> &Path {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    folder.unwrap_or(Path::new("."))
}

/// A file beside others, locked as long as somebody writes it.
fn temporary(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    loop {
        let mut builder = tempfile::Builder::new();
        as_any_other(&mut builder);
        let file = builder.prefix(PREFIX).suffix(SUFFIX).tempfile_in(folder)?;
        // Before it was locked, another process may have swept it away.
        if file.as_file().lock().is_err() || file.path().exists() {
            return Ok(file);
        }
    }
}

/// Removes what runs that were killed have left beside these files. What cannot be removed stays: it harms nobody.
pub fn sweep<'a>(files: impl Iterator<Item = &'a Path>) {
    let folders: BTreeSet<&Path> = files.map(folder).collect();
    let entries = folders
        .into_iter()
        .filter_map(|folder| fs::read_dir(folder).ok());
    for entry in entries.flatten().filter_map(Result::ok) {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(PREFIX)
            && name.ends_with(SUFFIX)
            // A pipe could keep us waiting.
            && entry.file_type().is_ok_and(|kind| kind.is_file())
            && let Ok(file) = File::open(entry.path())
            // Locked until it is removed, or who waits for the lock would find it still there.
            && file.try_lock().is_ok()
        {
            drop(fs::remove_file(entry.path()));
        }
    }
}

/// The bytes of a file; `None` where there is none.
///
/// # Errors
/// [`Error::Io`] where there is one that cannot be read.
pub fn read(path: &Path) -> Result<Option<Vec<u8>>, Error> {
    match input::bytes(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(Error::Io {
            path: path.to_owned(),
            source,
        }),
    }
}

/// A temporary file is private to its user; a source file is as readable as whoever writes it wants all new files to be.
#[cfg(unix)]
fn as_any_other(builder: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt as _;

    builder.permissions(fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn as_any_other(_builder: &mut tempfile::Builder<'_, '_>) {}

/// A file is as readable as the one that it replaces.
#[cfg(unix)]
fn keep_permissions(old: &Path, new: &Path) -> io::Result<()> {
    fs::metadata(old).map_or(Ok(()), |old| fs::set_permissions(new, old.permissions()))
}

#[cfg(not(unix))]
fn keep_permissions(_old: &Path, _new: &Path) -> io::Result<()> {
    Ok(())
}
