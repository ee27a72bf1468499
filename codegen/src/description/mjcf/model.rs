//! What a model says, beside its bodies.

use std::collections::BTreeMap;

use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::budget::Budget;
use crate::description::mjcf::defaults::{self, Class, Defaults};
use crate::description::mjcf::files::Files;
use crate::description::mjcf::known;
use crate::description::mjcf::meshes::Meshes;
use crate::description::mjcf::parts::Parts;
use crate::description::mjcf::settings::{self, Settings};
use crate::description::xml::{Element, Known, Reader};
use crate::description::{Include, Reading};
use crate::diagnostic::Span;

/// What the caller says beside a model.
#[derive(Clone, Copy)]
pub(super) struct Beside<'d> {
    pub(super) reading: &'d Reading,
    pub(super) include: Include<'d>,
    pub(super) budget: &'d Budget,
}

/// A model among the assets of another one.
#[derive(Clone, Copy, Debug)]
pub(super) struct ModelAsset {
    /// Its number in [`Models`](super::models::Models).
    pub(super) number: usize,
    pub(super) place: Span,
}

/// What a model says, beside its bodies.
#[derive(Debug)]
pub(super) struct Model<'d> {
    pub(super) files: &'d Files<'d>,
    pub(super) reading: &'d Reading,
    pub(super) settings: Settings,
    pub(super) defaults: Defaults<'d>,
    pub(super) meshes: Meshes<'d>,
    /// The sections of the root, in the order of the file.
    pub(super) sections: Vec<Element<'d>>,
    /// The models among its assets, by name.
    pub(super) assets: BTreeMap<&'d str, ModelAsset>,
    /// What of it can be attached.
    pub(super) parts: Parts<'d>,
}

impl<'d> Model<'d> {
    /// Reads what stands below a root, but for the bodies; `main` is the model to which this one is attached.
    pub(super) fn read(
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
    pub(super) fn child_class(
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
    pub(super) fn named(&self, name: &str) -> Vec<Element<'d>> {
        sections_named(&self.sections, name)
    }
}

fn sections_named<'d>(sections: &[Element<'d>], name: &str) -> Vec<Element<'d>> {
    let named = sections.iter().filter(|section| section.name() == name);
    named.copied().collect()
}
