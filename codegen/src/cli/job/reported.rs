//! What is told of modules.

use kane_codegen::generate::Generated;

use super::Job;
use crate::cli::Voice;

/// A module of which is told what should be known.
pub(crate) struct Reported<'a> {
    pub(crate) job: &'a Job,
    pub(crate) module: &'a Generated,
    /// Whether a file of it changes: else notes are no news.
    pub(crate) is_written: bool,
}

/// Tells what should be known about the models, once for each.
pub(crate) fn warn(modules: &[Reported<'_>], voice: Voice) {
    let mut told = Vec::new();
    // What is told with notes is not told again without.
    let (written, others): (Vec<&Reported<'_>>, Vec<_>) =
        modules.iter().partition(|module| module.is_written);
    for Reported {
        module, is_written, ..
    } in written.into_iter().chain(others)
    {
        let text = module.warnings.to_string();
        if told.contains(&text) {
            continue;
        }
        if *is_written {
            voice.warn(&module.warnings);
        } else {
            voice.warn_without_notes(&module.warnings);
        }
        told.push(text);
    }
}
