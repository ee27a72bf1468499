//! Writing a file: whole or not at all, and never over a file that is not ours.

use std::{
    fs,
    io::{self, Write as _},
    path::{Path, PathBuf},
};

use crate::{error::Error, origin};

/// Which files may be overwritten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overwrite {
    /// None.
    Nothing,
    /// Only files that begin with our sign.
    Generated,
    /// Any file.
    Anything,
}

/// A text that lies beside the file it will replace, so that of several files all can be replaced or none.
#[derive(Debug)]
pub struct Staged {
    path: PathBuf,
    /// `None` where the file holds the text already: it is left alone, so that nothing is compiled again for it.
    file: Option<tempfile::NamedTempFile>,
}

impl Staged {
    /// True where the file holds the text already.
    pub fn is_up_to_date(&self) -> bool {
        self.file.is_none()
    }

    /// Replaces the file, atomically.
    ///
    /// # Errors
    /// [`Error::Io`]. The old file is then as it was.
    pub fn commit(self) -> Result<(), Error> {
        let Self { path, file } = self;
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
/// [`Error::NotGenerated`] or [`Error::Exists`] where a file may not be overwritten; [`Error::Io`].
pub fn write(files: &[(PathBuf, &str)], overwrite: Overwrite) -> Result<(), Error> {
    let staged = files.iter();
    let staged = staged.map(|(path, text)| stage(path, text, overwrite));
    let staged: Vec<Staged> = staged.collect::<Result<_, Error>>()?;
    staged.into_iter().try_for_each(Staged::commit)
}

/// Writes `text` beside the file at `path`, which stays as it is; folders that are missing are made.
///
/// # Errors
/// [`Error::NotGenerated`] or [`Error::Exists`] where the file may not be overwritten; [`Error::Io`].
pub fn stage(path: &Path, text: &str, overwrite: Overwrite) -> Result<Staged, Error> {
    let io = |source| Error::Io {
        path: path.to_owned(),
        source,
    };
    let staged = |file| Staged {
        path: path.to_owned(),
        file,
    };
    match read(path)? {
        Some(old) if old == text.as_bytes() => return Ok(staged(None)),
        Some(_) if overwrite == Overwrite::Nothing => {
            return Err(Error::Exists {
                path: path.to_owned(),
            });
        }
        Some(old) if overwrite == Overwrite::Generated && !origin::is_ours(&old) => {
            return Err(Error::NotGenerated {
                path: path.to_owned(),
            });
        }
        _ => {}
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    };
    fs::create_dir_all(&folder).map_err(io)?;
    let mut file = tempfile::Builder::new()
        .prefix(".kane-")
        .tempfile_in(&folder)
        .map_err(io)?;
    file.write_all(text.as_bytes()).map_err(io)?;
    file.as_file().sync_all().map_err(io)?;
    set_permissions(path, file.path()).map_err(io)?;
    Ok(staged(Some(file)))
}

/// The bytes of a file; `None` where there is none.
///
/// # Errors
/// [`Error::Io`] where there is one that cannot be read.
pub fn read(path: &Path) -> Result<Option<Vec<u8>>, Error> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(Error::Io {
            path: path.to_owned(),
            source,
        }),
    }
}

/// A temporary file is private to its user; a source file is as readable as the one it replaces, or as any other.
#[cfg(unix)]
fn set_permissions(old: &Path, new: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;

    let permissions = match fs::metadata(old) {
        Ok(metadata) => metadata.permissions(),
        Err(_) => fs::Permissions::from_mode(0o644),
    };
    fs::set_permissions(new, permissions)
}

#[cfg(not(unix))]
fn set_permissions(_old: &Path, _new: &Path) -> io::Result<()> {
    Ok(())
}
