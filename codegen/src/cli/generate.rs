//! `kane generate`.

use std::{io::Write, path::PathBuf};

use clap::Args;
use kane_codegen::output::{self, Overwrite};

use super::{
    Failures, Outcome,
    job::{self, Job, Target},
    operations, rounded_angles, say,
    selection::Selection,
};

/// Write the Rust modules of one model, or of everything in kane.toml
///
/// Either every file is written or none: if any model is faulty, all faults of all models are reported and no file is
/// touched. A file that holds its text already is left alone, and one that does not begin as ours do is refused.
/// The text depends on the model and the options alone: it is the same in every folder and on every machine. Functions that
/// need more operations than `budget` in kane.toml gives them are warned of.
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane generate\n  \
    kane generate models/arm.toml\n  \
    kane generate models/arm.toml --output src/arm.rs --functions mass_matrix,bias\n  \
    kane generate models/arm.toml --output - | less")]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: Selection,

    /// Overwrite files that `kane generate` did not write
    #[arg(long)]
    force: bool,
}

/// Generates everything, then writes everything.
pub(crate) fn run(arguments: &Arguments, out: &mut dyn Write) -> Result<Outcome, Failures> {
    let plan = arguments.selection.plan()?;
    let modules = job::generate(&plan.jobs)?;
    rounded_angles::tell(&plan.jobs, &modules);
    let overwrite = if arguments.force {
        Overwrite::Anything
    } else {
        Overwrite::Generated
    };
    let mut failures = Failures::default();
    let mut files = Vec::new();
    for (job, module) in plan.jobs.iter().zip(&modules) {
        match &job.target {
            Target::StandardOutput => out.write_all(module.source.as_bytes())?,
            Target::File(path) => {
                for (path, text) in module.files(path) {
                    let staged = failures.keep(output::stage(&path, text, overwrite));
                    files.extend(staged.map(|staged| (path, staged)));
                }
            }
        }
    }
    failures.none()?;
    let paths: Vec<PathBuf> = plan.jobs.iter().flat_map(Job::files).collect();
    for (path, staged) in files {
        job::commit(staged, &path)?;
    }
    output::sweep(paths.iter().map(PathBuf::as_path));
    for (job, module) in plan.jobs.iter().zip(&modules) {
        let excesses = job.excesses(module);
        if !excesses.is_empty() {
            let lines = operations::text(&excesses);
            let lines = lines.trim_end();
            say(format_args!(
                "warning: {} is over budget\n{lines}",
                job.target
            ));
        }
    }
    Ok(Outcome::Done)
}
