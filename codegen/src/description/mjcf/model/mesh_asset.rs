//! `mesh`: where its points and faces come from, and what happens to them.

use std::io;

use crate::description::Include;
use crate::description::mesh::{self, Change, Fault, Filling, Format, MeshShape, Surface};
use crate::description::mjcf::files::paths::{file_name, is_absolute};
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::mesh_budget::Budget;
use crate::description::mjcf::model::settings::{Settings, Switch};
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};
use crate::geometry::{IDENTITY, of_quaternion};
use crate::limits::{MESH_BYTES, MESHES_BYTES};

const FILLINGS: [(&str, Filling); 4] = [
    ("convex", Filling::Convex),
    ("exact", Filling::Exact),
    ("legacy", Filling::Legacy),
    ("shell", Filling::Shell),
];

const WITHOUT: &str = "give the body an `inertial`, or the geom `mass=\"0\"`";

/// A mesh that is to be read, and why.
pub(in crate::description::mjcf) struct WantedMesh<'r> {
    pub(in crate::description::mjcf) mesh: &'r Attributes<'r>,
    /// The folder of the file that names it, from the main file's.
    pub(in crate::description::mjcf) folder: &'r str,
    /// The place of a plugin that makes it.
    pub(in crate::description::mjcf) plugin: Option<Span>,
    /// The geom whose mass follows from it.
    pub(in crate::description::mjcf) geom: &'r Attributes<'r>,
    pub(in crate::description::mjcf) settings: &'r Settings,
    pub(in crate::description::mjcf) include: Include<'r>,
    pub(in crate::description::mjcf) budget: &'r Budget,
}

/// What a mesh weighs; `None` where that cannot be had.
pub(in crate::description::mjcf) fn shape(
    reader: &mut Reader,
    reading: &WantedMesh<'_>,
) -> Option<MeshShape> {
    let mesh = reading.mesh;
    let filling = match mesh.keyword(reader, "inertia", &FILLINGS) {
        Some(filling) => filling.value,
        None if mesh.has("inertia") => return None,
        None if reading.settings.exact_meshes == Switch::On => Filling::Exact,
        None => Filling::Legacy,
    };
    let change = change(reader, mesh)?;
    let most_corners = most_corners(reader, mesh)?;
    let surface = surface(reader, reading)?;
    tell_left_out(reader, mesh, &surface);
    let mut effort = reading.budget.effort.get();
    let shape = mesh::shape(&surface, filling, &change, most_corners, &mut effort);
    reading.budget.effort.set(effort);
    match shape {
        Ok(shape) => Some(shape),
        Err(fault) => {
            reader.faults.push(reading.fault(&fault));
            None
        }
    }
}

/// Warns of what MuJoCo leaves out of a file.
fn tell_left_out(reader: &mut Reader, mesh: &Attributes<'_>, surface: &Surface) {
    let mut tell = |message: String, label: &str, plural: &str| {
        let warning = Diagnostic::warning(message).at(mesh.place("file"), label);
        reader.faults.push(warning.one_of(plural, &*mesh.owner));
    };
    if surface.leaves_objects_out {
        let message = format!(
            "{} has several objects in its file; as in MuJoCo the first one alone has mass",
            mesh.owner
        );
        let plural = "meshes whose files hold several objects";
        tell(message, "read up to the second", plural);
    }
    if surface.leaves_faces_out {
        let message = format!(
            "{} has a face of more than {} corners; as in MuJoCo it is left out",
            mesh.owner,
            mesh::MOST_CORNERS
        );
        let plural = "meshes with faces of too many corners";
        tell(message, "it has holes", plural);
    }
}

/// What happens to the points.
fn change(reader: &mut Reader, mesh: &Attributes<'_>) -> Option<Change> {
    let mut change = Change {
        origin: [0.0; 3],
        rotation: IDENTITY,
        scale: [1.0; 3],
    };
    if mesh.has("refpos") {
        change.origin = mesh.vector(reader, "refpos")?;
    }
    if mesh.has("scale") {
        change.scale = mesh.vector(reader, "scale")?;
    }
    if mesh.has("refquat") {
        let Some(rotation) = of_quaternion(mesh.vector(reader, "refquat")?) else {
            let message = format!("{} is no orientation", mesh.what("refquat"));
            let label = "expected a quaternion that is not zero";
            let fault = Diagnostic::error(message).at(mesh.place("refquat"), label);
            reader.faults.push(fault);
            return None;
        };
        change.rotation = rotation;
    }
    Some(change)
}

/// How many points the convex hull may have; `None` for a fault.
fn most_corners(reader: &mut Reader, mesh: &Attributes<'_>) -> Option<usize> {
    let Some(text) = mesh.text("maxhullvert") else {
        return Some(usize::MAX);
    };
    match text.value.trim().parse::<i32>() {
        Ok(-1) => Some(usize::MAX),
        Ok(most) if most > 3 => usize::try_from(most).ok(),
        _ => {
            let message = format!(
                "{} is `{}`; expected a whole number of more than 3, or -1",
                mesh.what("maxhullvert"),
                shown(text.value)
            );
            let fault = Diagnostic::error(message).at(text.span, "no such number");
            reader.faults.push(fault);
            None
        }
    }
}

/// Points and faces: those of the file, or those in the model.
fn surface(reader: &mut Reader, reading: &WantedMesh<'_>) -> Option<Surface> {
    let mesh = reading.mesh;
    let made = mesh.has("builtin").then(|| mesh.place("builtin"));
    if let Some(place) = made.or(reading.plugin) {
        let message = format!(
            "{} is made by MuJoCo, which is not supported; the mass of {} follows from it",
            mesh.owner, reading.geom.owner
        );
        let fault = Diagnostic::error(message).at(place, "not supported");
        let help = "let MuJoCo save the model: it writes out the mesh";
        reader.faults.push(fault.help(help));
        return None;
    }
    let Some(file) = mesh.text("file").filter(|file| !file.value.is_empty()) else {
        return inline(reader, reading);
    };
    if let Some(name) = ["vertex", "face"].into_iter().find(|name| mesh.has(name)) {
        let message = format!(
            "{} has `file` and `{name}`; expected one of the two",
            mesh.owner
        );
        let fault = Diagnostic::error(message)
            .at(mesh.place(name), "the second one")
            .at(file.span, "the first one");
        reader.faults.push(fault);
        return None;
    }
    read(reader, reading, file)
}

/// The path of a mesh file from the model's folder.
fn path(settings: &Settings, file: &str) -> String {
    let file = match settings.strip_path {
        Switch::On => file_name(file),
        Switch::Off => file,
    };
    let folder = &settings.mesh_folder;
    let path = if folder.is_empty() || is_absolute(file) {
        file.to_owned()
    } else if folder.ends_with(['/', '\\']) {
        format!("{folder}{file}")
    } else {
        format!("{folder}/{file}")
    };
    path.replace('\\', "/")
}

/// True for a path that leads out of the folder from which it starts.
fn leads_out(path: &str) -> bool {
    let mut depth = 0_usize;
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." if depth == 0 => return true,
            ".." => depth -= 1,
            _ => depth += 1,
        }
    }
    is_absolute(path)
}

fn read(reader: &mut Reader, reading: &WantedMesh<'_>, file: Spanned<&str>) -> Option<Surface> {
    let path = path(reading.settings, file.value);
    let seen = shown(&path);
    let mut refuse = |message: String, help: &str| {
        let geom = reading.geom;
        let needed = format!("the mass of {} follows from it", geom.owner);
        let fault = Diagnostic::error(message)
            .at(file.span, needed)
            .at(geom.place("mesh"), "here");
        reader.faults.push(fault.help(help));
        None
    };
    let media_type = reading.mesh.text("content_type").map(|given| given.value);
    let Some(format) = Format::of(&path, media_type) else {
        let message = format!("the mesh file `{seen}` is of no kind that can be read");
        return refuse(message, "write the mesh as STL, OBJ or MSH");
    };
    if reading.budget.bytes.get() > MESHES_BYTES {
        return None;
    }
    let bytes = match reading.bytes_of(&path, file.value) {
        Ok(bytes) => bytes,
        Err(error) => {
            // One that is too large was read up to the limit.
            if error.kind() == io::ErrorKind::FileTooLarge {
                let all = reading.budget.bytes.get() + MESH_BYTES;
                reading.budget.bytes.set(all);
            }
            let message = format!("the mesh file `{seen}` cannot be read: {error}");
            return refuse(message, WITHOUT);
        }
    };
    let total = reading.budget.bytes.get().saturating_add(bytes.len());
    reading.budget.bytes.set(total);
    if total > MESHES_BYTES {
        let message = format!(
            "the mesh files up to `{seen}` have {total} bytes; expected at most {MESHES_BYTES}"
        );
        return refuse(message, WITHOUT);
    }
    if leads_out(&path) {
        let message = format!(
            "the mesh file `{seen}`, from which the mass of {} follows, is outside of the model's folder",
            reading.geom.owner
        );
        let warning = Diagnostic::warning(message).at(file.span, "read from there");
        let warning = warning.one_of("mesh files outside of the model's folder", seen);
        reader.faults.push(warning);
    }
    let mut effort = reading.budget.effort.get();
    let surface = format.read(&bytes, &mut effort);
    reading.budget.effort.set(effort);
    match surface {
        Ok(surface) => Some(surface),
        Err(fault) => {
            reader.faults.push(reading.fault(&fault));
            None
        }
    }
}

/// Points and faces that stand in the model.
fn inline(reader: &mut Reader, reading: &WantedMesh<'_>) -> Option<Surface> {
    let mesh = reading.mesh;
    if !mesh.has("vertex") {
        let message = format!(
            "{} has neither `file` nor `vertex`; the mass of {} follows from it",
            mesh.owner, reading.geom.owner
        );
        let fault = Diagnostic::error(message).at(mesh.span, "expected one of the two");
        reader.faults.push(fault);
        return None;
    }
    let points = triples::<f32>(reader, mesh, "vertex", "a number")?;
    let faces = triples::<u32>(reader, mesh, "face", "a whole number from 0 on")?;
    match Surface::new(points, faces) {
        Ok(surface) => Some(surface),
        Err(fault) => {
            reader.faults.push(reading.fault(&fault));
            None
        }
    }
}

/// Numbers by three; none where the attribute is absent.
fn triples<T: Copy + std::str::FromStr>(
    reader: &mut Reader,
    mesh: &Attributes<'_>,
    name: &str,
    expected: &str,
) -> Option<Vec<[T; 3]>> {
    let Some(text) = mesh.text(name) else {
        return Some(Vec::new());
    };
    let mut numbers = Vec::new();
    for word in text.value.split_ascii_whitespace() {
        let Ok(number) = word.parse() else {
            let message = format!(
                "entry {} of {} is `{}`; expected {expected}",
                numbers.len() + 1,
                mesh.what(name),
                shown(word)
            );
            let fault = Diagnostic::error(message).at(text.span, "here");
            reader.faults.push(fault);
            return None;
        };
        numbers.push(number);
    }
    let (triples, rest) = numbers.as_chunks();
    if !rest.is_empty() {
        let message = format!(
            "{} has {} entries; expected three for each {}",
            mesh.what(name),
            numbers.len(),
            if name == "face" { "face" } else { "point" }
        );
        let fault = Diagnostic::error(message).at(text.span, "not a multiple of three");
        reader.faults.push(fault);
        return None;
    }
    Some(triples.to_vec())
}

impl WantedMesh<'_> {
    /// The bytes of a file, which may also stand beside the included file that names it.
    fn bytes_of(&self, path: &str, file: &str) -> io::Result<Vec<u8>> {
        let found = (self.include)(path);
        match found {
            Err(_) if !self.folder.is_empty() && !is_absolute(file) => {
                let beside = format!("{}/{}", self.folder, file.replace('\\', "/"));
                (self.include)(&beside).or(found)
            }
            found => found,
        }
    }

    /// What is wrong with the mesh, said where it is used.
    fn fault(&self, fault: &Fault) -> Diagnostic {
        let file = self.mesh.text("file").filter(|file| !file.value.is_empty());
        let words = match file {
            Some(file) => format!(
                "the mesh file `{}`",
                shown(&path(self.settings, file.value))
            ),
            None => self.mesh.owner.to_string(),
        };
        let message = format!("{words} {}", fault.found);
        let needed = format!("the mass of {} follows from it", self.geom.owner);
        let place = file.map_or(self.mesh.span, |file| file.span);
        let found = Diagnostic::error(message)
            .at(place, needed)
            .at(self.geom.place("mesh"), "here");
        found.help(fault.advice.unwrap_or(WITHOUT))
    }
}
