//! The sections of a file, read in the order in which they need one another.

use std::collections::BTreeSet;

use crate::description::mjcf::files::Files;
use crate::description::mjcf::mass::inertial::baked;
use crate::description::mjcf::model::Beside;
use crate::description::mjcf::model::mesh_budget::Budget;
use crate::description::mjcf::model::models::{self, Models};
use crate::description::mjcf::{
    beside_bodies, bodies, degrees, equalities, files::include, finite, names, sites,
};
use crate::description::xml::{Element, Mended, Reader};
use crate::description::{Description, Include, Reading};
use crate::diagnostic::{Diagnostic, Source, Spanned};

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
    let budget = Budget::new();
    let description = root.and_then(|root| {
        let beside = Beside {
            reading,
            include,
            budget: &budget,
        };
        read(&mut reader, &files, root, &source, beside)
    });
    Description {
        faults: once(reader.faults.into_told()),
        ..description.unwrap_or_else(|| Description::none(&source, Vec::new()))
    }
}

/// The description in an element, but for the faults; `None` where it is no model.
fn read<'d>(
    reader: &mut Reader,
    files: &'d Files<'d>,
    root: Element<'d>,
    source: &Source,
    beside: Beside<'d>,
) -> Option<Description> {
    let all_included = !reader.faults.has_errors();
    let models = Models::read(reader, files, root, beside)?;
    let main = models.main();
    beside_bodies::read(reader, main);
    if main.named("worldbody").is_empty() {
        // What names a body would be told as a consequence, and this as one of a file that is missing.
        if all_included {
            let fault = Diagnostic::error("the model has no `worldbody`");
            let fault = fault.at(root.span(), "expected one, with the bodies");
            reader.faults.push(fault);
        }
        return None;
    }
    let found = bodies::read(reader, &models);
    if let Some(span) = main.settings.merges.filter(|_| found.attaches()) {
        let message =
            "`conflict` of `compiler` is `merge`, which is not supported where models are attached";
        let fault = Diagnostic::error(message).at(span, "expected `warning` or `error`");
        reader.faults.push(fault);
    }
    let attached: BTreeSet<usize> = found.copies.iter().map(|around| around.model).collect();
    for number in attached.into_iter().filter(|number| *number != 0) {
        beside_bodies::read(reader, &models.list[number]);
    }
    let attaches = found.attaches();
    let ties = equalities::read(reader, &models, &found);
    let total_mass = main.settings.total_mass;
    let mut bodies = found.bodies.written(reader, total_mass, &ties.held());
    // Each model has its own unit.
    if !attaches {
        degrees::warn(reader, &main.settings, &bodies.list);
    }
    ties.apply(reader, &mut bodies.list, &bodies.references);
    names::tell_joints_apart(reader, &mut bodies.list);
    let frames = sites::written(reader, &models, &found.sites, &bodies.list);
    finite::check(reader, &bodies.list, &frames);
    let worlds = main.named("worldbody");
    let world = worlds.first().map_or(root.span(), |w| w.span());
    Some(Description {
        name: Some(models::name(root)),
        gravity: main.settings.gravity.map(|entry| Some(baked(entry))),
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
