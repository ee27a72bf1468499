//! What rounded right angles cost in what is asked for, told where operations are counted anyway.

use std::path::Path;

use kane_codegen::{
    description::Description, options::Options, program::Operations, rounded_angles,
};

use crate::cli::{Voice, job::Reported};

/// Tells it of the models of those modules that are written, once for each model.
pub(crate) fn tell(modules: &[Reported<'_>], voice: Voice) {
    let mut told: Vec<&Path> = Vec::new();
    let is_news = |module: &&Reported<'_>| module.is_written || voice.is_verbose();
    for Reported { job, module, .. } in modules.iter().filter(is_news) {
        if voice.is_quiet() || told.contains(&job.model.as_path()) {
            continue;
        }
        let functions = Some(&module.functions[..]);
        if let Some(note) = rounded_angles::note(&module.description, &job.options, functions) {
            voice.warn(&note);
            told.push(&job.model);
        }
    }
}

/// Tells it of these functions of a model, or of those that would be generated.
pub(crate) fn tell_of(
    description: &Description,
    options: &Options,
    functions: Option<&[(String, Operations)]>,
    voice: Voice,
) {
    if voice.is_quiet() {
        return;
    }
    if let Some(note) = rounded_angles::note(description, options, functions) {
        voice.warn(&note);
    }
}
