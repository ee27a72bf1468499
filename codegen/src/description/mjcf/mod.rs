//! MJCF, the format of MuJoCo.
//!
//! Bodies stand depth first, in the order of the file, and their frames are those of the file; a body with several
//! joints becomes as many bodies, all but the last without mass. The coordinates are those of MuJoCo, so that `qpos` is
//! `q` but for the order within a free joint. What would change the dynamics of the tree and is not supported is an
//! error; what is left out without a change to them is a warning, or is passed over in silence where it cannot be
//! mistaken for dynamics, such as sensors and materials.
//!
//! Nothing here calls itself: however deep a file, the stack does not grow.

mod attributes;
mod bodies;
mod chain;
mod contents;
mod defaults;
mod finite;
mod geoms;
mod include;
mod inertial;
mod joints;
mod known;
mod names;
mod orientation;
mod others;
mod placement;
mod settings;
mod solid;

use std::collections::BTreeSet;

use crate::description::mjcf::defaults::Defaults;
use crate::description::mjcf::include::Files;
use crate::description::mjcf::inertial::baked;
use crate::description::mjcf::settings::Settings;
use crate::description::xml::{Element, Known, Reader, shown};
use crate::description::{Description, Include, Reading};
use crate::diagnostic::{Diagnostic, Source, Spanned};

/// The name of a model that has none, as MuJoCo calls it.
const NAME: &str = "MuJoCo Model";

/// What the whole file says, beside its bodies.
#[derive(Debug)]
struct Model<'d> {
    files: &'d Files<'d>,
    reading: &'d Reading,
    settings: Settings,
    defaults: Defaults<'d>,
}

/// Reads a description; what is wrong stands in [`Description::faults`].
///
/// [`Description::source`] holds the files that are included, too.
pub fn parse(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    let mut reader = Reader::default();
    let mut source = source.clone();
    let included = include::load(&mut reader, &mut source, include);
    let mut description = Description::none(&source, Vec::new());
    let files = Files::parse(&source, included);
    if let Some(root) = files.root() {
        read(&mut reader, &files, root, reading, &mut description);
    }
    description.faults = once(reader.faults.into_told());
    description
}

fn read(
    reader: &mut Reader,
    files: &Files<'_>,
    root: Element<'_>,
    reading: &Reading,
    description: &mut Description,
) {
    if root.name() != "mujoco" {
        let found = shown(root.name());
        let fault = format!("the root element is `{found}`; expected `mujoco`");
        let fault = Diagnostic::error(fault).at(root.span(), "expected `mujoco`");
        reader.faults.push(fault);
        return;
    }
    let known = Known {
        attributes: &["model"],
        ..Known::NONE
    };
    reader.unknown_attributes(root, "`mujoco`", &known);
    description.name = Some(match root.attribute("model") {
        Some(name) => Spanned::new(name.value.to_owned(), name.span),
        None => Spanned::new(NAME.to_owned(), root.span()),
    });
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
    );
    let defaults = defaults::read(reader, files, &named("default"));
    description.gravity = settings.gravity.map(|entry| Some(baked(entry)));
    let model = Model {
        files,
        reading,
        settings,
        defaults,
    };
    for section in &sections {
        others::read(reader, &model, *section);
    }
    let bodies = bodies::read(reader, &model, &named("worldbody"));
    let world = named("worldbody").first().map_or(root.span(), |w| w.span());
    description.lower_bodies = Some(Spanned::new(bodies.lower, world));
    description.bodies = bodies.list;
}

/// Each fault once: what is wrong with a default is found at every element that has it.
fn once(faults: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen = BTreeSet::new();
    faults
        .into_iter()
        .filter(|fault| seen.insert((fault.labels.clone(), fault.message.clone())))
        .collect()
}
