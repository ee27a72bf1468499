//! `kane check`.

use std::{
    ffi::OsStr,
    io::{self, Write},
    path::{Path, PathBuf},
};

use clap::Args;
use kane_codegen::{
    generate::Generated,
    origin::{self, OUTPUT_FORMAT},
    output, ownership,
    report::{Comparison, ReadModule},
};

use crate::cli::{
    Failures, Outcome, Voice,
    arguments::selection::{Selection, Whole},
    clashes,
    job::{self, Job, Reported},
    stray,
    target::Target,
    text::lines::ChangedLines,
    text::operations,
    text::text_diff::TextDiff,
};

/// Check whether generated files match their models; write nothing
///
/// Generates in memory and compares. If every file is up to date, it prints nothing; --verbose also shows warnings about the models.
/// For each file that differs, it prints how many lines changed and in which functions, and which functions have other operation
/// counts, are new or are gone. --lines adds the lines as a unified diff. It then prints the command that updates the files,
/// and the functions that need more operations than `budget` in kane.toml allows. If it checks all of kane.toml, it also
/// reports files that no system in it produces: in a folder named `generated` every file except `mod.rs` and hidden files, and in
/// other output folders the files that begin with a banner of `kane`. Of a single model, it reports those beside the module.
#[derive(Args, Debug)]
#[command(after_long_help = "Exit codes:\n  \
    0  every file is up to date\n  \
    1  a file differs, is missing, is over budget, or no system produces it\n  \
    2  bad input, or a file that cannot be read\n\n\
    Examples:\n  \
    kane check\n  \
    kane check --lines | less\n  \
    kane check models/arm.toml --formulation notes     what would change?")]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: Selection,

    /// Changes nothing: accepted so that the arguments of `kane generate` can stand here
    #[arg(long, hide = true)]
    force: bool,

    /// Show the lines that differ, as a unified diff
    #[arg(long)]
    lines: bool,
}

/// How the file at a path compares with its text.
struct Compared<'a> {
    path: PathBuf,
    is_module: bool,
    new: &'a str,
    found: Found,
}

impl Compared<'_> {
    /// True for what `cargo fmt` formats.
    fn is_rust(&self) -> bool {
        self.path.extension() == Some(OsStr::new("rs"))
    }
}

enum Found {
    Same,
    Missing,
    /// The same but for its line ends.
    LineEnds,
    /// In more than its line ends, which are LF in this text.
    Differs {
        old: String,
        has_crlf: bool,
    },
}

/// Generates everything, then compares everything.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let selected = arguments.selection.read()?;
    let modules = clashes::generate(&selected.jobs)?;
    if voice.is_verbose() {
        let told = selected.jobs.iter().zip(&modules);
        let told = told.map(|(job, module)| Reported {
            job,
            module,
            is_written: true,
        });
        job::warn(&told.collect::<Vec<_>>(), voice);
    }
    let mut failures = Failures::default();
    let files = selected.jobs.iter().zip(&modules);
    let files: Vec<Compared<'_>> = files
        .filter_map(|(job, module)| failures.keep(compare(&job.target, module)))
        .flatten()
        .collect();
    let strays = selected.whole.as_ref().map(|whole| {
        let strays = failures.keep(stray::find(&selected.jobs, &whole.root));
        (whole, strays.unwrap_or_default())
    });
    failures.none()?;

    let is_up_to_date = write_files(out, &files, arguments, voice)?;
    let is_within = write_over_budget(out, &selected.jobs, &modules)?;
    let has_no_strays = match &strays {
        Some((whole, strays)) => write_strays(out, &selected.jobs, whole, strays)?,
        None => write_beside(out, &selected.jobs)?,
    };
    Ok(if is_up_to_date && is_within && has_no_strays {
        Outcome::Done
    } else {
        Outcome::Differs
    })
}

/// Tells what differs, and how to bring it up to date; true where nothing does.
fn write_files(
    out: &mut dyn Write,
    files: &[Compared<'_>],
    arguments: &Arguments,
    voice: Voice,
) -> io::Result<bool> {
    for file in files {
        write_file(out, file, arguments.lines, voice)?;
    }
    let mut differing = files
        .iter()
        .filter(|file| !matches!(file.found, Found::Same));
    if differing.next().is_none() {
        return Ok(true);
    }
    let has_lines = |file: &Compared<'_>| matches!(file.found, Found::Differs { .. });
    if !arguments.lines && files.iter().any(has_lines) {
        writeln!(out, "to see the lines, add --lines")?;
    }
    let is_foreign = |file: &Compared<'_>| match &file.found {
        Found::Differs { old, .. } => !ownership::is_ours(old.as_bytes()),
        Found::Same | Found::Missing | Found::LineEnds => false,
    };
    let is_forced = arguments.force || files.iter().any(is_foreign);
    let force = if is_forced { " --force" } else { "" };
    let command = arguments.selection.command();
    writeln!(out, "to bring this up to date, run: {command}{force}")?;
    Ok(false)
}

/// Tells which functions need more operations than they may; true where none does.
fn write_over_budget(out: &mut dyn Write, jobs: &[Job], modules: &[Generated]) -> io::Result<bool> {
    let over = job::over_budget(jobs, modules);
    for (target, lines) in &over {
        writeln!(
            out,
            "{target} is over budget; limits of operations in kane.toml:\n{lines}"
        )?;
    }
    Ok(over.is_empty())
}

/// Tells which files nothing produces; true where there is none.
fn write_strays(
    out: &mut dyn Write,
    jobs: &[Job],
    whole: &Whole,
    strays: &[PathBuf],
) -> io::Result<bool> {
    for stray in strays {
        let list = jobs.iter().find_map(|job| job.asks_for(stray));
        let list = list.unwrap_or_else(|| "list its system".to_owned());
        let (stray, config) = (stray.display(), whole.config.display());
        writeln!(
            out,
            "{stray} is produced by nothing in {config}, or another kane.toml writes here: remove it, or {list}"
        )?;
    }
    Ok(strays.is_empty())
}

/// Tells which files beside the modules stay as they were; true where there is none.
fn write_beside(out: &mut dyn Write, jobs: &[Job]) -> Result<bool, Failures> {
    let beside = stray::beside(jobs)?;
    for (path, asks) in &beside {
        let path = path.display();
        writeln!(
            out,
            "{path} is produced by nothing asked for: {asks}, or remove it"
        )?;
    }
    Ok(beside.is_empty())
}

fn compare<'a>(target: &Target, generated: &'a Generated) -> Result<Vec<Compared<'a>>, Failures> {
    let Target::File(module) = target else {
        return Err(Failures::message(
            "standard output holds nothing to compare with; expected the name of a file after --output",
        ));
    };
    let mut failures = Failures::default();
    let mut compared = Vec::new();
    for (path, new) in generated.files(module) {
        let found = failures.keep(find(&path, new));
        compared.extend(found.map(|found| Compared {
            is_module: path == *module,
            path,
            new,
            found,
        }));
    }
    failures.none()?;
    Ok(compared)
}

fn write_file(
    out: &mut dyn Write,
    file: &Compared<'_>,
    lines: bool,
    voice: Voice,
) -> io::Result<()> {
    let path = file.path.display();
    match &file.found {
        Found::Same => voice.detail(format_args!("{path} is up to date")),
        Found::Missing => writeln!(out, "{path} is missing")?,
        Found::LineEnds => write_line_ends(out, file)?,
        Found::Differs { old, has_crlf } => {
            let diff = TextDiff::new(old, file.new);
            let changed = ChangedLines::of(&diff, old, file.new);
            writeln!(out, "{path} differs: {changed}")?;
            if lines {
                let path = path.to_string();
                let sides = ["as it is", "as generated"].map(|side| (path.as_str(), side));
                write!(out, "{}", diff.unified(sides))?;
            }
            if changed.are_layout() && file.is_rust() {
                writeln!(
                    out,
                    "{path} differs in layout only: `#[rustfmt::skip]` at its `mod` keeps `cargo fmt` from it"
                )?;
            }
            if !ownership::is_ours(old.as_bytes()) {
                writeln!(out, "{path} was not written by `kane generate`")?;
            }
            if *has_crlf {
                write_line_ends(out, file)?;
            }
            write_options(out, file, old)?;
            write_comparison(out, file, old)?;
        }
    }
    Ok(())
}

/// What the file holds where it should hold `text`. Bytes that are not text are replaced: it is only to be shown.
fn find(path: &Path, text: &str) -> Result<Found, Failures> {
    Ok(match output::read(path)? {
        None => Found::Missing,
        Some(bytes) if bytes == text.as_bytes() => Found::Same,
        Some(bytes) => {
            let written = String::from_utf8_lossy(&bytes);
            let old = written.replace("\r\n", "\n");
            if old == text {
                Found::LineEnds
            } else {
                let has_crlf = old.len() != written.len();
                Found::Differs { old, has_crlf }
            }
        }
    })
}

fn write_line_ends(out: &mut dyn Write, file: &Compared<'_>) -> io::Result<()> {
    let path = file.path.display();
    writeln!(
        out,
        "{path} has line ends CR LF; expected LF: write `* text=auto eol=lf` into .gitattributes"
    )
}

/// Tells by which other generator or options the file was generated: what is asked for may have been forgotten.
fn write_options(out: &mut dyn Write, file: &Compared<'_>, old: &str) -> io::Result<()> {
    let Some(format) = origin::format_of(old).filter(|_| file.is_module) else {
        return Ok(());
    };
    let path = file.path.display();
    if format != OUTPUT_FORMAT {
        writeln!(
            out,
            "{path} was generated by another version of kane: in format {format}, this one writes format {OUTPUT_FORMAT}"
        )?;
    }
    let changed = origin::changed_options([old, file.new]);
    let shown = |key: &String, value: &Option<String>| Some(format!("{key}: {}", value.as_ref()?));
    let others = changed.iter().filter_map(|(key, [old, _])| shown(key, old));
    // New functions are told one by one.
    let asked = changed.iter().filter(|(key, _)| *key != "functions");
    let asked = asked.filter_map(|(key, [_, new])| shown(key, new));
    let [others, asked] =
        [others.collect(), asked.collect()].map(|all: Vec<String>| all.join("; "));
    match (others.is_empty(), asked.is_empty()) {
        (true, true) => Ok(()),
        (true, false) => writeln!(out, "{path} was generated without options: {asked}"),
        (false, true) => writeln!(out, "{path} was generated with other options: {others}"),
        (false, false) => writeln!(
            out,
            "{path} was generated with other options: {others}; asked for: {asked}"
        ),
    }
}

fn write_comparison(out: &mut dyn Write, file: &Compared<'_>, old: &str) -> io::Result<()> {
    if !file.is_module {
        return Ok(());
    }
    let path = file.path.display();
    let read = |text| ReadModule::read(text);
    let comparison = match read(old).and_then(|old| Ok(old.compare(&read(file.new)?))) {
        Ok(comparison) => comparison,
        Err(error) => {
            return writeln!(
                out,
                "{path} is not Rust that can be read ({error}): its operations cannot be compared"
            );
        }
    };
    if comparison == Comparison::default() {
        return writeln!(
            out,
            "{path}: every function has as many operations as before"
        );
    }
    let rows = operations::rows(&comparison);
    write!(out, "{path}: operations\n{}", operations::text(&rows))
}
