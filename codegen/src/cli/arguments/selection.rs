//! The arguments that `generate` and `check` share, and which systems they select.
//!
//! In: arguments and, where there is one, `kane.toml`. Out: a [`Selected`]: models, files, options.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use clap::Args;
use kane_codegen::{
    choices::name_of,
    companions::{Abi, CompanionKind},
};

use crate::cli::{
    Failures,
    arguments::options::{Asked, OptionsArguments},
    arguments::parse::{one_of, quoted},
    job::{self, Job},
    listed::{self, Listed},
    paths,
    target::Target,
};

/// Which systems, and what of them.
#[derive(Args, Debug)]
pub(crate) struct Selection {
    /// The model; without it, everything in `kane.toml`
    ///
    /// If the `kane.toml` in the model's folder or the nearest one above lists the model, it gives the output and the options; options
    /// on the command line override it. If it does not list the model, --output names the file. Without `kane.toml` and without
    /// --output, the module goes to the current folder: `panda.rs` for `panda.urdf`.
    #[arg(value_name = "MODEL")]
    model: Option<PathBuf>,

    /// The module's file; for `generate`, `-` is standard output
    ///
    /// The path is relative to the current folder. `kane.toml` gives options only if it lists this model with this file; otherwise
    /// options have their defaults.
    #[arg(long, short, value_name = "FILE", requires = "model")]
    output: Option<PathBuf>,

    /// Also write the manifest beside the module: its contents as JSON, `panda.json` for `panda.rs`
    ///
    /// `--manifest=false` overrides `manifest = true` in `kane.toml`.
    #[arg(
        long,
        value_name = "BOOL",
        requires = "model",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "true"
    )]
    manifest: Option<bool>,

    /// Also write tests of the module beside it, `panda_tests.rs` for `panda.rs`
    ///
    /// `--with-tests=false` overrides `tests = true` in `kane.toml`.
    #[arg(
        long,
        value_name = "BOOL",
        requires = "model",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "true"
    )]
    with_tests: Option<bool>,

    /// Also write an interface for another language beside the module: for C `panda_c.rs` and `panda.h`
    ///
    /// `panda_c.rs` holds `extern "C"` functions for a static library that has both Rust files as modules; `panda.h` declares them.
    #[arg(long, value_name = "WHICH", requires = "model", value_parser = one_of(Abi::ALL))]
    abi: Option<Abi>,

    #[command(flatten)]
    options: OptionsArguments,

    /// The file that lists the systems, instead of the nearest `kane.toml` in the current folder or above it
    /// (with MODEL: in the model's folder or above it)
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
}

/// What is to be generated.
#[derive(Debug)]
pub(crate) struct Selected {
    /// One job a file.
    pub(crate) jobs: Vec<Job>,
    /// The `kane.toml`, if everything in it is to be generated.
    pub(crate) whole: Option<Whole>,
}

/// A `kane.toml` of which everything is to be generated, as it is shown.
#[derive(Debug)]
pub(crate) struct Whole {
    /// The file.
    pub(crate) config: PathBuf,
    /// Its folder, with which the jobs' paths begin.
    pub(crate) root: PathBuf,
}

impl Selection {
    /// What can be asked for beside the module, or not: the option, and what it was given.
    fn switches(&self) -> [(CompanionKind, &'static str, Option<bool>); 2] {
        [
            (CompanionKind::Manifest, "--manifest", self.manifest),
            (CompanionKind::Tests, "--with-tests", self.with_tests),
        ]
    }

    /// The systems that are selected.
    pub(crate) fn read(&self) -> Result<Selected, Failures> {
        let asked = self.options.read().map_err(|mut failures| {
            let lacking = self
                .model
                .as_deref()
                .map(|model| self.options.lacking(model));
            failures.add(lacking.unwrap_or_default());
            failures
        })?;
        match &self.model {
            None => self.whole(),
            Some(model) => {
                let jobs = self.single(model, &asked)?;
                Ok(Selected { jobs, whole: None })
            }
        }
    }

    /// The command that writes what is selected: for the user to copy.
    pub(crate) fn command(&self) -> String {
        let mut command = String::from("kane generate");
        let mut push = |text: &str| {
            command.push(' ');
            command.push_str(&quoted(text));
        };
        if let Some(model) = &self.model {
            let model = model.to_string_lossy();
            if model.starts_with('-') {
                push(&format!("./{model}"));
            } else {
                push(&model);
            }
        }
        if let Some(output) = &self.output {
            push("--output");
            push(&output.to_string_lossy());
        }
        for (_, option, given) in self.switches() {
            match given {
                Some(true) => push(option),
                Some(false) => push(&format!("{option}=false")),
                None => {}
            }
        }
        if let Some(abi) = self.abi {
            push("--abi");
            push(name_of(&abi, &Abi::ALL));
        }
        for word in self.options.words() {
            push(&word);
        }
        if let Some(config) = &self.config {
            push("--config");
            push(&config.to_string_lossy());
        }
        command
    }

    /// Everything in `kane.toml`.
    fn whole(&self) -> Result<Selected, Failures> {
        let path = match (&self.config, paths::config_above(&paths::here()?)) {
            (Some(path), _) => path.clone(),
            (None, Some(path)) => paths::shown(&path)?,
            (None, None) => {
                return Err(Failures::message(
                    "there is no `kane.toml` in this folder or above it; write one, name it with --config, or name a model",
                ));
            }
        };
        let listed = Listed::read_whole(&path)?;
        let mut failures = Failures::default();
        let jobs = listed.config.systems.iter();
        let jobs: Vec<Job> = jobs
            .filter_map(|system| failures.keep(listed.job(system)))
            .collect();
        failures.none()?;
        check_apart(&jobs, &path)?;
        Ok(Selected {
            jobs,
            whole: Some(Whole {
                config: path,
                root: listed.shown_root,
            }),
        })
    }

    /// One model: a job for each file that `kane.toml` has generated from it, or one for the file that was named.
    fn single(&self, model: &Path, asked: &Asked<'_>) -> Result<Vec<Job>, Failures> {
        // A model that cannot be read is told before anything that follows from it.
        job::read(model)?;
        let config = listed::config_of(model, self.config.as_deref())?;
        let (config, listed) = config.unzip();
        let jobs = listed.as_ref().map(|listed| listed.jobs_of(model));
        let mut jobs = jobs.transpose()?.unwrap_or_default();
        let output = match (&self.output, &config) {
            (Some(output), _) => Some(output.clone()),
            (None, None) => Some(own_name(model)),
            (None, Some(_)) => None,
        };
        if let Some(output) = output {
            jobs.retain(|job| job.target.is_same_file(&output));
            if jobs.is_empty() {
                let target = Target::new(&output);
                let shown = listed::shown_model(model, listed.as_ref())?;
                jobs.push(Job::unlisted(model, shown, target));
            }
        }
        if let Some(config) = &config {
            match &jobs[..] {
                [] => return Err(unlisted(model, config)),
                [_] => {}
                // Each would get the same functions, in place of its own.
                several if asked.says_functions() => return Err(ambiguous(config, several)),
                _ => {}
            }
        }
        for job in &mut jobs {
            model.clone_into(&mut job.model);
            let listed = job.options.clone();
            let options = &mut job.options;
            asked.set(options);
            if let Some(listing) = &mut job.listing {
                asked.replace(listing);
            }
            for (kind, _, given) in self.switches() {
                match given {
                    Some(true) => options.companions.insert(kind),
                    Some(false) => options.companions.remove(&kind),
                    None => false,
                };
            }
            options.companions.extend(self.abi.map(CompanionKind::Abi));
            if job.target == Target::StandardOutput {
                self.check_alone()?;
                options.companions.clear();
            } else {
                job.is_overridden = job.listing.is_some() && listed != *options;
            }
        }
        Ok(jobs)
    }

    /// Standard output takes the module alone.
    fn check_alone(&self) -> Result<(), Failures> {
        let switches = self.switches();
        let switches = switches.iter().filter(|(_, _, given)| *given == Some(true));
        let asked = switches.map(|(_, option, _)| *option);
        let mut failures = Failures::default();
        for option in asked.chain(self.abi.map(|_| "--abi")) {
            failures.add(Failures::message(format!(
                "{option} writes beside the module, and standard output takes it alone; name a file with --output"
            )));
        }
        failures.none()
    }
}

/// The file in the current folder that a model's module goes to where nothing says otherwise.
fn own_name(model: &Path) -> PathBuf {
    let name = model.file_name().unwrap_or(model.as_os_str());
    Path::new(name).with_extension("rs")
}

fn ambiguous(config: &Path, jobs: &[Job]) -> Failures {
    let outputs: Vec<String> = jobs.iter().map(|job| format!("`{}`", job.target)).collect();
    Failures::message(format!(
        "`{}` generates {} from this model; say with --output which of them --functions is for",
        config.display(),
        outputs.join(", ")
    ))
}

fn unlisted(model: &Path, config: &Path) -> Failures {
    if Target::File(config.to_owned()).is_same_file(model) {
        return Failures::message(format!(
            "`{}` is a list of models, not a model; pass it with --config",
            model.display()
        ));
    }
    Failures::message(format!(
        "`{}` does not list `{}`; say where to write with --output FILE, where `-` is standard output",
        config.display(),
        model.display()
    ))
}

/// Refuses two systems that write one file, to which links or folders above the `kane.toml` lead in two ways.
fn check_apart(jobs: &[Job], config: &Path) -> Result<(), Failures> {
    let mut failures = Failures::default();
    let mut first: BTreeMap<PathBuf, PathBuf> = BTreeMap::new();
    for file in jobs.iter().flat_map(Job::files) {
        let place = paths::place(&file)?;
        if let Some(first) = first.get(&place) {
            failures.add(Failures::message(format!(
                "two systems of `{}` write one file, `{}` and `{}`",
                config.display(),
                first.display(),
                file.display()
            )));
        }
        first.entry(place).or_insert(file);
    }
    failures.none()
}
