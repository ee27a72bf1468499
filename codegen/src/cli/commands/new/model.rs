//! The model on its way into the package: one file, read as it will be read there.

use std::{cell::Cell, path::Path};

use kane_codegen::{
    description::{self, Reading, toml},
    diagnostic::{Diagnostics, Source},
    options::Options,
    tree::{self, Changes, Checked, Tree},
};

use crate::cli::{Failures, job};

/// The model where none is given.
const PENDULUM: &str = include_str!("pendulum.toml");

/// A model that needs no other file.
pub(super) struct Model {
    /// Its text, and the name of its file in the package.
    pub(super) source: Source,
    /// How it is read there.
    pub(super) reading: Reading,
    pub(super) tree: Tree,
    pub(super) warnings: Diagnostics,
}

impl Model {
    pub(super) fn pendulum(name: &str) -> Result<Self, Failures> {
        let source = Source::new(format!("{name}.toml"), PENDULUM);
        let reading = Reading::default();
        let description = description::read(&source, &reading, &description::no_includes);
        let Checked { tree, warnings } = tree::build_with(&description, &Changes::default())?;
        Ok(Self {
            source,
            reading,
            tree,
            warnings,
        })
    }

    /// The model at a path; one that needs other files in our own format, which holds what they say.
    pub(super) fn read(path: &Path, options: &Options, name: &str) -> Result<Self, Failures> {
        let source = job::read(path)?;
        let needs_others = Cell::new(false);
        let include = |other: &str| {
            needs_others.set(true);
            job::include(path)(other)
        };
        let Options {
            reading, changes, ..
        } = options;
        let description = description::read(&source, reading, &include);
        let Checked { tree, warnings } = tree::build_with(&description, changes)?;
        let (source, reading) = if needs_others.get() {
            let text = toml::write(&description)?;
            (
                Source::new(format!("{name}.toml"), text),
                Reading::default(),
            )
        } else {
            let file = path.file_name().unwrap_or_default();
            (
                Source::new(file.to_string_lossy(), source.text()),
                reading.clone(),
            )
        };
        Ok(Self {
            source,
            reading,
            tree,
            warnings,
        })
    }
}
