//! `kane new`: a package with a model, its module, a control loop, a test and a workflow.

mod config;
mod model;
mod package;

use std::{
    collections::BTreeSet,
    fs,
    io::Write,
    path::{Path, PathBuf},
};

use clap::Args;
use kane_codegen::{
    companions::{Abi, CompanionKind},
    description::{self, toml},
    diagnostic::Escaped,
    generate,
    options::{Functions, Options, companion},
    output::{self, Overwrite},
};

use self::{model::Model, package::Dependency};
use crate::cli::{
    Failures, Outcome, Voice, arguments::changes::ChangesArguments, arguments::parse::one_of,
    paths, rounded_angles, runtime,
};

/// Names that a package, its program or a module of it cannot have, though they are names in Rust.
const TAKEN: [&str; 29] = [
    "alloc",
    "bool",
    "build",
    "char",
    "core",
    "deps",
    "examples",
    "f32",
    "f64",
    "i128",
    "i16",
    "i32",
    "i64",
    "i8",
    "incremental",
    "isize",
    "kane",
    "lib",
    "main",
    "std",
    "str",
    "test",
    "tests",
    "u128",
    "u16",
    "u32",
    "u64",
    "u8",
    "usize",
];

/// Create a package with a model, its generated module, a control loop and a test
///
/// The folder NAME gets `Cargo.toml`, `kane.toml`, the model in `models/`, the generated module with its tests and a control loop in
/// `src/`. With --kane, `cargo run` and `cargo test` work at once; without it, the package needs the crate `kane` from crates.io, and
/// also gets a GitHub workflow. With --abi c the control loop is a
/// C program with a Makefile, and the functions are a static library; `make run` starts it. A model that needs other files, such
/// as meshes, is converted to kane's TOML format.
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane new pendulum --kane ../kane\n  \
    kane new my_arm panda.urdf --kane ../kane\n  \
    kane new my_dog spot.urdf --base free --kane ../kane\n  \
    kane new my_arm panda.urdf --abi c --kane ../kane")]
pub(crate) struct Arguments {
    /// The name of the package and its folder: ASCII letters, digits and `_`, a lower-case letter first
    #[arg(value_name = "NAME")]
    folder: PathBuf,

    /// The model: URDF, MJCF or TOML; without it, a double pendulum
    #[arg(value_name = "MODEL")]
    model: Option<PathBuf>,

    #[command(flatten)]
    changes: ChangesArguments,

    /// The language of the control loop, if not Rust
    #[arg(long, value_name = "WHICH", value_parser = one_of(Abi::ALL))]
    abi: Option<Abi>,

    /// The folder of the crate `kane`; without it, the package depends on the version on crates.io
    #[arg(long, value_name = "FOLDER")]
    kane: Option<PathBuf>,
}

impl Arguments {
    /// What to say where a model stands in the place of the name.
    fn swapped(&self) -> Option<Failures> {
        let is_model =
            self.folder.is_file() && self.model.as_ref().is_some_and(|model| !model.exists());
        let message = format!(
            "`{}` is a file; the name of the package comes first, then the model",
            self.folder.display()
        );
        is_model.then(|| Failures::message(message))
    }
}

/// Makes everything, then writes everything.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    _: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let folder = &arguments.folder;
    let companions: BTreeSet<CompanionKind> = std::iter::once(CompanionKind::Tests)
        .chain(arguments.abi.map(CompanionKind::Abi))
        .collect();
    let name =
        name(folder, &companions).map_err(|failures| arguments.swapped().unwrap_or(failures))?;
    if folder.exists() {
        return Err(Failures::message(format!(
            "`{}` is there already; expected the name of a new folder",
            folder.display()
        )));
    }
    let dependency = dependency(folder, arguments.kane.as_deref())?;
    arguments.changes.check()?;
    let mut options = Options {
        companions,
        module: name.clone(),
        ..Options::default()
    };
    arguments.changes.set(&mut options);
    if !options.prescribed.is_empty() {
        options.functions = Functions::Default(vec!["hybrid_dynamics".to_owned()]);
    }
    let model = match &arguments.model {
        Some(path) => Model::read(path, &options, &name)?,
        None => Model::pendulum(&name)?,
    };
    options.reading = model.reading.clone();
    let shown = format!("models/{}", model.source.name());
    let includes = description::no_includes;
    let generated = generate::generate(&model.source, &shown, &options, &includes)?;
    voice.warn(&model.warnings);
    let functions = Some(&generated.functions[..]);
    rounded_angles::tell_of(&generated.description, &options, functions, voice);

    let module = folder.join(format!("src/{name}.rs"));
    let abi = arguments.abi;
    let manifest = package::manifest(&name, &dependency, abi);
    let config = config::config(&name, &shown, &model.tree, &options, abi);
    let (program, next) = package::program(&name, &model.tree, abi);
    let workflow = package::workflow(&dependency);
    let mut files: Vec<(PathBuf, &str)> = generated.files(&module);
    files.extend([
        (folder.join("Cargo.toml"), manifest.as_str()),
        (folder.join("kane.toml"), config.as_str()),
        (folder.join(&shown), model.source.text()),
        (folder.join(".gitattributes"), "* text=auto eol=lf\n"),
        (folder.join(".gitignore"), "/target\n"),
    ]);
    let program = program.iter();
    files.extend(program.map(|(path, text)| (folder.join(path), text.as_str())));
    let place = folder.join(".github/workflows/kane.yml");
    files.extend(workflow.as_deref().map(|text| (place, text)));
    output::write(&files, Overwrite::Nothing).inspect_err(|_| remove(folder, &files))?;
    if matches!(dependency, Dependency::Registry) {
        voice.say("note: the package needs the crate `kane` of crates.io; where it is not there, `--kane FOLDER` takes that of a checkout");
    }
    if let Some(around) = workspace_around(folder)? {
        voice.say(format_args!(
            "note: `{}` is a workspace: the package has to be among its `members`, or to have a table `[workspace]` of its own",
            around.display()
        ));
    }
    let folder = folder.display();
    voice.say(format_args!("wrote {folder}/; next: cd {folder} && {next}"));
    Ok(Outcome::Done)
}

/// Removes what was written of a package that cannot be written whole: its files, and folders that are empty then.
fn remove(package: &Path, files: &[(PathBuf, &str)]) {
    let mut folders = BTreeSet::new();
    for (file, text) in files {
        if fs::read(file).is_ok_and(|there| there == text.as_bytes()) {
            drop(fs::remove_file(file));
        }
        let inside = file.ancestors().skip(1);
        folders.extend(inside.take_while(|folder| folder.starts_with(package)));
    }
    // Inner ones first.
    for folder in folders.into_iter().rev() {
        drop(fs::remove_dir(folder));
    }
}

/// The manifest of the workspace in which cargo would look for the package.
fn workspace_around(package: &Path) -> Result<Option<PathBuf>, Failures> {
    let absolute = paths::of_new(package)?;
    let mut manifests = absolute
        .ancestors()
        .skip(1)
        .map(|folder| folder.join("Cargo.toml"));
    Ok(manifests.find(|manifest| {
        let text = fs::read_to_string(manifest).unwrap_or_default();
        let table = ::toml::de::DeTable::parse(text.trim_start_matches('\u{feff}'));
        table.is_ok_and(|table| table.get_ref().contains_key("workspace"))
    }))
}

/// The package's name, which is the module's too.
fn name(folder: &Path, companions: &BTreeSet<CompanionKind>) -> Result<String, Failures> {
    let name = folder.file_name().ok_or_else(|| {
        let shown = folder.display();
        Failures::message(format!(
            "`{shown}` is there already; expected the name of a new folder"
        ))
    })?;
    let name = name.to_string_lossy().into_owned();
    let shown = name.escaped();
    if name.starts_with(|first: char| first.is_ascii_uppercase()) {
        return Err(Failures::message(format!(
            "`{shown}` cannot be the name of the package and of its module: expected a lower-case letter first"
        )));
    }
    if TAKEN.contains(&name.as_str()) {
        return Err(Failures::message(format!(
            "`{shown}` cannot be the name of the package and of its module: Rust or cargo use it for something else"
        )));
    }
    if !companion::can_be_beside(companions, &name) {
        let other = name.replace(['-', ' ', '.'], "_");
        let advice = if companion::can_be_beside(companions, &other) {
            format!("; did you mean `{}`?", other.escaped())
        } else {
            String::new()
        };
        return Err(Failures::message(format!(
            "`{shown}` cannot be the name of the package and of its module; {}{advice}",
            companion::EXPECTED_NAME
        )));
    }
    Ok(name)
}

/// Where the crate `kane` comes from, for a package that is not there yet.
fn dependency(package: &Path, folder: Option<&Path>) -> Result<Dependency, Failures> {
    let Some(folder) = folder else {
        return Ok(Dependency::Registry);
    };
    let absolute = runtime::folder(folder)?;
    // As it was given: relative, so that both folders can be moved together, or absolute.
    let relative =
        paths::relative(&paths::of_new(package)?, &absolute).filter(|_| folder.is_relative());
    let shown = relative.as_deref().and_then(paths::with_slashes);
    let shown = shown.unwrap_or_else(|| absolute.to_string_lossy().into_owned());
    Ok(Dependency::Folder(toml::quoted(&shown)))
}
