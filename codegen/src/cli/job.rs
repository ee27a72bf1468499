//! One module to generate, and the generation of all that are asked for.

use std::{
    ffi::OsStr,
    fmt, fs, io,
    path::{Path, PathBuf},
    sync::Arc,
};

use kane_codegen::{
    budget::{self, Budget, Excess},
    companions,
    config::{Changed, Named, Prescribed},
    description::{self, Description},
    diagnostic::{Diagnostic, Diagnostics, Source, Span},
    error::Error,
    functions::RequestError,
    generate::{self, Generated},
    input,
    options::Options,
    tree::{self, Checked, PrescribedFault, Tree},
};

use crate::cli::{Failures, Voice, paths, text::operations::Row};

/// A model, what to generate from it, and where that goes.
#[derive(Debug)]
pub(crate) struct Job {
    /// The model, to open and to show.
    pub(crate) model: PathBuf,
    /// The model's path in the banner.
    pub(crate) shown: String,
    /// Where the module goes.
    pub(crate) target: Target,
    /// What is generated.
    pub(crate) options: Options,
    /// How many operations its functions may need.
    pub(crate) budget: Vec<Budget>,
    /// Where it is listed, if it is.
    pub(crate) listing: Option<Listing>,
    /// Whether something else is asked for than there.
    pub(crate) is_overridden: bool,
}

/// Where a `kane.toml` lists a model.
#[derive(Clone, Debug)]
pub(crate) struct Listing {
    pub(crate) config: Arc<Source>,
    pub(crate) model: Span,
    /// Those that it names there, unless others are asked for.
    pub(crate) functions: Named,
    /// The joints that it prescribes there, unless others are.
    pub(crate) prescribed: Prescribed,
    /// The joints that it locks and removes there, unless others are.
    pub(crate) changed: Changed,
}

/// Where a module goes.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// Standard output.
    StandardOutput,
    /// A file, to open and to show.
    File(PathBuf),
}

impl Job {
    /// One with default options, for a model that no `kane.toml` lists.
    pub(crate) fn unlisted(model: &Path, shown: String, target: Target) -> Self {
        Self {
            model: model.to_owned(),
            shown,
            options: Options {
                module: target.module(),
                ..Options::default()
            },
            target,
            budget: Vec::new(),
            listing: None,
            is_overridden: false,
        }
    }

    /// The files that are written: the module, and what is beside it. Standard output takes the module alone.
    pub(crate) fn files(&self) -> Vec<PathBuf> {
        let Target::File(module) = &self.target else {
            return Vec::new();
        };
        let companions = self.options.companions.iter();
        let beside = companions.flat_map(|kind| kind.beside(module));
        std::iter::once(module.clone()).chain(beside).collect()
    }

    /// Why the model cannot be read, where it is listed.
    fn unreadable(&self, error: Error) -> Failures {
        let Some(Listing { config, model, .. }) = &self.listing else {
            return error.into();
        };
        let fault = Diagnostic::error(format!("{error:?}")).at(*model, "listed here");
        Diagnostics::new(Source::clone(config), vec![fault]).into()
    }

    /// Why what is asked for cannot be had of the model, each fault at its place where it has one.
    fn not_had(&self, faults: Vec<RequestError>) -> Failures {
        let Some(listing) = &self.listing else {
            return Error::Requests(faults).into();
        };
        let (mut placed, mut others) = (Vec::new(), Vec::new());
        for fault in faults {
            match listing.functions.fault(&fault) {
                Some(fault) => placed.push(fault.at(listing.model, "the model")),
                None => others.push(fault),
            }
        }
        let mut failures = Failures::from(Error::Requests(others));
        if !placed.is_empty() {
            failures.add(Diagnostics::new(Source::clone(&listing.config), placed));
        }
        failures
    }

    /// Why nothing can be generated, each fault at its place where it has one.
    pub(crate) fn explained(&self, error: Error) -> Failures {
        match error {
            Error::Invalid(found) => self.refused(found),
            Error::Requests(faults) => self.not_had(faults),
            Error::Prescribed(faults) => self.not_prescribed(faults),
            error => error.into(),
        }
    }

    /// What is wrong with the model, and with what is changed of it, at its place where it has one.
    fn refused(&self, found: Diagnostics) -> Failures {
        let Some(listing) = &self.listing else {
            return found.into();
        };
        let (mut placed, mut others) = (Vec::new(), Vec::new());
        for fault in found.list() {
            match listing.changed.fault(fault) {
                Some(fault) => placed.push(fault.at(listing.model, "the model")),
                None => others.push(fault.clone()),
            }
        }
        let mut failures = Failures::default();
        for (source, faults) in [(found.source(), others), (&listing.config, placed)] {
            if !faults.is_empty() {
                failures.add(Diagnostics::new(source.clone(), faults));
            }
        }
        failures
    }

    /// Why joints cannot be prescribed, each at its place where it has one.
    fn not_prescribed(&self, faults: Vec<PrescribedFault>) -> Failures {
        let listing = self.listing.as_ref();
        let placed = |fault: &PrescribedFault| {
            let listing = listing?;
            let placed = listing.prescribed.fault(fault)?;
            let placed = placed.at(listing.model, "the model");
            let placed = Diagnostics::new(Source::clone(&listing.config), vec![placed]);
            Some(Failures::from(placed))
        };
        let mut failures = Failures::default();
        for fault in faults {
            match placed(&fault) {
                Some(placed) => failures.add(placed),
                None => failures.add(Error::Prescribed(vec![fault])),
            }
        }
        failures
    }

    /// Reads the model, checks it and makes the changes.
    pub(crate) fn checked(&self) -> Result<Model, Failures> {
        let source = read(&self.model).map_err(|error| self.unreadable(error))?;
        let Options {
            reading,
            changes,
            prescribed,
            ..
        } = &self.options;
        let description = description::read(&source, reading, &include(&self.model));
        let checked = tree::build_with(&description, changes);
        let Checked { tree, warnings } = checked.map_err(|found| self.refused(found))?;
        let tree = tree::prescribe(&description, tree, prescribed);
        let tree = tree.map_err(|faults| self.not_prescribed(faults))?;
        Ok(Model {
            description,
            tree,
            warnings,
        })
    }

    /// The same, and checks what is asked of it, without generating anything.
    pub(crate) fn check_model(&self) -> Result<(), Failures> {
        let Model { tree, .. } = self.checked()?;
        let requests = self.options.requests(&tree);
        requests.map_err(|faults| self.not_had(faults))?;
        Ok(())
    }

    /// What would ask for a file beside the module, if it can be one.
    pub(crate) fn asks_for(&self, file: &Path) -> Option<&'static str> {
        let Target::File(module) = &self.target else {
            return None;
        };
        let mut kinds = companions::CompanionKind::ALL.into_iter();
        let kind = kinds.find(|kind| kind.beside(module).any(|beside| beside == file))?;
        Some(kind.key())
    }

    /// What goes beyond the budget, a line each.
    pub(crate) fn excesses(&self, generated: &Generated) -> Vec<Row> {
        let functions = [&generated.functions[..], &generated.asked_of_frames].concat();
        let excesses = budget::exceeded(&self.budget, &functions);
        let row = |excess: &Excess<'_>| {
            let (count, limit) = (excess.count, excess.budget.limit);
            [
                excess.budget.kind.name().to_owned(),
                excess.budget.function.clone(),
                format!("{count}, of {limit} (+{})", count - limit),
            ]
        };
        excesses.iter().map(row).collect()
    }

    /// Refuses files that would replace the model, and a module that Rust would not take for one.
    fn check_files(&self) -> Result<(), Failures> {
        let files = self.files();
        let is_model = |file: &PathBuf| Target::File(file.clone()).is_same_file(&self.model);
        if files.iter().any(is_model) {
            let model = self.model.display();
            return Err(Failures::message(format!(
                "`{model}` is the model; the module needs a file of its own"
            )));
        }
        match files.first() {
            Some(module) if module.extension() != Some(OsStr::new("rs")) => {
                let module = module.display();
                Err(Failures::message(format!(
                    "`{module}` is to be a module; expected a file that ends in `.rs`, or `-`; other files are written beside it"
                )))
            }
            _ => Ok(()),
        }
    }
}

impl Target {
    /// What `--output` means.
    pub(crate) fn new(output: &Path) -> Self {
        if output == Path::new("-") {
            Self::StandardOutput
        } else {
            Self::File(output.to_owned())
        }
    }

    /// The module's name: that of its file, without the ending.
    pub(crate) fn module(&self) -> String {
        match self {
            Self::StandardOutput => String::new(),
            Self::File(module) => {
                let name = module.file_stem().unwrap_or_default();
                name.to_string_lossy().into_owned()
            }
        }
    }

    /// True where the target is the file to which `path` leads.
    pub(crate) fn is_same_file(&self, path: &Path) -> bool {
        let place = |path: &Path| {
            let folder = fs::canonicalize(paths::parent(path)).ok()?;
            Some((folder, path.file_name()?.to_owned()))
        };
        match self {
            Self::StandardOutput => false,
            Self::File(file) => {
                file == path || place(file).is_some_and(|file| Some(file) == place(path))
            }
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StandardOutput => f.write_str("standard output"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

/// Generates every module, or says what is wrong with any of them.
pub(crate) fn generate(jobs: &[Job]) -> Result<Vec<Generated>, Failures> {
    let mut failures = Failures::default();
    let modules = jobs.iter();
    let modules: Vec<Generated> = modules
        .filter_map(|job| failures.keep(generate_one(job)))
        .collect();
    failures.none()?;
    Ok(modules)
}

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

/// Reads a model.
pub(crate) fn read(model: &Path) -> Result<Source, Error> {
    let text = input::text(model).map_err(|source| Error::Io {
        path: model.to_owned(),
        source,
    })?;
    Ok(Source::new(model.to_string_lossy(), text))
}

/// Reads the files that a model names: their paths are relative to its folder.
pub(crate) fn include(model: &Path) -> impl Fn(&str) -> io::Result<Vec<u8>> {
    |path| input::named(&paths::parent(model).join(path))
}

/// A model that was read and checked.
pub(crate) struct Model {
    pub(crate) description: Description,
    pub(crate) tree: Tree,
    pub(crate) warnings: Diagnostics,
}

fn generate_one(job: &Job) -> Result<Generated, Failures> {
    job.check_files()?;
    let source = read(&job.model).map_err(|error| job.unreadable(error))?;
    let include = include(&job.model);
    let generated = generate::generate(&source, &job.shown, &job.options, &include);
    generated.map_err(|error| match error {
        Error::Unrepresentable { .. } | Error::TooLarge { .. } => {
            Failures::message(format!("`{}`: {error}", job.model.display()))
        }
        error => job.explained(error),
    })
}
