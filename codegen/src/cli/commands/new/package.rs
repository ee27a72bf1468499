//! The texts of a new package, beside the model and its module.

use kane_codegen::{companions::Abi, listing::Limits, tree::Tree};

/// The program, with `{{..}}` for what differs.
const PROGRAM: &str = include_str!("main.rs.txt");
/// The program in C, the library that it links, and how both are built, likewise.
const C_PROGRAM: &str = include_str!("main.c.txt");
const C_LIBRARY: &str = include_str!("lib.rs.txt");
const C_MAKEFILE: &str = include_str!("makefile.txt");
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

/// The text of `Cargo.toml`.
pub(super) fn manifest(name: &str, dependency: &Dependency, abi: Option<Abi>) -> String {
    let from = match dependency {
        Dependency::Registry => format!("version = \"{VERSION}\""),
        Dependency::Folder(path) => format!("path = {path}"),
    };
    let library = match abi {
        None => "",
        Some(Abi::C) => "[lib]\ncrate-type = [\"staticlib\"]\n\n",
    };
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n{library}\
         [dependencies]\n# Without its features it needs neither the standard library nor another crate.\n\
         kane = {{ {from}, default-features = false }}\n"
    )
}

/// The program: the path of each of its files, and its text; and the command that runs it.
pub(super) fn program(
    name: &str,
    tree: &Tree,
    abi: Option<Abi>,
) -> (Vec<(&'static str, String)>, &'static str) {
    match abi {
        None => {
            let mut uses = [
                (name, "{NQ, NU, Prepared}"),
                ("kane", "integrate::rk4_step_with"),
            ];
            // As rustfmt has them.
            uses.sort_unstable();
            let uses = uses.map(|(of, what)| format!("use {of}::{what};"));
            let program = PROGRAM.replace("{{uses}}", &uses.join("\n"));
            let line = |value: &str, name: &str| format!("    {value}, // {name}\n");
            let program = filled(&program, name, &start(tree, line));
            (vec![("src/main.rs", program)], "cargo run")
        }
        Some(Abi::C) => (c_program(name, tree), "make run"),
    }
}

fn c_program(name: &str, tree: &Tree) -> Vec<(&'static str, String)> {
    let line = |value: &str, name: &str| format!("        {value}, /* {name} */\n");
    vec![
        ("main.c", filled(C_PROGRAM, name, &start(tree, line))),
        ("src/lib.rs", filled(C_LIBRARY, name, "")),
        ("Makefile", filled(C_MAKEFILE, name, "")),
    ]
}

/// Where the system starts, a line a coordinate: angles and translations at zero, or within limits that leave zero out,
/// quaternions at no rotation.
fn start(tree: &Tree, line: impl Fn(&str, &str) -> String) -> String {
    let names = tree.coordinate_names();
    let limits = Limits::of(tree);
    let ranges = limits.lower.iter().zip(&limits.upper);
    let start = tree.neutral().into_iter().zip(ranges);
    let start = start.map(|(neutral, (&lower, &upper))| {
        let has_both = lower.is_finite() && upper.is_finite();
        let start = if has_both && !(lower..=upper).contains(&neutral) {
            f64::midpoint(lower, upper)
        } else {
            neutral.max(lower).min(upper)
        };
        format!("{start:?}")
    });
    let start: Vec<String> = start.collect();
    let lines = start.iter().zip(&names);
    lines.map(|(value, name)| line(value, name)).collect()
}

fn filled(text: &str, name: &str, coordinates: &str) -> String {
    // No name holds a brace.
    text.replace("{{module}}", name)
        .replace("{{MODULE}}", &name.to_uppercase())
        .replace("{{coordinates}}", coordinates)
}

/// The workflow, where the command and the crate are those of the registry.
pub(super) fn workflow(dependency: &Dependency) -> Option<String> {
    match dependency {
        Dependency::Registry => Some(WORKFLOW.replace("{{version}}", VERSION)),
        Dependency::Folder(_) => None,
    }
}
