//! One module to generate, and the generation of all that are asked for.

mod explain;
mod reported;

pub(crate) use reported::{Reported, warn};

use std::{
    ffi::OsStr,
    io,
    path::{Path, PathBuf},
    sync::Arc,
};

use kane_codegen::{
    budget::{self, Budget, Excess},
    companions::{Abi, CompanionKind},
    config::{Changed, Named, Prescribed},
    description::{self, Description},
    diagnostic::{Diagnostics, Source, Span},
    error::Error,
    generate::{self, Generated},
    input,
    options::Options,
    tree::{Checked, Tree},
};

use crate::cli::{
    Failures, paths,
    target::Target,
    text::operations::{self, Row},
};

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
    pub(crate) output: Span,
    /// Those that it names there, unless others are asked for.
    pub(crate) functions: Named,
    /// The joints that it prescribes there, unless others are.
    pub(crate) prescribed: Prescribed,
    /// The joints that it locks and removes there, unless others are.
    pub(crate) changed: Changed,
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

    /// Reads the model, checks it and makes the changes.
    pub(crate) fn checked(&self) -> Result<Model, Failures> {
        self.checked_or(|error| self.explained(error))
    }

    fn checked_or(&self, explained: impl Fn(Error) -> Failures) -> Result<Model, Failures> {
        let source = read(&self.model).map_err(|error| self.unreadable(error))?;
        let description = description::read(&source, &self.options.reading, &include(&self.model));
        let checked = generate::checked(&description, &self.options);
        let Checked { tree, warnings } = checked.map_err(explained)?;
        Ok(Model {
            description,
            tree,
            warnings,
        })
    }

    /// The same, and checks what is asked of it, without generating anything.
    pub(crate) fn check_model(&self) -> Result<(), Failures> {
        let Model { tree, .. } = self.checked_or(|error| self.explained_with_lacking(error))?;
        let requests = self.options.requests(&tree);
        requests.map_err(|faults| self.explained(Error::Requests(faults)))?;
        Ok(())
    }

    /// What would ask for a file beside the module, if it can be one.
    pub(crate) fn asks_for(&self, file: &Path) -> Option<String> {
        let Target::File(module) = &self.target else {
            return None;
        };
        let mut kinds = CompanionKind::ALL.into_iter();
        let kind = kinds.find(|kind| kind.beside(module).any(|beside| beside == file))?;
        Some(self.asks_by(kind))
    }

    /// What would ask for files of a kind beside the module.
    pub(crate) fn asks_by(&self, kind: CompanionKind) -> String {
        if self.listing.is_some() {
            return format!("give its system `{}`", kind.key());
        }
        let option = match kind {
            CompanionKind::Manifest => "--manifest",
            CompanionKind::Tests => "--with-tests",
            CompanionKind::Abi(Abi::C) => "--abi c",
        };
        format!("add `{option}`")
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
        // A module is no model, which is said where it is read.
        let may_be_one = self.model.extension() != Some(OsStr::new("rs"));
        if may_be_one && files.iter().any(is_model) {
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

/// Generates every module, or says what is wrong with any of them alone.
pub(crate) fn generate(jobs: &[Job]) -> Result<Vec<Generated>, Failures> {
    let mut failures = Failures::default();
    let modules = jobs.iter();
    let modules: Vec<Generated> = modules
        .filter_map(|job| failures.keep(generate_one(job)))
        .collect();
    failures.none()?;
    Ok(modules)
}

/// The targets with functions that need more operations than they may, with these functions.
pub(crate) fn over_budget<'a>(jobs: &'a [Job], modules: &[Generated]) -> Vec<(&'a Target, String)> {
    let jobs = jobs.iter().zip(modules);
    let over = jobs.filter_map(|(job, module)| {
        let excesses = job.excesses(module);
        let lines = operations::text(&excesses);
        (!excesses.is_empty()).then(|| (&job.target, lines.trim_end().to_owned()))
    });
    over.collect()
}

/// Reads a model.
pub(crate) fn read(model: &Path) -> Result<Source, Error> {
    let text = input::text(model).map_err(|source| {
        let is_standard_input = model == Path::new("-") && source.kind() == io::ErrorKind::NotFound;
        let source = if is_standard_input {
            io::Error::other(
                "there is no such file; only `kane eval --state -` reads standard input",
            )
        } else {
            source
        };
        Error::Io {
            path: model.to_owned(),
            source,
        }
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
    generated.map_err(|error| job.explained_with_lacking(error))
}
