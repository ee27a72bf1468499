//! The texts of a new package, beside the model and its module.

use kane_codegen::{
    description::{Base, Chart, Reading, toml::quoted},
    tree::Tree,
};

use crate::cli::parse::name_of;

/// The program, with `{{..}}` for what differs.
const PROGRAM: &str = include_str!("main.txt");
/// The workflow, likewise.
const WORKFLOW: &str = include_str!("github.yml");
/// The version of the command, and of the crate `kane`.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Where the crate `kane` comes from.
pub(super) enum Dependency {
    Registry,
    /// Its folder, as a string of TOML.
    Folder(String),
}

pub(super) fn manifest(name: &str, dependency: &Dependency) -> String {
    let from = match dependency {
        Dependency::Registry => format!("version = \"{VERSION}\""),
        Dependency::Folder(path) => format!("path = {path}"),
    };
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\n# Without its features it needs neither the standard library nor another crate.\n\
         kane = {{ {from}, default-features = false }}\n"
    )
}

pub(super) fn config(name: &str, model: &str, reading: &Reading) -> String {
    let Reading {
        base,
        chart,
        leave_out,
    } = reading;
    let base = base.map(|base| format!("base = \"{}\"\n", name_of(&base, &Base::NAMED)));
    let chart = chart.map(|chart| format!("chart = \"{}\"\n", name_of(&chart, &Chart::NAMED)));
    let names: Vec<String> = leave_out.iter().map(|name| quoted(name)).collect();
    let leave_out = (!names.is_empty()).then(|| format!("leave_out = [{}]\n", names.join(", ")));
    let reading = [base, chart, leave_out].into_iter().flatten();
    format!(
        "[[system]]\nmodel = {}\noutput = \"src/{name}.rs\"\n{}tests = true\n\
         # functions = [\"default\", \"regressor\"]   # more; `kane info {model} --functions all` lists them\n",
        quoted(model),
        reading.collect::<String>()
    )
}

/// The program; angles and translations start at zero, quaternions at no rotation.
pub(super) fn program(name: &str, tree: &Tree) -> String {
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
    // No name holds a brace.
    PROGRAM
        .replace("{{module}}", name)
        .replace("{{coordinates}}", &lines)
}

/// The workflow, where the command and the crate are those of the registry.
pub(super) fn workflow(dependency: &Dependency) -> Option<String> {
    match dependency {
        Dependency::Registry => Some(WORKFLOW.replace("{{version}}", VERSION)),
        Dependency::Folder(_) => None,
    }
}
