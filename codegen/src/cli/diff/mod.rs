//! `kane diff`.

mod sections;
mod side;
mod value;

use std::{io::Write, path::PathBuf};

use clap::{Args, ValueEnum};
use kane_codegen::{
    compile::Options,
    report::{self, Comparison, Differences},
};
use similar::TextDiff;

use super::{
    Failures, Outcome, json,
    listed::Listed,
    options::{Asked, OptionsArguments},
    paths, say,
};
use side::{Known, Side};

/// Tell what differs between two models, or between two generated modules
///
/// Each is a file or, as git writes it, a file in a revision, `HEAD~1:models/arm.toml`, from the repository's root;
/// `:models/arm.toml` is what is staged. Told are bodies and joints that came, went or changed, values with the old and the new
/// one, functions whose operations changed, and a diff of the generated text. Where places in `q`, `u` or arrays over bodies
/// changed, code that indexes them means something else now: that is said first, as BREAKING.
///
/// Both models are generated with the same options: those of the `kane.toml` above NEW, or else above OLD, for the first system
/// that lists it, as far as no option here says otherwise.
#[derive(Args, Debug)]
#[command(after_long_help = "Exit codes:\n  \
    0  nothing differs\n  \
    1  something differs\n  \
    2  bad input, or a file that cannot be read\n\n\
    Examples:\n  \
    kane diff old.urdf new.urdf\n  \
    kane diff HEAD:models/arm.toml models/arm.toml\n  \
    kane diff main:generated/arm.rs generated/arm.rs --format markdown   for a pull request")]
pub(crate) struct Arguments {
    /// The old model or module
    #[arg(id = "model", value_name = "OLD")]
    old: PathBuf,

    /// The new one
    #[arg(value_name = "NEW")]
    new: PathBuf,

    /// How it is written
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    options: OptionsArguments,

    /// The file that lists the systems, in place of the `kane.toml` above NEW or OLD
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Lines for a terminal
    Text,
    /// Tables, for a pull request
    Markdown,
    /// JSON, for programs
    Json,
}

/// What differs, and between what.
struct Report {
    names: [String; 2],
    fingerprints: [Option<u64>; 2],
    differences: Differences,
    functions: Comparison,
    /// The unified diff of the texts; empty where they are the same.
    diff: String,
}

impl Report {
    fn new(names: [&str; 2], [old, new]: [&Known; 2]) -> Result<Self, Failures> {
        let [old_name, new_name] = names;
        let functions = report::compare(&old.text, &new.text).map_err(Failures::message)?;
        let diff = TextDiff::from_lines(&old.text, &new.text);
        // A tab ends the name, so that `patch` reads it right.
        let mut diff = diff.unified_diff();
        diff.header(&format!("{old_name}\told"), &format!("{new_name}\tnew"));
        let diff = if old.text == new.text {
            String::new()
        } else {
            diff.to_string()
        };
        Ok(Self {
            names: names.map(str::to_owned),
            fingerprints: [old, new].map(|known| known.outline.fingerprint),
            differences: report::differences(&old.outline, &new.outline),
            functions,
            diff,
        })
    }

    fn is_same(&self) -> bool {
        self.differences == Differences::default() && self.diff.is_empty()
    }
}

/// Reads both, generates where they are models, compares.
pub(crate) fn run(arguments: &Arguments, out: &mut dyn Write) -> Result<Outcome, Failures> {
    let asked = arguments.options.read()?;
    let mut failures = Failures::default();
    let old = failures.keep(Side::read(&arguments.old));
    let new = failures.keep(Side::read(&arguments.new));
    let (Some(old), Some(new)) = (old, new) else {
        return Err(failures);
    };
    let known = match (old.is_module(), new.is_module()) {
        (true, true) => [&old, &new].map(Side::of_module),
        (false, false) => {
            let options = options(arguments, &asked, [&new, &old])?;
            // The path in the banner, which is no difference.
            let shown = new.file_name();
            [&old, &new].map(|side| side.of_model(&shown, &options))
        }
        _ => {
            return Err(Failures::message(
                "a model and a module cannot be compared; expected two models, or two modules, which end in `.rs`",
            ));
        }
    };
    let [Some(old_known), Some(new_known)] = known.map(|known| failures.keep(known)) else {
        return Err(failures);
    };
    let report = Report::new([old.name(), new.name()], [&old_known, &new_known])?;
    match arguments.format {
        Format::Text => out.write_all(sections::text(&report).as_bytes())?,
        Format::Markdown => out.write_all(sections::markdown(&report).as_bytes())?,
        Format::Json => json::write(out, &value::value(&report))?,
    }
    if !report.is_same() {
        return Ok(Outcome::Differs);
    }
    say(format_args!(
        "nothing differs between {} and {}",
        old.name(),
        new.name()
    ));
    Ok(Outcome::Done)
}

/// The options that `kane.toml` has for the first of these models that it lists, below what is asked for.
fn options(
    arguments: &Arguments,
    asked: &Asked<'_>,
    sides: [&Side; 2],
) -> Result<Options, Failures> {
    let mut options = Options::default();
    for file in sides.into_iter().filter_map(Side::own_file) {
        let above = paths::config_above(&paths::target(paths::parent(&file))?);
        let above = above.map(|path| paths::shown(&path)).transpose()?;
        let Some(config) = arguments.config.clone().or(above) else {
            continue;
        };
        if let Some(job) = Listed::read(&config)?.jobs_of(&file)?.into_iter().next() {
            options = job.options;
            break;
        }
    }
    asked.set(&mut options);
    Ok(options)
}
