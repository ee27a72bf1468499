//! What a model says, beside its bodies.

pub(in crate::description::mjcf) mod angles;
pub(in crate::description::mjcf) mod attributes;
pub(in crate::description::mjcf) mod copies;
pub(in crate::description::mjcf) mod defaults;
pub(in crate::description::mjcf) mod mesh_asset;
pub(in crate::description::mjcf) mod mesh_budget;
pub(in crate::description::mjcf) mod meshes;
pub(in crate::description::mjcf) mod models;
pub(in crate::description::mjcf) mod parts;
pub(in crate::description::mjcf) mod settings;

use std::collections::BTreeMap;

use crate::description::mjcf::files::Files;
use crate::description::mjcf::known;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::{Class, Defaults};
use crate::description::mjcf::model::mesh_budget::Budget;
use crate::description::mjcf::model::meshes::Meshes;
use crate::description::mjcf::model::parts::Parts;
use crate::description::mjcf::model::settings::Settings;
use crate::description::xml::{Element, Known, Reader};
use crate::description::{Include, Reading};
use crate::diagnostic::Span;

/// What the caller says beside a model.
#[derive(Clone, Copy)]
pub(in crate::description::mjcf) struct Beside<'d> {
    pub(in crate::description::mjcf) reading: &'d Reading,
    pub(in crate::description::mjcf) include: Include<'d>,
    pub(in crate::description::mjcf) budget: &'d Budget,
}

/// A model among the assets of another one.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct ModelAsset {
    /// Its number in [`Models`](models::Models).
    pub(in crate::description::mjcf) number: usize,
    pub(in crate::description::mjcf) place: Span,
}

/// What a model says, beside its bodies.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Model<'d> {
    pub(in crate::description::mjcf) files: &'d Files<'d>,
    pub(in crate::description::mjcf) reading: &'d Reading,
    pub(in crate::description::mjcf) settings: Settings,
    pub(in crate::description::mjcf) defaults: Defaults<'d>,
    pub(in crate::description::mjcf) meshes: Meshes<'d>,
    /// The sections of the root, in the order of the file.
    pub(in crate::description::mjcf) sections: Vec<Element<'d>>,
    /// The models among its assets, by name.
    pub(in crate::description::mjcf) assets: BTreeMap<&'d str, ModelAsset>,
    /// What of it can be attached.
    pub(in crate::description::mjcf) parts: Parts<'d>,
}

impl<'d> Model<'d> {
    /// Reads what stands below a root, but for the bodies; `main` is the model to which this one is attached.
    pub(in crate::description::mjcf) fn read(
        reader: &mut Reader,
        files: &'d Files<'d>,
        root: Element<'d>,
        main: Option<&Settings>,
        beside: Beside<'d>,
    ) -> Self {
        let known = Known {
            attributes: &["model"],
            ..Known::NONE
        };
        reader.unknown_attributes(root, "`mujoco`", &known);
        let sections = files.children(root);
        for section in &sections {
            if !known::IGNORED_SECTIONS.contains(&section.name()) {
                reader.unknown_child(*section, "`mujoco`", &known::SECTIONS);
            }
        }
        let named = |name: &str| sections_named(&sections, name);
        // The options of a model that is attached do not count.
        let options = match main {
            Some(_) => Vec::new(),
            None => named("option"),
        };
        let mut settings = settings::read(
            reader,
            files,
            &named("compiler"),
            &options,
            root.span(),
            beside.reading,
        );
        if let Some(main) = main {
            settings.attach_to(main, files.folder(root.span()));
        }
        let defaults = defaults::read(reader, files, &named("default"));
        let meshes = Meshes::gather(
            reader,
            files,
            &defaults,
            &named("asset"),
            (beside.include, beside.budget),
        );
        let parts = Parts::of(files, &defaults, &named("worldbody"));
        Self {
            files,
            reading: beside.reading,
            settings,
            defaults,
            meshes,
            sections,
            assets: BTreeMap::new(),
            parts,
        }
    }

    /// The class around the elements inside: the one that is named, or else that from outside.
    pub(in crate::description::mjcf) fn child_class(
        &self,
        reader: &mut Reader,
        given: &Attributes<'_>,
        around: Class,
    ) -> Class {
        let name = given.text("childclass");
        let class = name.and_then(|name| self.defaults.class(reader, name));
        class.unwrap_or(around)
    }

    /// The sections of this name.
    pub(in crate::description::mjcf) fn named(&self, name: &str) -> Vec<Element<'d>> {
        sections_named(&self.sections, name)
    }
}

fn sections_named<'d>(sections: &[Element<'d>], name: &str) -> Vec<Element<'d>> {
    let named = sections.iter().filter(|section| section.name() == name);
    named.copied().collect()
}
