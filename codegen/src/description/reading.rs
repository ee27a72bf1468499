//! What a caller says beside the model: what a URDF or MJCF leaves open, and how included files are read.

use std::io;

use crate::description::joint::Chart;

/// What a URDF or MJCF leaves to the user.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// How the root link of a URDF hangs from the inertial frame; absent: fixed.
    pub base: Option<Base>,
    /// How the orientations of free and ball joints are described; absent: by Euler parameters.
    pub chart: Option<Chart>,
}

/// How the root link of a URDF hangs from the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// It is part of the inertial frame.
    Fixed,
    /// By a free joint.
    Free,
}

/// Reads a file that a model names, one that it includes or a mesh, given its path as the model writes it: the file's bytes,
/// at most [`MESH_BYTES`](crate::limits::MESH_BYTES).
pub type Include<'a> = &'a dyn Fn(&str) -> io::Result<Vec<u8>>;

/// Reads no file: for a model that stands alone.
///
/// # Errors
/// Always.
pub fn no_includes(_path: &str) -> io::Result<Vec<u8>> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Bytes that are text.
///
/// # Errors
/// Where they are not UTF-8, from which byte on.
pub(crate) fn utf8(bytes: Vec<u8>) -> io::Result<String> {
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        io::Error::other(format!("it is not text in UTF-8, from byte {place} on"))
    })
}

impl Base {
    /// Both, with their names.
    pub const NAMED: [(&str, Self); 2] = [("fixed", Self::Fixed), ("free", Self::Free)];
}
