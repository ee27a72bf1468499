//! `kane verify`.

use std::{
    fs,
    io::{self, Write},
    path::{Path, PathBuf},
    process::Command,
};

use clap::{Args, ValueEnum};
use kane_codegen::{
    diagnostic::first_few,
    error::Error,
    functions::N_BODIES,
    object::{self, OptLevel, Options, Report, Runtime, Scalar},
    ownership::is_ours,
};
use serde_json::{Value, json};

use crate::cli::{Failures, Outcome, Voice, arguments::parse::one_of, paths, runtime, text::json};

/// Check the machine code of generated functions against the guarantees
///
/// Compiles each module with rustc and reads every instruction of its functions. No function may jump, except in loops of
/// fixed length: over the columns or branches of a helper, or the pages of a large stack. A function may call only its own stages and
/// helpers and the runtime's sines and cosines, which are checked too; so no function can panic. It may access only its arguments, its
/// stack and constants, and no address may depend on a value. The output is a table (bytes of machine code, bytes of stack,
/// instructions per call) and a list of broken promises. The numbers depend on the compiler, its target and its options. Files beside
/// the modules, the functions for C and the tests, are skipped. Rust files that `kane` did not write are skipped too, beside a module.
#[derive(Args, Debug)]
#[command(after_long_help = "Exit codes:\n  \
    0  every promise holds\n  \
    1  a promise is broken\n  \
    2  a module that cannot be read or compiled, or machine code that cannot be read (only x86-64 in ELF can)\n\n\
    Examples:\n  \
    kane verify src/arm.rs\n  \
    kane verify generated/*.rs --opt-level 2 --scalar f32")]
pub(crate) struct Arguments {
    /// Generated modules
    #[arg(value_name = "FILE", required = true)]
    modules: Vec<PathBuf>,

    /// Check machine code; the only check, so this option is not needed
    #[arg(long)]
    object: bool,

    /// The scalar type of the functions
    #[arg(long, value_name = "WHICH", default_value = "f64", value_parser = one_of(Scalar::ALL))]
    scalar: Scalar,

    /// rustc's optimization level
    #[arg(long, value_name = "LEVEL", default_value = "3", value_parser = one_of(OptLevel::ALL))]
    opt_level: OptLevel,

    /// Output format
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Text)]
    format: Format,

    /// The target CPU, as rustc names it; without it, the baseline of the architecture
    #[arg(long, value_name = "NAME")]
    target_cpu: Option<String>,

    /// The folder of the crate `kane`; without it, the `kane` on which the package of the first module depends
    #[arg(long, value_name = "FOLDER")]
    kane: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Tables
    Text,
    /// JSON, for programs
    Json,
}

/// Compiles and reads.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let options = Options {
        scalar: arguments.scalar,
        opt_level: arguments.opt_level,
        target_cpu: arguments.target_cpu.clone(),
    };
    let root = if let Some(folder) = &arguments.kane {
        runtime::folder(folder)?;
        folder.join("src/lib.rs")
    } else {
        // Where no package is found, a path that is missing or is no module is the likely reason.
        let root = depended_on(&arguments.modules[0]);
        root.map_err(|unknown| check_modules(&arguments.modules).err().unwrap_or(unknown))?
    };
    let runtime = Runtime::new(&root, &options)?;
    let all = arguments.modules.iter();
    let (beside, modules): (Vec<&PathBuf>, Vec<&PathBuf>) = all.partition(|path| is_beside(path));
    if modules.is_empty() {
        return Err(Failures::message(format!(
            "`{}` stands beside a module; expected the module",
            beside[0].display()
        )));
    }
    if !beside.is_empty() {
        voice.say(format_args!(
            "note: {} of the files stand beside modules; they are not checked",
            beside.len()
        ));
    }
    let reports = reports(&runtime, &modules, voice)?;
    match arguments.format {
        Format::Text => {
            for (path, report) in &reports {
                write_report(out, path, report)?;
            }
        }
        Format::Json => {
            let reports = reports.iter().map(|(path, report)| value(path, report));
            json::write(out, &reports.collect())?;
        }
    }
    let holds = reports.iter().all(|(_, report)| report.holds());
    Ok(if holds {
        Outcome::Done
    } else {
        Outcome::Broken
    })
}

/// What was found of each module. Sources that are not generated, such as `src/lib.rs` of `src/*.rs`, are no fault beside modules.
fn reports<'a>(
    runtime: &Runtime,
    modules: &[&'a PathBuf],
    voice: Voice,
) -> Result<Vec<(&'a Path, Report)>, Failures> {
    let (mut failures, mut reports, mut others) = (Failures::default(), Vec::new(), Vec::new());
    for &path in modules {
        match object::verify(runtime, path) {
            Err(object::Error::NoFunctions { .. }) if !is_generated(path) => others.push(path),
            found => reports.extend(failures.keep(found).map(|report| (path.as_path(), report))),
        }
    }
    if reports.is_empty() {
        for path in others {
            let path = path.clone();
            failures.keep(Err::<Report, _>(object::Error::NoFunctions { path }));
        }
    } else if !others.is_empty() {
        let names = others.iter().map(|path| format!("`{}`", path.display()));
        let names: Vec<String> = names.collect();
        voice.say(format_args!(
            "note: not checked, for `kane` did not write it: {}",
            first_few(&names)
        ));
    }
    failures.none()?;
    Ok(reports)
}

/// Refuses what is not there, and what cannot be a module.
fn check_modules(modules: &[PathBuf]) -> Result<(), Failures> {
    let mut failures = Failures::default();
    for path in modules {
        let opened = fs::metadata(path).map_err(|source| Error::Io {
            path: path.clone(),
            source,
        });
        let Some(opened) = failures.keep(opened) else {
            continue;
        };
        let is_rust = path.extension().is_some_and(|ending| ending == "rs");
        let what = match (opened.is_dir(), is_rust) {
            (true, _) => "is a folder",
            (false, false) => "is no Rust file",
            (false, true) => continue,
        };
        failures.add(Failures::message(format!(
            "`{}` {what}; expected a generated module, such as `src/arm.rs`",
            path.display()
        )));
    }
    failures.none()
}

/// True for a generated file without bodies: the functions for C, the tests.
fn is_beside(path: &Path) -> bool {
    let text = text_of(path);
    is_ours(text.as_bytes()) && !text.contains(&format!("pub const {N_BODIES}: "))
}

/// True for a file that `kane` wrote.
fn is_generated(path: &Path) -> bool {
    is_ours(text_of(path).as_bytes())
}

/// What a file holds; nothing of what is no file, which may never end.
fn text_of(path: &Path) -> String {
    let text = path.is_file().then(|| fs::read_to_string(path).ok());
    text.flatten().unwrap_or_default()
}

fn value(path: &Path, report: &Report) -> Value {
    let functions = report.all().map(|function| {
        let breaches = function.breaches.iter().map(|breach| {
            json!({
                "offset": breach.offset, "instruction": breach.instruction, "what": breach.what.to_string(),
            })
        });
        json!({
            "name": function.name,
            "text_bytes": function.text,
            "stack_bytes": function.stack,
            "instructions": function.instructions,
            "breaches": breaches.collect::<Value>(),
        })
    });
    json!({
        "module": path.display().to_string(),
        "holds": report.holds(),
        "functions": functions.collect::<Value>(),
    })
}

/// The root file of the crate `kane` that cargo compiles for the package of this module.
fn depended_on(module: &Path) -> Result<PathBuf, Failures> {
    // Another error tells of a module that is not there.
    let folder = paths::parent(module);
    let folder = if folder.is_dir() {
        folder
    } else {
        Path::new(".")
    };
    let failure = |what: &str| {
        Failures::message(format!(
            "{what}; the folder of the crate `kane` can be given with --kane"
        ))
    };
    let output = Command::new("cargo")
        .args(["metadata", "--format-version=1"])
        .current_dir(folder)
        .output()
        .map_err(|error| failure(&format!("cannot run cargo: {error}")))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(failure(&format!("cargo says: {}", said.trim_end())));
    }
    let metadata: Value = serde_json::from_slice(&output.stdout)
        .map_err(|error| failure(&format!("cargo's metadata cannot be read: {error}")))?;
    let list = |value: &Value, key: &str| value[key].as_array().cloned().unwrap_or_default();
    let packages = list(&metadata, "packages");
    let packages = packages.iter().filter(|package| package["name"] == "kane");
    let targets = packages.flat_map(|package| list(package, "targets"));
    let roots: Vec<PathBuf> = targets
        .filter(|target| list(target, "kind").contains(&Value::from("lib")))
        .filter_map(|target| target["src_path"].as_str().map(PathBuf::from))
        .collect();
    match &roots[..] {
        [root] => Ok(root.clone()),
        [] => Err(failure(
            "the package of the module does not depend on `kane`",
        )),
        _ => Err(failure(
            "the package of the module depends on several versions of `kane`",
        )),
    }
}

fn write_report(out: &mut dyn Write, path: &Path, report: &Report) -> io::Result<()> {
    let width = report.all().map(|function| function.name.len()).max();
    let width = width.unwrap_or(0).max("function".len());
    writeln!(out, "{}\n", path.display())?;
    writeln!(
        out,
        "{:width$}  text bytes  stack bytes  instructions",
        "function"
    )?;
    for function in report.all() {
        let (name, text, stack) = (&function.name, function.text, function.stack);
        let instructions = function.instructions;
        writeln!(
            out,
            "{name:width$}  {text:10}  {stack:11}  {instructions:12}"
        )?;
    }
    writeln!(out)?;
    if report.holds() {
        return writeln!(out, "every promise holds\n");
    }
    for function in report.all() {
        for breach in &function.breaches {
            let (name, instruction, what) = (&function.name, &breach.instruction, &breach.what);
            writeln!(
                out,
                "{name} at {:#x}, `{instruction}`: {what}",
                breach.offset
            )?;
        }
    }
    writeln!(out)
}
