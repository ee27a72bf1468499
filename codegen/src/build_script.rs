//! Generates modules from a build script: a model in the package becomes a module in `OUT_DIR`.
//!
//! ```no_run
//! // build.rs
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     kane_codegen::build_script::Build::new("models/arm.toml").functions(["mass_matrix", "bias"]).run()?;
//!     Ok(())
//! }
//! ```
//! And in the package, which depends on `kane`:
//! ```text
//! pub mod arm {
//!     include!(concat!(env!("OUT_DIR"), "/arm.rs"));
//! }
//! ```

use std::{
    collections::BTreeMap,
    ffi::OsString,
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

use crate::{
    description::{Base, Chart},
    diagnostic::{Diagnostics, Severity, Source},
    error::Error,
    generate::generate,
    input,
    options::{
        Formulation, Functions, Options,
        companion::{Abi, CompanionKind},
    },
    output::{self, Overwrite},
    recursive::Technique,
};

/// One model to generate from a build script.
#[derive(Clone, Debug)]
pub struct Build {
    model: PathBuf,
    /// The name of the module's file.
    file: OsString,
    options: Options,
}

impl Build {
    /// Generates `model`, a path relative to the package, into `OUT_DIR`, under its own name with the extension `rs`.
    pub fn new(model: impl Into<PathBuf>) -> Self {
        let model = model.into();
        let module = model.file_stem().unwrap_or(model.as_os_str());
        let mut file = module.to_owned();
        file.push(".rs");
        let options = Options {
            module: module.to_string_lossy().into_owned(),
            ..Options::default()
        };
        Self {
            model,
            file,
            options,
        }
    }

    /// Generates these functions instead of the default set; `default` stands for that set, and `all` for every function of the
    /// system. A second call replaces the first.
    #[must_use]
    pub fn functions<S: Into<String>>(mut self, names: impl IntoIterator<Item = S>) -> Self {
        self.options.functions = Functions::of(names.into_iter().map(Into::into));
        self
    }

    /// Names the file `NAME.rs` instead of after the model: for several modules of one model. The name has no folder and no `.rs`.
    #[must_use]
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.options.module = name.into();
        self.file = format!("{}.rs", self.options.module).into();
        self
    }

    /// Forces a formulation instead of the cheapest.
    #[must_use]
    pub fn formulation(mut self, formulation: Formulation) -> Self {
        self.options.formulation = formulation;
        self
    }

    /// Uses fused multiply-add (`Real::mul_add`): faster on hardware that has it, but the last bits then depend on the
    /// machine.
    #[must_use]
    pub fn fma(mut self) -> Self {
        self.options.fma = true;
        self
    }

    /// Disables an operation-saving technique; the values stay the same.
    #[must_use]
    pub fn without(mut self, technique: Technique) -> Self {
        self.options.without.insert(technique);
        self
    }

    /// Sets the joint between the inertial frame and the root link of a URDF, instead of fixed.
    #[must_use]
    pub fn base(mut self, base: Base) -> Self {
        self.options.reading.base = Some(base);
        self
    }

    /// Sets the orientation coordinates of free and ball joints of a URDF or MJCF, instead of quaternions.
    #[must_use]
    pub fn chart(mut self, chart: Chart) -> Self {
        self.options.reading.chart = Some(chart);
        self
    }

    /// Ignores parts of an MJCF, with a warning: `equalities`, `fluid`, `tendons`, `gravcomp`, the equalities
    /// of one kind such as `connect`, or the equality with this name.
    #[must_use]
    pub fn leave_out(mut self, what: impl Into<String>) -> Self {
        self.options.reading.leave_out.insert(what.into());
        self
    }

    /// Snaps entries of constant rotations to 0, 1 or -1 if they are within `tolerance`, instead of 1e-9.
    #[must_use]
    pub fn snap(mut self, tolerance: f64) -> Self {
        self.options.changes.snap = tolerance;
        self
    }

    /// Locks a coordinate at a value, rad or m; the name is that of the coordinate or of its joint.
    #[must_use]
    pub fn lock(mut self, name: impl Into<String>, value: f64) -> Self {
        self.options.changes.lock.push((name.into(), value));
        self
    }

    /// Fixes a joint at zero coordinates; the name is that of the joint or of its body.
    #[must_use]
    pub fn remove(mut self, name: impl Into<String>) -> Self {
        self.options.changes.remove.push(name.into());
        self
    }

    /// Fixes at zero every motion that moves no mass.
    #[must_use]
    pub fn remove_massless(mut self) -> Self {
        self.options.changes.remove_massless = true;
        self
    }

    /// Prescribes the accelerations of a joint for `hybrid_dynamics`; the name is that of the joint or of its body.
    #[must_use]
    pub fn prescribed(mut self, name: impl Into<String>) -> Self {
        self.options.prescribed.push(name.into());
        self
    }

    /// Also writes the manifest beside the module: its contents as JSON, `arm.json` for `arm.rs`.
    #[must_use]
    pub fn manifest(mut self) -> Self {
        self.options.companions.insert(CompanionKind::Manifest);
        self
    }

    /// Also writes an interface for another language beside the module: for C `arm_c.rs` and `arm.h`.
    #[must_use]
    pub fn abi(mut self, abi: Abi) -> Self {
        self.options.companions.insert(CompanionKind::Abi(abi));
        self
    }

    /// Also writes tests of the module beside it, `arm_tests.rs` for `arm.rs`; `kane::self_test` describes them. They call the module
    /// as `arm`: declare it under this name, and the tests beside it:
    /// ```text
    /// #[cfg(test)]
    /// mod arm_tests {
    ///     include!(concat!(env!("OUT_DIR"), "/arm_tests.rs"));
    /// }
    /// ```
    #[must_use]
    pub fn with_tests(mut self) -> Self {
        self.options.companions.insert(CompanionKind::Tests);
        self
    }

    /// Writes the module, tells cargo when to rerun the script, and passes warnings on. Returns the module's path.
    ///
    /// # Errors
    /// All faults of the model; an impossible option; a file that cannot be read or written.
    #[expect(
        clippy::disallowed_methods,
        reason = "cargo names the output folder of a build script in its environment"
    )]
    pub fn run(self) -> Result<PathBuf, Error> {
        let folder = std::env::var("OUT_DIR").map_err(|_| Error::NoBuildScript)?;
        self.written(Path::new(&folder), &WRITTEN)
    }

    /// Like [`run`](Self::run), into this folder, whatever else was generated there.
    ///
    /// # Errors
    /// Those of [`run`](Self::run), but for a file that is generated twice.
    pub fn run_in(&self, folder: &Path) -> Result<PathBuf, Error> {
        self.written(folder, &Written::new())
    }

    #[expect(
        clippy::print_stdout,
        reason = "a build script speaks to cargo on standard output"
    )]
    fn written(&self, folder: &Path, before: &Written) -> Result<PathBuf, Error> {
        // Told before the file is read, so that one that is missing now is looked for again.
        let tell = |path: &Path| println!("cargo::rerun-if-changed={}", path.display());
        let name = self.model.to_string_lossy().replace('\\', "/");
        self.check_file_name()?;
        tell(&self.model);
        let text = input::text(&self.model).map_err(|source| Error::Io {
            path: self.model.clone(),
            source,
        })?;
        let model_folder = self.model.parent().unwrap_or(Path::new(""));
        let generated = generate(
            &Source::new(&*name, text),
            &shown_path(&self.model),
            &self.options,
            &|path| {
                let path = model_folder.join(path);
                tell(&path);
                input::named(&path)
            },
        )
        .map_err(|error| of_model(&name, error))?;
        report(&generated.warnings);
        let path = folder.join(&self.file);
        let files = generated.files(&path);
        before.refuse_other(&files)?;
        output::write(&files, Overwrite::Generated)?;
        Ok(path)
    }

    fn check_file_name(&self) -> Result<(), Error> {
        let file = Path::new(&self.file);
        let is_alone = file.file_name() == Some(&self.file);
        let is_rust = file.file_stem().is_some_and(|stem| {
            let stem = Path::new(stem);
            stem.extension().is_some_and(|own| own == "rs")
        });
        if is_alone && !is_rust && !self.options.module.is_empty() {
            return Ok(());
        }
        let name = self.options.module.clone();
        Err(Error::FileName { name })
    }
}

/// The files that a script has written, with their texts.
struct Written(Mutex<BTreeMap<PathBuf, String>>);

/// Those of this script.
static WRITTEN: Written = Written::new();

impl Written {
    const fn new() -> Self {
        Self(Mutex::new(BTreeMap::new()))
    }

    /// Refuses a file in the place of another one; remembers the others.
    fn refuse_other(&self, files: &[(PathBuf, &str)]) -> Result<(), Error> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        for (path, text) in files {
            if known.get(path).is_some_and(|before| before != text) {
                return Err(Error::GeneratedTwice { path: path.clone() });
            }
        }
        known.extend(
            files
                .iter()
                .map(|(path, text)| (path.clone(), (*text).to_owned())),
        );
        Ok(())
    }
}

/// The error, with the model's name where it says none.
fn of_model(model: &str, error: Error) -> Error {
    match error {
        Error::Invalid(_) | Error::Io { .. } => error,
        other => Error::OfModel {
            model: model.to_owned(),
            error: Box::new(other),
        },
    }
}

/// The path for the banner, which must not depend on the machine: an absolute one is its file name alone.
fn shown_path(model: &Path) -> String {
    let shown = match model.file_name() {
        Some(name) if model.is_absolute() => Path::new(name),
        _ => model,
    };
    shown.to_string_lossy().replace('\\', "/")
}

/// Warnings for cargo to show, a line a kind; all of them, and notes, go to the script's log.
#[expect(
    clippy::print_stdout,
    reason = "a build script speaks to cargo on standard output"
)]
fn report(warnings: &Diagnostics) {
    for (severity, line) in warnings.brief().lines {
        if severity == Severity::Warning {
            let line = line.strip_prefix("warning: ").unwrap_or(&line);
            println!("cargo::warning={line}");
        }
    }
    println!("{warnings}");
}
