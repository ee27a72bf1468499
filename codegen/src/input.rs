//! Reading a file: a regular one, and no more of it than it may have, so that nothing waits for ever or fills the memory.

use std::{
    fs::{self, File},
    io::{self, Read},
    path::Path,
};

use crate::{description::utf8, limits};

/// The text of a file: a model, `kane.toml`, a state.
///
/// # Errors
/// What the system says; a file that is none, such as a pipe; one that is too large, or not text in UTF-8.
pub fn text(path: &Path) -> io::Result<String> {
    text_from(open(path)?)
}

/// The text that can be read from here, as [`text`] reads a file's.
///
/// # Errors
/// As of [`text`].
pub fn text_from(from: impl Read) -> io::Result<String> {
    utf8(at_most(from, limits::INPUT_BYTES)?)
}

/// The bytes of a file that a model names: a model that it includes, or a mesh.
///
/// # Errors
/// As of [`text`], but for what the bytes mean.
pub fn named(path: &Path) -> io::Result<Vec<u8>> {
    named_from(open(path)?)
}

/// The bytes that can be read from here, as [`named`] reads a file's.
///
/// # Errors
/// As of [`named`].
pub fn named_from(from: impl Read) -> io::Result<Vec<u8>> {
    at_most(from, limits::MESH_BYTES)
}

/// The text of a generated file.
///
/// # Errors
/// As of [`text`].
#[cfg(feature = "object")]
pub(crate) fn generated(path: &Path) -> io::Result<String> {
    utf8(bytes(path)?)
}

/// The bytes of a generated file.
///
/// # Errors
/// As of [`text`], but for what the bytes mean.
pub(crate) fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    at_most(open(path)?, limits::OUTPUT_BYTES)
}

/// Opens a file; a pipe could keep us waiting, and a device never end.
fn open(path: &Path) -> io::Result<File> {
    let metadata = fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !metadata.is_file() {
        return Err(io::Error::other("it is no regular file"));
    }
    File::open(path)
}

fn at_most(from: impl Read, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > most {
        let fault = format!("it has more than {most} bytes");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, fault));
    }
    Ok(bytes)
}
