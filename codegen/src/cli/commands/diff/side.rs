//! One of the two things that are compared: a model or a generated module, in a file or in a git revision.

use std::{
    ffi::OsStr,
    io,
    path::{Path, PathBuf},
};

use kane_codegen::{
    description::{self, Reading},
    diagnostic::{Diagnostics, Escaped, Source},
    error::Error,
    generate,
    options::Options,
    report::{Outline, ReadModule},
    tree,
};

use crate::cli::{Failures, git::Revision, job};

/// What is compared, read.
pub(super) struct Side {
    read_from: ReadFrom,
    source: Source,
}

/// Where it was read.
enum ReadFrom {
    File(PathBuf),
    Revision(Revision),
}

/// What is known of it.
pub(super) struct Described {
    /// Its system.
    pub(super) outline: Outline,
    /// What its module says.
    pub(super) module: ReadModule,
    /// The module's text.
    pub(super) text: String,
    /// What should be known about its model; `None` of a module.
    pub(super) warnings: Option<Diagnostics>,
}

impl Described {
    /// What should be known about it, and not of the old one.
    pub(super) fn news(&self, old: &Self) -> Option<Diagnostics> {
        let (own, old) = (self.warnings.as_ref()?, old.warnings.as_ref()?);
        Some(own.without(old))
    }
}

impl Side {
    /// Reads what an argument names: a file where there is one, else a revision.
    pub(super) fn read(argument: &Path) -> Result<Self, Failures> {
        let revision = argument.to_str().and_then(Revision::parse);
        match revision.filter(|_| !argument.exists()) {
            Some(revision) => Self::in_revision(revision),
            None => Self::file(argument),
        }
    }

    /// Reads a file.
    pub(super) fn file(path: &Path) -> Result<Self, Failures> {
        Ok(Self {
            source: job::read(path)?,
            read_from: ReadFrom::File(path.to_owned()),
        })
    }

    /// Reads a file of a revision.
    pub(super) fn in_revision(revision: Revision) -> Result<Self, Failures> {
        Ok(Self {
            source: Source::new(revision.to_string(), revision.read()?),
            read_from: ReadFrom::Revision(revision),
        })
    }

    /// As the user wrote it.
    pub(super) fn name(&self) -> &str {
        self.source.name()
    }

    /// The name of its file.
    pub(super) fn file_name(&self) -> String {
        let path = self
            .name()
            .rsplit_once(':')
            .map_or(self.name(), |(_, path)| path);
        let name = Path::new(path).file_name().unwrap_or_default();
        name.to_string_lossy().escaped()
    }

    /// True for a generated module.
    pub(super) fn is_module(&self) -> bool {
        Path::new(self.name()).extension() == Some(OsStr::new("rs"))
    }

    /// What of this the format of the model leaves to the user.
    pub(super) fn left_open(&self, reading: &Reading) -> Reading {
        description::left_open(&self.source, reading)
    }

    /// Where it stands among the user's files.
    pub(super) fn own_file(&self) -> Option<PathBuf> {
        let path = match &self.read_from {
            ReadFrom::File(path) => Some(path.clone()),
            ReadFrom::Revision(revision) => revision.own_file(),
        };
        path.filter(|path| path.is_file())
    }

    /// What is known of a module.
    pub(super) fn of_module(&self) -> Result<Described, Failures> {
        let failed = |error| Failures::message(format!("`{}`: {error}", self.name()));
        let read = ReadModule::read(self.source.text());
        let module = read.map_err(|error| failed(error.into()))?;
        Ok(Described {
            outline: module.outline().map_err(failed)?.clone(),
            module,
            text: self.source.text().to_owned(),
            warnings: None,
        })
    }

    /// What is known of a model; `shown` is its path in the banner, and `explained` tells why nothing can be generated.
    pub(super) fn of_model(
        &self,
        shown: &str,
        options: &Options,
        explained: impl FnOnce(Error) -> Failures,
    ) -> Result<Described, Failures> {
        let include = |path: &str| self.include(path);
        // What is beside a module says nothing that it does not say.
        let mut options = options.clone();
        options.companions.clear();
        let generated = generate::generate(&self.source, shown, &options, &include);
        let generated = generated.map_err(|error| match error {
            Error::Unrepresentable { .. } | Error::TooLarge { .. } => {
                Failures::message(format!("`{}`: {error}", self.name()))
            }
            error => explained(error),
        })?;
        let description = &generated.description;
        let checked = tree::build_with(description, &options.changes)?;
        Ok(Described {
            outline: Outline::of_model(description, &checked.tree)?,
            module: ReadModule::read(&generated.source).map_err(Failures::message)?,
            text: generated.source,
            warnings: Some(generated.warnings),
        })
    }

    fn include(&self, path: &str) -> io::Result<Vec<u8>> {
        match &self.read_from {
            ReadFrom::File(model) => job::include(model)(path),
            ReadFrom::Revision(revision) => revision.beside(path),
        }
    }
}
