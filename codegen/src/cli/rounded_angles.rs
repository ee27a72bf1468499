//! What rounded right angles cost in what is asked for, told where operations are counted anyway.

use std::{collections::BTreeSet, path::Path};

use kane_codegen::{
    description,
    diagnostic::Diagnostics,
    generate::Generated,
    options::{Functions, Options},
    program::Operations,
    recursive::Technique,
    rounded_angles,
};

use super::{
    Voice,
    changes::ChangesArguments,
    job::{self, Job},
    options,
};

/// Tells it of the models of these modules, once for each model.
pub(crate) fn tell(jobs: &[Job], modules: &[Generated], voice: Voice) {
    let mut told: Vec<&Path> = Vec::new();
    for (job, module) in jobs.iter().zip(modules) {
        let note = note(&job.model, &job.options, Some(&module.functions));
        if let Some(note) = note.filter(|_| !told.contains(&job.model.as_path())) {
            voice.warn(&note);
            told.push(&job.model);
        }
    }
}

/// Tells it of the functions that would be generated of a model: where none are named, of the default set.
pub(crate) fn tell_of(
    model: &Path,
    changes: &ChangesArguments,
    functions: Option<&[String]>,
    without: &BTreeSet<Technique>,
    voice: Voice,
) {
    let names = functions.map(options::names);
    let names = names.map(|names| Functions::of(names.into_iter().map(str::to_owned)));
    let options = Options {
        reading: changes.reading(),
        changes: changes.changes(),
        prescribed: changes.prescribed().to_vec(),
        functions: names.unwrap_or_default(),
        without: without.clone(),
        ..Options::default()
    };
    if let Some(note) = note(model, &options, None) {
        voice.warn(&note);
    }
}

/// A model that can no longer be read is told elsewhere.
fn note(
    model: &Path,
    options: &Options,
    functions: Option<&[(String, Operations)]>,
) -> Option<Diagnostics> {
    let source = job::read(model).ok()?;
    let description = description::read(&source, &options.reading, &job::include(model));
    rounded_angles::note(&description, options, functions)
}
