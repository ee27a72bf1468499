//! What a `kane.toml` lists, as jobs.
//!
//! In: the file's path. Out: its systems, with paths that can be opened from the current folder, and the path of each model
//! as it stands in a banner: relative to the file, whatever the current folder.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::Arc,
};

use kane_codegen::{
    config::{self, Config, System, clean_path},
    diagnostic::{Escaped, Source},
};

use crate::cli::{
    Failures,
    arguments::{changes::ChangesArguments, functions::are_listed},
    job::{self, Job, Listing},
    paths,
    target::Target,
};

/// A `kane.toml` that was read.
pub(crate) struct Listed {
    /// Its systems.
    pub(crate) config: Config,
    source: Arc<Source>,
    /// Its folder, absolute.
    root: PathBuf,
    /// Its folder, as it is shown.
    pub(crate) shown_root: PathBuf,
}

impl Listed {
    pub(crate) fn read(path: &Path) -> Result<Self, Failures> {
        Self::of(path, job::read(path)?)
    }

    /// Reads it, to generate everything in it: beside its faults those of its models are told.
    pub(crate) fn read_whole(path: &Path) -> Result<Self, Failures> {
        let source = job::read(path)?;
        let (config, faults) = config::read(&source);
        let listed = Self::new(path, source, config);
        let Err(faults) = faults else {
            return listed;
        };
        let mut failures = Failures::from(faults);
        if let Some(listed) = failures.keep(listed) {
            for system in &listed.config.systems {
                let checked = listed.job(system).and_then(|job| job.check_model());
                failures.keep(checked);
            }
        }
        Err(failures)
    }

    /// Reads it for one model. What is wrong with the file is told only if it lists the model, or may list it: nothing else of
    /// it has to do with the model.
    fn read_for(path: &Path, model: &Path) -> Result<Self, Failures> {
        let source = job::read(path)?;
        let (config, faults) = config::read(&source);
        let listed = Self::new(path, source, config)?;
        match faults {
            Err(faults) if listed.may_list(model)? => {
                let mut failures = Failures::from(faults);
                let (config, model) = (path.display(), model.display());
                failures.add(Failures::note(format_args!(
                    "`{config}` was read because it may list `{model}`, with options for it"
                )));
                Err(failures)
            }
            _ => Ok(listed),
        }
    }

    /// Reads a text that stands at this path, among the files or in a revision.
    pub(crate) fn of(path: &Path, source: Source) -> Result<Self, Failures> {
        let config = config::parse(&source)?;
        Self::new(path, source, config)
    }

    fn new(path: &Path, source: Source, config: Config) -> Result<Self, Failures> {
        let root = paths::target(paths::parent(path))?;
        let shown_root = paths::shown(&root)?;
        Ok(Self {
            config,
            source: Arc::new(source),
            root,
            shown_root,
        })
    }

    pub(crate) fn job(&self, system: &System) -> Result<Job, Failures> {
        let place = |text: &str| self.shown_root.join(clean_path(Path::new(text)));
        let relative = clean_path(Path::new(&system.model.value));
        let model = place(&system.model.value);
        let shown = paths::with_slashes(&relative).ok_or_else(|| cannot_be_shown(&model))?;
        Ok(Job {
            shown,
            target: Target::File(place(&system.output.value)),
            options: system.options.clone(),
            budget: system.budget.clone(),
            listing: Some(Listing {
                config: Arc::clone(&self.source),
                model: system.model.span,
                output: system.output.span,
                functions: system.named.clone(),
                prescribed: system.prescribed.clone(),
                changed: system.changed.clone(),
            }),
            is_overridden: false,
            model,
        })
    }

    /// The jobs whose model is this very file.
    pub(crate) fn jobs_of(&self, model: &Path) -> Result<Vec<Job>, Failures> {
        let file = paths::target(model)?;
        let systems = self.config.systems.iter();
        let systems = systems.filter(|system| self.is_file(&system.model.value, &file));
        systems.map(|system| self.job(system)).collect()
    }

    /// False if no system's model is this very file, as far as that is known whatever is wrong with the systems.
    fn may_list(&self, model: &Path) -> Result<bool, Failures> {
        let file = paths::target(model)?;
        let mut models = self.config.models.iter().flatten();
        Ok(self.config.models.is_none() || models.any(|listed| self.is_file(listed, &file)))
    }

    /// True if the model of this path in the file is the file with this absolute path.
    fn is_file(&self, listed: &str, file: &Path) -> bool {
        fs::canonicalize(self.root.join(listed)).is_ok_and(|listed| listed == file)
    }
}

/// The `kane.toml` for one model: the one that is named, or the nearest in its folder or above it.
///
/// One that was not named may have faults if it surely does not list the model.
pub(crate) fn config_of(
    model: &Path,
    named: Option<&Path>,
) -> Result<Option<(PathBuf, Listed)>, Failures> {
    if let Some(path) = named {
        return Ok(Some((path.to_owned(), Listed::read(path)?)));
    }
    let Some(above) = paths::config_above(&paths::target(paths::parent(model))?) else {
        return Ok(None);
    };
    let path = paths::shown(&above)?;
    let listed = Listed::read_for(&path, model)?;
    Ok(Some((path, listed)))
}

/// A model to look at: as the first system of its `kane.toml` has it that lists it with the functions that are asked for, or the first
/// that lists it at all, or by default options; with these changes.
pub(crate) fn looked_at(
    model: &Path,
    changes: &ChangesArguments,
    asked: &[String],
) -> Result<Job, Failures> {
    changes.check()?;
    job::read(model)?;
    let listed = config_of(model, None)?;
    let jobs = listed.map(|(_, listed)| listed.jobs_of(model));
    let mut jobs = jobs.transpose()?.unwrap_or_default();
    let with_them = jobs
        .iter()
        .position(|job| are_listed(asked, &job.options.functions));
    let chosen = with_them.or((!jobs.is_empty()).then_some(0));
    let mut job = match chosen.map(|place| jobs.swap_remove(place)) {
        Some(job) => job,
        None => Job::unlisted(model, shown_model(model, None)?, Target::StandardOutput),
    };
    model.clone_into(&mut job.model);
    changes.set(&mut job.options);
    if let Some(listing) = &mut job.listing {
        changes.replace(listing);
    }
    Ok(job)
}

/// The model's path as the banner shows it: relative to `kane.toml`, else the file's name.
pub(crate) fn shown_model(model: &Path, listed: Option<&Listed>) -> Result<String, Failures> {
    let name = model.file_name().unwrap_or_default();
    let folder = paths::target(paths::parent(model))?;
    let relative = listed.and_then(|listed| paths::relative(&listed.root, &folder.join(name)));
    let shown = relative.unwrap_or_else(|| PathBuf::from(name));
    paths::with_slashes(&shown).ok_or_else(|| cannot_be_shown(model))
}

fn cannot_be_shown(model: &Path) -> Failures {
    let text = model.to_string_lossy();
    let text = text.escaped();
    Failures::message(format!(
        "`{text}` cannot stand in a generated file: expected the path of a file, in printable characters"
    ))
}
