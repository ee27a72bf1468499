//! `kane convert`.

use std::{ffi::OsStr, io::Write, path::PathBuf};

use clap::Args;
use kane_codegen::{
    description::{self, Description, Reading, toml},
    diagnostic::{Diagnostics, Severity},
    output::{self, Overwrite},
    tree::{self, Changes},
};

use crate::cli::{
    Failures, Outcome, Voice, arguments::changes::ReadingArguments, job, paths, target::Target,
};

/// Convert a model of any format to kane's TOML format
///
/// Checks the model first, and reports the decisions made in reading it. The output says what the model says,
/// limits, friction and mimic joints included: nothing is snapped, locked, removed or renumbered. Comments are lost.
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane convert panda.urdf\n  \
    kane convert panda.urdf --base free --output models/panda.toml\n  \
    kane convert humanoid.xml --chart angles | less")]
pub(crate) struct Arguments {
    /// The model: URDF, MJCF or TOML
    #[arg(value_name = "MODEL")]
    model: PathBuf,

    /// The file to write; without it, or with `-`, standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    reading: ReadingArguments,

    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
}

/// What is told of a model: of the tree no notes, which say what a module of it has.
fn told(description: &Description, found: Diagnostics, voice: Voice) -> Diagnostics {
    if voice.is_verbose() {
        return found;
    }
    let told = found
        .list()
        .iter()
        .filter(|one| one.severity != Severity::Note || description.faults.contains(one));
    Diagnostics::new(description.source.clone(), told.cloned().collect())
}

/// Reads, checks and writes.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let model = &arguments.model;
    let output = arguments.output.as_deref();
    let target = output.map_or(Target::StandardOutput, Target::new);
    if let Target::File(path) = &target
        && path.extension() != Some(OsStr::new("toml"))
    {
        return Err(Failures::message(format!(
            "`{}` is to be a model in our own format; expected a file that ends in `.toml`, or `-`",
            path.display()
        )));
    }
    if let Target::File(path) = &target
        && path.file_name() == Some(OsStr::new(paths::CONFIG))
    {
        return Err(Failures::message(format!(
            "`{}` is the name of a list of models; expected another name for a model",
            path.display()
        )));
    }
    if target.is_same_file(model) {
        return Err(Failures::message(format!(
            "`{}` is the model; what it is converted to needs a file of its own",
            model.display()
        )));
    }
    let reading = arguments.reading.above(Reading::default());
    let description = description::read(&job::read(model)?, &reading, &job::include(model));
    let checked = tree::build_with(&description, &Changes::default())?;
    let text = toml::write(&description)?;
    voice.warn(&told(&description, checked.warnings, voice));
    match target {
        Target::StandardOutput => out.write_all(text.as_bytes())?,
        Target::File(path) => {
            let overwrite = if arguments.force {
                Overwrite::Anything
            } else {
                Overwrite::Nothing
            };
            let staged = output::stage(&path, &text, overwrite)?;
            let done = if staged.is_up_to_date() {
                format!("{} is up to date", path.display())
            } else {
                format!("wrote {}", path.display())
            };
            staged.commit()?;
            voice.say(done);
            output::sweep(std::iter::once(path.as_path()));
        }
    }
    Ok(Outcome::Done)
}
