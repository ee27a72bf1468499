//! The pipeline: a description's text in, a module's text out, with the files beside it.

pub use crate::origin::OUTPUT_FORMAT;

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use crate::{
    companions::{self, Companion, Ingredients},
    compile,
    description::{self, Description, Include},
    diagnostic::{Diagnostics, Source},
    error::Error,
    listing::Module,
    options::Options,
    origin::Origin,
    printers::rust,
    program::Operations,
    tree::{self, Checked},
};

/// A generated module, and the files beside it.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The module's text.
    pub source: String,
    /// The files beside it.
    pub companions: Vec<Companion>,
    /// The functions that it holds, with their operations.
    pub functions: Vec<(String, Operations)>,
    /// What those of frames were asked for as: how they are called, the model says.
    pub asked_of_frames: Vec<(String, Operations)>,
    /// What the model says, as it was read.
    pub description: Description,
    /// What the user should know about it; never errors.
    pub warnings: Diagnostics,
}

/// Generates a module from a model in any of the formats.
///
/// `model` is known in diagnostics by its own name, and in the banner by `shown_path`: relative to `kane.toml`, so that
/// the text is the same in every folder. `include` reads the files that the model names:
/// [`description::no_includes`] for one that stands alone.
///
/// # Errors
/// [`Error::Invalid`] with every rule that the description breaks; [`Error::Prescribed`]; options that cannot be; [`Error::TooLarge`]; [`Error::Unrepresentable`].
pub fn generate(
    model: &Source,
    shown_path: &str,
    options: &Options,
    include: Include<'_>,
) -> Result<Generated, Error> {
    // Before files are read that nothing would be made of.
    compile::check_options(options)?;
    let description = description::read(model, &options.reading, include);
    of_description(description, shown_path, options)
}

/// As [`generate`], from what was read or made in memory; `options.reading` is not used.
///
/// # Errors
/// As [`generate`].
pub fn of_description(
    description: Description,
    shown_path: &str,
    options: &Options,
) -> Result<Generated, Error> {
    compile::check_options(options)?;
    let checked = checked(&description, options)?;
    let tree = &checked.tree;
    let compiled = compile::compile(tree, options)?;
    let functions = compiled
        .functions
        .iter()
        .map(|emittable| (emittable.request.name(), emittable.operations))
        .collect();
    // As the list of functions writes them, which may be in another way than the model does.
    let of_frames = compiled.functions.iter();
    let of_frames = of_frames.filter(|emittable| emittable.request.is_of_frames());
    let of_frames = of_frames.map(|emittable| (emittable.request.text(), emittable.operations));
    let of_frames: BTreeMap<String, Operations> = of_frames.collect();
    let asked = options.functions.requests();
    let asked_of_frames = asked.iter().filter_map(|asked| {
        let request = asked.on(tree).ok()?;
        Some((asked.text(), *of_frames.get(&request.text())?))
    });
    let asked_of_frames = asked_of_frames.collect();
    let mut warnings = checked.warnings;
    warnings.extend(compile::warnings(tree, &compiled));
    let origin = Origin::new(tree, shown_path, options);
    let module = Module::new(tree, origin, &compiled);
    let given = Ingredients {
        tree,
        compiled: &compiled,
        module: &module,
    };
    Ok(Generated {
        source: rust::source(&module),
        companions: companions::of(&given, &options.companions, &options.module)?,
        functions,
        asked_of_frames,
        description,
        warnings,
    })
}

impl Generated {
    /// Every file with its text, where the module goes to `module`.
    pub fn files(&self, module: &Path) -> Vec<(PathBuf, &str)> {
        let companions = self.companions.iter();
        let companions = companions.map(|one| (one.beside(module), one.text.as_str()));
        std::iter::once((module.to_owned(), self.source.as_str()))
            .chain(companions)
            .collect()
    }
}

/// The tree of a description, with the changes and the prescribed joints that the options ask for.
///
/// # Errors
/// [`Error::Invalid`] with every rule that the description breaks; [`Error::Prescribed`].
pub fn checked(description: &Description, options: &Options) -> Result<Checked, Error> {
    let Checked { tree, warnings } = tree::build_with(description, &options.changes)?;
    let tree = tree::prescribe(description, tree, &options.prescribed);
    Ok(Checked {
        tree: tree.map_err(Error::Prescribed)?,
        warnings,
    })
}
