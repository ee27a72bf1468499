//! The sections of a file, read in the order in which they need one another.

use std::collections::BTreeSet;

use crate::description::mjcf::copies::Copies;
use crate::description::mjcf::include::Files;
use crate::description::mjcf::inertial::baked;
use crate::description::mjcf::meshes::Meshes;
use crate::description::mjcf::model::Model;
use crate::description::mjcf::{bodies, defaults, equalities, include, known, others, settings};
use crate::description::xml::{Element, Known, Mended, Reader, shown};
use crate::description::{Description, Include, Reading};
use crate::diagnostic::{Diagnostic, Source, Spanned};

/// The name of a model that has none, as MuJoCo calls it.
const NAME: &str = "MuJoCo Model";

/// Reads a description; what is wrong stands in [`Description::faults`].
///
/// [`Description::source`] holds the files that are included, too.
pub fn parse(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    let mut reader = Reader::default();
    let mut source = source.clone();
    let included = include::load(&mut reader, &mut source, include);
    let texts = source.files();
    let texts: Vec<Mended<'_>> = texts
        .map(|file| Mended::of(file.text(), file.base()))
        .collect();
    let files = Files::parse(&source, &texts, included);
    let root = files.root();
    let description = root.and_then(|root| {
        let beside = Beside { reading, include };
        read(&mut reader, &files, root, &source, &beside)
    });
    Description {
        faults: once(reader.faults.into_told()),
        ..description.unwrap_or_else(|| Description::none(&source, Vec::new()))
    }
}

/// What the caller says beside the model.
struct Beside<'a> {
    reading: &'a Reading,
    include: Include<'a>,
}

/// The description in an element, but for the faults; `None` where it is no model.
fn read(
    reader: &mut Reader,
    files: &Files<'_>,
    root: Element<'_>,
    source: &Source,
    beside: &Beside<'_>,
) -> Option<Description> {
    if root.name() != "mujoco" {
        let found = shown(root.name());
        let fault = format!("the root element is `{found}`; expected `mujoco`");
        let fault = Diagnostic::error(fault).at(root.span(), "expected `mujoco`");
        reader.faults.push(fault);
        return None;
    }
    let known = Known {
        attributes: &["model"],
        ..Known::NONE
    };
    reader.unknown_attributes(root, "`mujoco`", &known);
    let name = match root.attribute("model") {
        Some(name) => Spanned::new(name.value.to_owned(), name.span),
        None => Spanned::new(NAME.to_owned(), root.span()),
    };
    let sections = files.children(root);
    for section in &sections {
        if !known::IGNORED_SECTIONS.contains(&section.name()) {
            reader.unknown_child(*section, "`mujoco`", &known::SECTIONS);
        }
    }
    let named = |name: &str| -> Vec<Element<'_>> {
        let named = sections.iter().filter(|section| section.name() == name);
        named.copied().collect()
    };
    let settings = settings::read(
        reader,
        files,
        &named("compiler"),
        &named("option"),
        root.span(),
        beside.reading,
    );
    let defaults = defaults::read(reader, files, &named("default"));
    let meshes = Meshes::gather(reader, files, &defaults, &named("asset"), beside.include);
    let model = Model {
        files,
        reading: beside.reading,
        settings,
        defaults,
        meshes,
        copies: Copies::default(),
    };
    for section in &sections {
        others::read(reader, &model, *section);
    }
    let worlds = named("worldbody");
    let ties = equalities::read(reader, &model, &named("equality"), &worlds);
    let (bodies, frames) = bodies::read(reader, &model, &worlds, &ties);
    let world = worlds.first().map_or(root.span(), |w| w.span());
    Some(Description {
        name: Some(name),
        gravity: model.settings.gravity.map(|entry| Some(baked(entry))),
        lower_bodies: Some(Spanned::new(bodies.lower, world)),
        bodies: bodies.list,
        frames,
        ..Description::none(source, Vec::new())
    })
}

/// Each fault once: what is wrong with a default is found at every element that has it.
fn once(faults: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen = BTreeSet::new();
    faults
        .into_iter()
        .filter(|fault| seen.insert((fault.labels.clone(), fault.message.clone())))
        .collect()
}
