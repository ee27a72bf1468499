//! Which of the formats a mesh file has.

use crate::description::lfs;
use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::Surface;
use crate::description::mesh::{msh, obj, stl};

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Binary, or as text.
    Stl,
    Obj,
    /// MuJoCo's own.
    Msh,
}

impl Format {
    /// By its media type where that is given, else by the ending of the file's name.
    pub(crate) fn of(path: &str, media_type: Option<&str>) -> Option<Self> {
        match media_type.unwrap_or_default() {
            "" => {}
            "model/stl" => return Some(Self::Stl),
            "model/obj" => return Some(Self::Obj),
            "model/vnd.mujoco.msh" => return Some(Self::Msh),
            _ => return None,
        }
        let (_, ending) = path.rsplit_once('.')?;
        match ending.to_ascii_lowercase().as_str() {
            "stl" => Some(Self::Stl),
            "obj" => Some(Self::Obj),
            "msh" => Some(Self::Msh),
            _ => None,
        }
    }

    /// Reads a file of this format.
    pub(crate) fn read(self, bytes: &[u8], effort: &mut Effort) -> Result<Surface, Fault> {
        if bytes.is_empty() {
            return Err(Fault::new("is empty"));
        }
        if lfs::is_pointer(bytes) {
            return Err(Fault::new(lfs::FOUND).help(lfs::ADVICE));
        }
        match self {
            Self::Stl => stl::read(bytes),
            Self::Obj => obj::read(bytes, effort),
            Self::Msh => msh::read(bytes),
        }
    }
}
