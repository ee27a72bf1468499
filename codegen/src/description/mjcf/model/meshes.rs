//! The meshes of a model, by name. A file is read where a mass first follows from it, and once.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::fmt;

use crate::description::mesh::MeshShape;
use crate::description::mjcf::files::Files;
use crate::description::mjcf::files::paths::file_name;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::{Class, Defaults, ElementKind};
use crate::description::mjcf::model::mesh_asset::{self, WantedMesh};
use crate::description::mjcf::model::mesh_budget::Budget;
use crate::description::mjcf::model::settings::Settings;
use crate::description::mjcf::unknown::unknown;
use crate::description::xml::{Element, Reader};
use crate::description::{Include, too_many};
use crate::diagnostic::{Diagnostic, Span, shown};

/// The meshes of a model.
pub(in crate::description::mjcf) struct Meshes<'d> {
    list: BTreeMap<String, Mesh<'d>>,
    include: Include<'d>,
    budget: &'d Budget,
}

struct Mesh<'d> {
    given: Attributes<'d>,
    /// The folder of the file that names it, from the main file's.
    folder: &'d str,
    /// The place of a plugin that makes it.
    plugin: Option<Span>,
    /// The place of a second one of this name.
    again: Option<Span>,
    /// What it weighs; `None` in it where that cannot be had, which is told once.
    shape: OnceCell<Option<MeshShape>>,
}

impl fmt::Debug for Meshes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.list.keys()).finish()
    }
}

impl<'d> Meshes<'d> {
    /// The meshes of all `asset` sections.
    pub(in crate::description::mjcf) fn gather(
        reader: &mut Reader,
        files: &'d Files<'_>,
        defaults: &Defaults<'d>,
        sections: &[Element<'d>],
        (include, budget): (Include<'d>, &'d Budget),
    ) -> Self {
        let mut list: BTreeMap<String, Mesh<'d>> = BTreeMap::new();
        let elements = sections.iter().flat_map(|section| files.children(*section));
        for element in elements.filter(|element| element.name() == "mesh") {
            let name = element.attribute("name").or(element.attribute("file"));
            let owner = match name {
                Some(name) => format!("mesh `{}`", shown(name.value)),
                None => "a mesh without a name".to_owned(),
            };
            let kind = ElementKind::Mesh;
            let given = defaults.attributes(reader, element, &owner, kind, Class::MAIN);
            let name = match (given.text("name"), given.text("file")) {
                (Some(name), _) if !name.value.is_empty() => name.value,
                (_, Some(file)) => stem(file.value),
                _ => "",
            };
            if let Some(fault) = too_many("the number of meshes is at least", list.len() + 1) {
                reader.faults.push(fault.at(element.span(), "one too many"));
                break;
            }
            if let Some(known) = list.get_mut(name) {
                known.again.get_or_insert(element.span());
                continue;
            }
            let mut inside = files.children(element).into_iter();
            let plugin = inside.find(|child| child.name() == "plugin");
            let mesh = Mesh {
                folder: files.folder(element.span()),
                given,
                plugin: plugin.map(Element::span),
                again: None,
                shape: OnceCell::new(),
            };
            list.insert(name.to_owned(), mesh);
        }
        Self {
            list,
            include,
            budget,
        }
    }

    /// What the mesh of a geom weighs; `None` where that cannot be had.
    pub(in crate::description::mjcf) fn shape(
        &self,
        reader: &mut Reader,
        geom: &Attributes<'_>,
        settings: &Settings,
    ) -> Option<MeshShape> {
        let Some(name) = geom.text("mesh") else {
            let fault = Diagnostic::error(format!("{} is a mesh, but names none", geom.owner));
            let fault = fault.at(geom.place("type"), "expected an attribute `mesh`");
            reader.faults.push(fault);
            return None;
        };
        let Some(mesh) = self.list.get(name.value) else {
            let message = format!("there is no mesh `{}`", shown(name.value));
            unknown(reader, message, name, self.list.keys().map(String::as_str));
            return None;
        };
        *mesh.shape.get_or_init(|| {
            if let Some(again) = mesh.again {
                let message = format!("mesh `{}` is given twice", shown(name.value));
                let fault = Diagnostic::error(message)
                    .at(again, "the second one")
                    .at(mesh.given.span, "the first one");
                reader.faults.push(fault);
                return None;
            }
            let reading = WantedMesh {
                mesh: &mesh.given,
                folder: mesh.folder,
                plugin: mesh.plugin,
                geom,
                settings,
                include: self.include,
                budget: self.budget,
            };
            mesh_asset::shape(reader, &reading)
        })
    }
}

/// The name of a mesh that has none: its file's, without folders and ending.
fn stem(path: &str) -> &str {
    let name = file_name(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}
