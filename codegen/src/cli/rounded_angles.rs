//! What rounded right angles cost in what is asked for, told where operations are counted anyway.

use std::path::Path;

use kane_codegen::{
    description::Description, generate::Generated, options::Options, rounded_angles,
};

use crate::cli::{Voice, job::Job};

/// Tells it of the models of those modules that are `written`, once for each model.
pub(crate) fn tell(jobs: &[Job], modules: &[Generated], written: &[bool], voice: Voice) {
    let mut told: Vec<&Path> = Vec::new();
    for ((job, module), written) in jobs.iter().zip(modules).zip(written) {
        if !(*written || voice.is_verbose())
            || voice.is_quiet()
            || told.contains(&job.model.as_path())
        {
            continue;
        }
        let functions = Some(&module.functions[..]);
        if let Some(note) = rounded_angles::note(&module.description, &job.options, functions) {
            voice.warn(&note);
            told.push(&job.model);
        }
    }
}

/// Tells it of the functions that would be generated of a model.
pub(crate) fn tell_of(description: &Description, options: &Options, voice: Voice) {
    if voice.is_quiet() {
        return;
    }
    if let Some(note) = rounded_angles::note(description, options, None) {
        voice.warn(&note);
    }
}
