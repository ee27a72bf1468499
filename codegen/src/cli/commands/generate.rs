//! `kane generate`.

use std::{
    io::Write,
    path::{Path, PathBuf},
    time::Instant,
};

use clap::Args;
use kane_codegen::{
    diagnostic::{count, first_few},
    error::Error,
    generate::Generated,
    origin::OUTPUT_FORMAT,
    output::{self, Overwrite, Staged},
};

use crate::cli::{
    Failures, Outcome, Voice,
    arguments::selection::Selection,
    clashes,
    job::{self, Job, Reported},
    rounded_angles, stray,
    target::Target,
};

/// Write the Rust modules of one model, or of everything in kane.toml
///
/// Writes all files or none: if a model is faulty, it reports all faults of all models and changes no file. It does not touch a
/// file that is up to date. It refuses to overwrite a file without a banner of `kane` and, for a model that kane.toml does not list,
/// one with the banner of another model. The text depends only on the model and the options: it is the same in every folder and on
/// every machine. It warns of functions that need more operations than `budget` in kane.toml allows. If kane.toml has several modules
/// generated from a model, --functions needs --output to say for which.
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane generate\n  \
    kane generate models/arm.toml\n  \
    kane generate models/arm.toml --output src/arm.rs --functions mass_matrix,bias\n  \
    kane generate models/arm.toml --output - | less")]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: Selection,

    /// Overwrite files that `kane generate` did not write, or wrote of another model
    #[arg(long)]
    force: bool,
}

/// Generates everything, then writes everything.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    #[expect(
        clippy::disallowed_methods,
        reason = "how long it took is told, and stands in no file"
    )]
    let start = Instant::now();
    let selected = arguments.selection.read()?;
    let modules = clashes::generate(&selected.jobs)?;
    let overwrite = |job: &Job| match (arguments.force, &job.listing) {
        (true, _) => Overwrite::Anything,
        // A model that is listed may have another path than it had.
        (false, Some(_)) => Overwrite::Generated,
        (false, None) => Overwrite::OfModel,
    };
    let mut failures = Failures::default();
    let mut files = Vec::new();
    let mut news = Vec::new();
    for (job, module) in selected.jobs.iter().zip(&modules) {
        let staged = failures
            .keep(stage(job, module, overwrite(job)))
            .unwrap_or_default();
        let are_written = staged.iter().any(|(_, staged)| !staged.is_up_to_date());
        news.push(Reported {
            job,
            module,
            is_written: are_written || job.target == Target::StandardOutput,
        });
        files.extend(staged);
    }
    job::warn(&news, voice);
    failures.none()?;
    rounded_angles::tell(&news, voice);
    for (job, module) in selected.jobs.iter().zip(&modules) {
        if job.target == Target::StandardOutput {
            out.write_all(module.source.as_bytes())?;
        }
    }
    let paths: Vec<PathBuf> = selected.jobs.iter().flat_map(Job::files).collect();
    let n_files = files.len();
    for (path, staged) in &files {
        if let Some(newer) = staged.replaces_newer() {
            let path = path.display();
            voice.say(format_args!(
                "warning: {path} was written by a newer kane, in format {newer}; this one writes format {OUTPUT_FORMAT}"
            ));
        }
    }
    let written = commit(files, voice)?;
    output::sweep(paths.iter().map(PathBuf::as_path));
    if n_files > 0 {
        let files = told(&written, &paths);
        let seconds = start.elapsed().as_secs_f64();
        voice.say(format_args!("{files}; {}, {seconds:.2} s", size(&modules)));
    }
    if selected.jobs.iter().any(|job| job.is_overridden) {
        voice.say(
            "note: kane.toml asks for something else of this model; `kane check` goes by that",
        );
    }
    for (path, asks) in stray::beside(&selected.jobs)? {
        let path = path.display();
        voice.say(format_args!(
            "warning: {path} was generated before and is left as it was: {asks}, or remove it"
        ));
    }
    for (target, lines) in job::over_budget(&selected.jobs, &modules) {
        voice.say(format_args!(
            "warning: {target} is over budget; limits of operations in kane.toml:\n{lines}"
        ));
    }
    Ok(Outcome::Done)
}

/// The files of a module, beside those that they replace.
fn stage(
    job: &Job,
    module: &Generated,
    overwrite: Overwrite,
) -> Result<Vec<(PathBuf, Staged)>, Failures> {
    let Target::File(path) = &job.target else {
        return Ok(Vec::new());
    };
    let mut failures = Failures::default();
    let mut files = Vec::new();
    for (path, text) in module.files(path) {
        let staged = failures.keep(output::stage(&path, text, overwrite));
        files.extend(staged.map(|staged| (path, staged)));
    }
    failures.none()?;
    Ok(files)
}

/// Puts texts in the place of their files; gives those that changed.
fn commit(files: Vec<(PathBuf, Staged)>, voice: Voice) -> Result<Vec<PathBuf>, Failures> {
    let mut written = Vec::new();
    for (path, staged) in files {
        if staged.is_up_to_date() {
            voice.detail(format_args!("{} is up to date", path.display()));
        } else {
            staged.commit().map_err(|error| stopped(error, &written))?;
            voice.detail(format_args!("wrote {}", path.display()));
            written.push(path);
        }
    }
    Ok(written)
}

/// Why not all files were replaced, and which were.
fn stopped(error: Error, written: &[PathBuf]) -> Failures {
    let mut failures = Failures::from(error);
    if !written.is_empty() {
        failures.add(Failures::message(format!(
            "{} was written before that; run the command again",
            names(written)
        )));
    }
    failures
}

fn names(paths: &[PathBuf]) -> String {
    let shown = paths.iter().map(|path| Path::display(path).to_string());
    first_few(&shown.collect::<Vec<_>>())
}

/// What happened to these files.
fn told(written: &[PathBuf], all: &[PathBuf]) -> String {
    match (written.len(), all.len() - written.len()) {
        (0, 1) => format!("{} is up to date", names(all)),
        (0, count) => format!("all {count} files are up to date"),
        (_, 0) => format!("wrote {}", names(written)),
        (_, 1) => format!("wrote {}; 1 file is up to date", names(written)),
        (_, count) => format!("wrote {}; {count} files are up to date", names(written)),
    }
}

/// How much the modules hold.
fn size(modules: &[Generated]) -> String {
    let functions = || modules.iter().flat_map(|module| &module.functions);
    let operations: usize = functions().map(|(_, counted)| counted.total()).sum();
    format!(
        "{}, {}",
        count(functions().count(), "function"),
        count(operations, "operation")
    )
}
