//! `kane new`: a package with a model, its module, a control loop, a test and a workflow.

use std::{
    cell::Cell,
    fs,
    io::Write,
    path::{Path, PathBuf},
};

use clap::Args;
use kane_codegen::{
    companions::CompanionKind,
    description::{self, Base, Chart, Reading, toml},
    diagnostic::Source,
    generate,
    options::{Options, companion},
    output::{self, Overwrite},
    tree::{self, Changes, Tree},
};

use super::{Failures, Outcome, Voice, changes::ReadingArguments, job, parse::name_of};

/// The model where none is given.
const PENDULUM: &str = include_str!("pendulum.toml");
/// The program, with words in capitals for what differs.
const MAIN: &str = include_str!("main.txt");
/// The workflow.
const WORKFLOW: &str = include_str!("github.yml");

/// Make a package with a model, its generated module, a control loop and a test
///
/// The folder NAME gets `Cargo.toml`, `kane.toml`, the model in `models/`, the generated module with its tests and a control loop in
/// `src/`, and a workflow for GitHub. `cargo run` and `cargo test` work at once. A model that needs other files, such as
/// meshes, is written in our own format.
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane new pendulum\n  \
    kane new my_arm panda.urdf\n  \
    kane new my_dog spot.urdf --base free")]
pub(crate) struct Arguments {
    /// The package and its folder: ASCII letters, digits and `_`, a letter first
    #[arg(value_name = "NAME")]
    folder: PathBuf,

    /// The model: URDF, MJCF or TOML; without it, a double pendulum
    #[arg(value_name = "MODEL")]
    model: Option<PathBuf>,

    #[command(flatten)]
    reading: ReadingArguments,

    /// The folder of the crate `kane`, in place of the one on crates.io
    #[arg(long, value_name = "FOLDER")]
    kane: Option<PathBuf>,
}

/// A model on its way into the package.
struct Model {
    /// The name of its file there.
    file: String,
    text: String,
}

/// Makes everything, then writes everything.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    _: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let folder = &arguments.folder;
    let name = name(folder)?;
    if folder.exists() {
        return Err(Failures::message(format!(
            "`{}` is there already; expected the name of a new folder",
            folder.display()
        )));
    }
    let dependency = dependency(arguments.kane.as_deref())?;
    let reading = arguments.reading.above(Reading::default());
    let model = model(arguments.model.as_deref(), &reading, &name)?;
    let source = Source::new(model.file.as_str(), model.text.as_str());
    let options = Options {
        reading: reading.clone(),
        companions: [CompanionKind::Tests].into(),
        module: name.clone(),
        ..Options::default()
    };
    let shown = format!("models/{}", model.file);
    let includes = description::no_includes;
    let generated = generate::generate(&source, &shown, &options, &includes)?;
    let description = description::read(&source, &reading, &includes);
    let checked = tree::build_with(&description, &Changes::default())?;
    voice.warn(&checked.warnings);

    let module = folder.join(format!("src/{name}.rs"));
    let mut files: Vec<(PathBuf, &str)> = generated.files(&module);
    let manifest = manifest(&name, &dependency);
    let config = config(&name, &shown, &reading);
    let program = program(&name, &checked.tree);
    files.extend([
        (folder.join("Cargo.toml"), manifest.as_str()),
        (folder.join("kane.toml"), config.as_str()),
        (folder.join(&shown), model.text.as_str()),
        (folder.join("src/main.rs"), program.as_str()),
        (folder.join(".github/workflows/kane.yml"), WORKFLOW),
        (folder.join(".gitattributes"), "* text=auto eol=lf\n"),
        (folder.join(".gitignore"), "/target\n"),
    ]);
    output::write(&files, Overwrite::Nothing)?;
    let folder = folder.display();
    voice.say(format_args!(
        "wrote {folder}/; next: cd {folder} && cargo run"
    ));
    Ok(Outcome::Done)
}

/// The package's name, which is the module's too.
fn name(folder: &Path) -> Result<String, Failures> {
    let name = folder.file_name().unwrap_or_default();
    let name = name.to_string_lossy().into_owned();
    // A module may be called `main` or `test`, a package may not.
    let is_taken = ["main", "test", "core", "std", "kane"].contains(&name.as_str());
    if is_taken || !companion::can_be_beside(&[CompanionKind::Tests].into(), &name) {
        return Err(Failures::message(format!(
            "`{}` cannot be the name of the package and of its module; {}",
            name.escape_debug(),
            companion::EXPECTED_NAME
        )));
    }
    Ok(name)
}

/// What `Cargo.toml` says of the crate `kane`.
fn dependency(folder: Option<&Path>) -> Result<String, Failures> {
    let Some(folder) = folder else {
        return Ok(format!("version = \"{}\"", env!("CARGO_PKG_VERSION")));
    };
    let absolute = fs::canonicalize(folder).ok();
    let absolute = absolute.filter(|folder| folder.join("Cargo.toml").is_file());
    let absolute = absolute.ok_or_else(|| {
        Failures::message(format!(
            "`{}` holds no package; expected the folder of the crate `kane`",
            folder.display()
        ))
    })?;
    Ok(format!("path = {:?}", absolute.to_string_lossy()))
}

/// The model that is given, in our own format where it includes others; or the pendulum.
fn model(path: Option<&Path>, reading: &Reading, name: &str) -> Result<Model, Failures> {
    let Some(path) = path else {
        return Ok(Model {
            file: format!("{name}.toml"),
            text: PENDULUM.to_owned(),
        });
    };
    let source = job::read(path)?;
    let needs_others = Cell::new(false);
    let include = |other: &str| {
        needs_others.set(true);
        job::include(path)(other)
    };
    let description = description::read(&source, reading, &include);
    tree::build_with(&description, &Changes::default())?;
    if needs_others.get() {
        return Ok(Model {
            file: format!("{name}.toml"),
            text: toml::write(&description)?,
        });
    }
    let file = path.file_name().unwrap_or_default();
    Ok(Model {
        file: file.to_string_lossy().into_owned(),
        text: source.text().to_owned(),
    })
}

fn manifest(name: &str, dependency: &str) -> String {
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\n# Without its features it needs neither the standard library nor another crate.\n\
         kane = {{ {dependency}, default-features = false }}\n"
    )
}

fn config(name: &str, model: &str, reading: &Reading) -> String {
    let Reading {
        base,
        chart,
        leave_out,
    } = reading;
    let base = base.map(|base| format!("base = \"{}\"\n", name_of(&base, &Base::NAMED)));
    let chart = chart.map(|chart| format!("chart = \"{}\"\n", name_of(&chart, &Chart::NAMED)));
    let names: Vec<String> = leave_out.iter().map(ToString::to_string).collect();
    let leave_out = (!names.is_empty()).then(|| format!("leave_out = {names:?}\n"));
    format!(
        "[[system]]\nmodel = {model:?}\noutput = \"src/{name}.rs\"\n{}{}{}tests = true\n\
         # functions = [\"default\", \"jacobian(hand)\"]   # what else is generated: `kane info {model}` lists functions and frames\n",
        base.unwrap_or_default(),
        chart.unwrap_or_default(),
        leave_out.unwrap_or_default()
    )
}

/// The program; angles and translations start at zero, quaternions at no rotation.
fn program(name: &str, tree: &Tree) -> String {
    let names = tree.coordinate_names();
    let mut start = vec!["0.0"; names.len()];
    let coordinates = tree.bodies.iter().flat_map(|body| body.joint.coordinates());
    for (_, coordinate) in coordinates.filter(|(kind, _)| *kind == "e0") {
        start[coordinate.index()] = "1.0";
    }
    let lines = start.iter().zip(&names);
    let lines: String = lines
        .flat_map(|(value, name)| ["    ", value, ", // ", name, "\n"])
        .collect();
    MAIN.replace("COORDINATES", &lines)
        .replace("MODULE", name)
        .replace("NAME", &format!("`{name}`"))
}
