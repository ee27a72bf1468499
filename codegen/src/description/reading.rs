//! What a caller says beside the model: what a URDF or MJCF leaves open, and how included files are read.

use std::collections::BTreeSet;
use std::io;

use crate::{choices::name_of, description::joint::Chart};

/// What a URDF or MJCF leaves to the user.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// How the root link of a URDF hangs from the inertial frame; absent: fixed.
    pub base: Option<Base>,
    /// How the orientations of free and ball joints are described; absent: by Euler parameters.
    pub chart: Option<Chart>,
    /// What of an MJCF is left out that cannot be had: names of [`LeftOut`], and of equalities.
    pub leave_out: BTreeSet<String>,
}

impl Reading {
    /// The key of `base` in `kane.toml`.
    pub const BASE: &'static str = "base";
    /// The key of `chart`.
    pub const CHART: &'static str = "chart";
    /// The key of `leave_out`.
    pub const LEAVE_OUT: &'static str = "leave_out";
}

/// Forces and constraints of an MJCF that can be left out, all of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOut {
    /// Equalities that tie bodies, joints or tendons.
    Equalities,
    /// Forces of the medium: `density` and `viscosity`.
    Fluid,
    /// Stiffness, damping, armature and friction of tendons.
    Tendons,
    /// Forces against the weights of bodies: `gravcomp`.
    Gravcomp,
}

impl LeftOut {
    /// All of them, with their names.
    pub const NAMED: [(&str, Self); 4] = [
        ("equalities", Self::Equalities),
        ("fluid", Self::Fluid),
        ("tendons", Self::Tendons),
        ("gravcomp", Self::Gravcomp),
    ];

    /// The name by which the user asks for it.
    pub fn name(self) -> &'static str {
        name_of(&self, &Self::NAMED)
    }
}

impl Reading {
    /// True where the user leaves out all of this kind.
    pub fn leaves_out(&self, kind: LeftOut) -> bool {
        self.leave_out.contains(kind.name())
    }
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
