//! All systems of a repository, in two revisions or in one and as the files are.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
};

use kane_codegen::diagnostic::{Diagnostics, Escaped, Severity, Source};

use super::{report::Report, side::Side};
use crate::cli::{
    Failures,
    arguments::options::Asked,
    git::{self, Revision},
    job::Job,
    listed::Listed,
};

/// What differs between two snapshots.
pub(super) struct Systems {
    /// What the snapshots are called.
    pub(super) names: [String; 2],
    /// Modules of both that differ.
    pub(super) changed: Vec<Report>,
    /// Generated files of the new one alone.
    pub(super) added: Vec<String>,
    /// Generated files of the old one alone.
    pub(super) removed: Vec<String>,
    /// What should be known about new models alone, also of those whose modules are the same.
    pub(super) warnings: Vec<Diagnostics>,
}

/// What was told of models, so that it is not told again of other systems of these.
#[derive(Default)]
struct Told {
    /// By the names of the models.
    of: BTreeMap<String, Diagnostics>,
}

impl Told {
    /// What is not told yet.
    fn news(&mut self, warnings: &Diagnostics) -> Option<Diagnostics> {
        let source = warnings.source();
        let none = || Diagnostics::new(source.clone(), Vec::new());
        let told = self.of.entry(source.name().to_owned());
        let told = told.or_insert_with(none);
        let news = warnings.without(told);
        told.extend(news.list().iter().cloned());
        (!news.is_empty()).then_some(news)
    }
}

/// A state of the repository's files.
#[derive(Clone, Debug)]
pub(super) enum Snapshot {
    /// A git revision.
    Revision(String),
    /// The files as they are.
    Files,
}

impl Snapshot {
    /// The revision that an argument names, where no file has that name.
    pub(super) fn of(argument: &Path) -> Option<Self> {
        let name = argument.to_str()?;
        let is_revision = !argument.exists() && !name.contains(':') && git::is_commit(name);
        is_revision.then(|| Self::Revision(name.to_owned()))
    }

    fn name(&self) -> &str {
        match self {
            Self::Revision(name) => name,
            Self::Files => "the files as they are",
        }
    }

    /// A file's name in it; the path is relative to the current folder.
    fn file(&self, path: &Path) -> Result<String, Failures> {
        match self {
            Self::Revision(name) => Ok(Revision::of(name, path)?.to_string()),
            Self::Files => Ok(path.display().to_string()),
        }
    }

    /// The systems that it lists, or that it has no such file.
    fn jobs(&self, config: &Path, asked: &Asked<'_>) -> Result<Option<Vec<Job>>, Failures> {
        let listed = match self {
            Self::Revision(name) => {
                let revision = Revision::of(name, config)?;
                if !revision.exists() {
                    return Ok(None);
                }
                Listed::of(config, Source::new(revision.to_string(), revision.read()?))?
            }
            Self::Files => Listed::read(config)?,
        };
        let jobs = listed.config.systems.iter().map(|system| {
            let mut job = listed.job(system)?;
            asked.set(&mut job.options);
            if let Some(listing) = &mut job.listing {
                asked.replace(listing);
            }
            Ok(job)
        });
        jobs.collect::<Result<_, _>>().map(Some)
    }

    /// A model in it.
    fn model(&self, path: &Path) -> Result<Side, Failures> {
        match self {
            Self::Revision(name) => Side::in_revision(Revision::of(name, path)?),
            Self::Files => Side::file(path),
        }
    }
}

impl Systems {
    /// Compares what the `kane.toml` of each snapshot lists: a system is known by its module. One of them may have none.
    pub(super) fn compare(
        snapshots: [&Snapshot; 2],
        config: &Path,
        asked: &Asked<'_>,
    ) -> Result<Self, Failures> {
        let mut failures = Failures::default();
        let jobs = snapshots.map(|snapshot| failures.keep(snapshot.jobs(config, asked)));
        let [Some(old), Some(new)] = jobs else {
            return Err(failures);
        };
        if old.is_none() && new.is_none() {
            let [old, new] = snapshots.map(Snapshot::name);
            let config = config.to_string_lossy();
            return Err(Failures::message(format!(
                "neither `{old}` nor `{new}` has a file `{}`",
                config.escaped()
            )));
        }
        let [old, new] = [old, new].map(Option::unwrap_or_default);
        let of = |jobs: &[Job], job: &Job| {
            let mut places = jobs.iter();
            places.position(|one| one.target == job.target)
        };
        let only = |jobs: &[Job], others: &[Job]| -> Vec<String> {
            let others: BTreeSet<PathBuf> = others.iter().flat_map(Job::files).collect();
            let own = jobs.iter().flat_map(Job::files);
            let own = own.filter(|file| !others.contains(file));
            own.map(|file| file.display().to_string()).collect()
        };
        let (mut changed, mut warnings, mut told) = (Vec::new(), Vec::new(), Told::default());
        for job in &new {
            if let Some(place) = of(&old, job) {
                let report = report(snapshots, [&old[place], job]);
                let report = failures.keep(report);
                let own = report.iter().filter_map(|report| report.warnings.as_ref());
                warnings.extend(own.filter_map(|own| told.news(own)));
                changed.extend(report.filter(|report| !report.is_same()));
            }
        }
        failures.none()?;
        Ok(Self {
            names: snapshots.map(|snapshot| snapshot.name().to_owned()),
            changed,
            added: only(&new, &old),
            removed: only(&old, &new),
            warnings,
        })
    }

    pub(super) fn is_same(&self) -> bool {
        self.changed.is_empty() && self.added.is_empty() && self.removed.is_empty()
    }

    /// Each model with what is probably wrong in it.
    pub(super) fn warnings(&self) -> impl Iterator<Item = [&str; 2]> {
        self.warnings.iter().flat_map(|of_model| {
            let all = of_model.list().iter();
            let warnings = all.filter(|one| one.severity != Severity::Note);
            warnings.map(|one| [of_model.source().name(), one.message.as_str()])
        })
    }

    /// True where a file went, or code that uses one must change.
    pub(super) fn is_breaking(&self) -> bool {
        !self.removed.is_empty() || self.breaking().next().is_some()
    }

    /// What differs of modules whose users must change.
    pub(super) fn breaking(&self) -> impl Iterator<Item = &Report> {
        let changed = self.changed.iter();
        changed.filter(|report| report.is_breaking())
    }
}

/// What differs between a system's modules.
fn report(snapshots: [&Snapshot; 2], jobs: [&Job; 2]) -> Result<Report, Failures> {
    let mut failures = Failures::default();
    let mut read = |place: usize| {
        let (snapshot, job): (&Snapshot, &Job) = (snapshots[place], jobs[place]);
        let known = snapshot.model(&job.model).and_then(|model| {
            model.of_model(&job.shown, &job.options, |error| job.explained(error))
        });
        failures.keep(known)
    };
    let (Some(old), Some(new)) = (read(0), read(1)) else {
        return Err(failures);
    };
    let module = jobs[1].files();
    let module = module.first().map_or(Path::new(""), |file| file);
    let names = [snapshots[0].file(module)?, snapshots[1].file(module)?];
    let names = names.each_ref().map(String::as_str);
    Ok(Report::new(names, [&old, &new]))
}
