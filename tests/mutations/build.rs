//! Generates modules with their tests, and of each module ten with one token changed.

use std::{env, fmt::Write as _, fs, path::Path};

use kane_codegen::{build_script::Build, description::Base};

/// How many mutants a module has.
const MUTANTS: u64 = 10;

/// What a token becomes: a sign, or another operation.
const CHANGES: [(&str, &str); 4] = [
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " + "),
    ("= -", "= "),
];

#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let out = env::var("OUT_DIR")?;
    let mut list = String::new();
    for (name, model, base) in [
        ("cart_pole", "../../models/cart_pole.toml", None),
        (
            "double_pendulum",
            "../robots/double_pendulum/double_pendulum.urdf",
            Some(Base::Fixed),
        ),
        ("ur5", "../robots/ur5/ur5.urdf", Some(Base::Fixed)),
        ("panda", "../robots/panda/panda.urdf", Some(Base::Fixed)),
    ] {
        let build = Build::new(model).name(name).with_tests();
        let build = match base {
            Some(base) => build.base(base),
            None => build,
        };
        let module = fs::read_to_string(build.run()?)?;
        let tests = fs::read_to_string(Path::new(&out).join(format!("{name}_tests.rs")))?;
        let tests = as_functions(&tests);
        write!(
            list,
            "pub mod {name} {{ {module}\npub mod tests {{ use super::*; {tests} }} }}\n"
        )?;
        for seed in 0..MUTANTS {
            let (mutant, line) = mutant(&module, seed);
            write!(
                list,
                "/// `{line}`\npub mod {name}_{seed} {{ {mutant}\npub mod tests {{ use super::*; {tests} }} }}\n"
            )?;
        }
    }
    fs::write(Path::new(&out).join("mutants.rs"), list)?;
    Ok(())
}

/// The module with one token of one function changed, and the changed line.
fn mutant(module: &str, seed: u64) -> (String, String) {
    let start = module.find("pub fn ").unwrap_or(0);
    let places: Vec<(usize, &str, &str)> = CHANGES
        .iter()
        .flat_map(|&(from, to)| {
            let found = module.match_indices(from);
            found.map(move |(place, _)| (place, from, to))
        })
        .filter(|&(place, ..)| place > start && is_statement(line_at(module, place)))
        .collect();
    let chosen = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33;
    let chosen = usize::try_from(chosen).unwrap_or(0) % places.len();
    let (place, from, to) = places[chosen];
    let mut text = module.to_owned();
    text.replace_range(place..place + from.len(), to);
    let line = line_at(&text, place).trim().to_owned();
    (text, line)
}

fn line_at(text: &str, place: usize) -> &str {
    let start = text[..place].rfind('\n').map_or(0, |end| end + 1);
    let end = text[place..]
        .find('\n')
        .map_or(text.len(), |end| place + end);
    &text[start..end]
}

/// True for a line of a function's body.
fn is_statement(line: &str) -> bool {
    line.starts_with("    ") && !line.trim_start().starts_with("//")
}

/// The tests as functions that can be called, with the list of them.
fn as_functions(tests: &str) -> String {
    let text = tests.replace("#[test]\nfn ", "pub fn ");
    let names = tests.split("#[test]\nfn ").skip(1);
    let names = names.filter_map(|rest| rest.split('(').next());
    let names: Vec<String> = names
        .map(|name| format!("({name:?}, {name} as Test)"))
        .collect();
    format!(
        "{text}\ntype Test = fn() -> Result<(), kane::self_test::Mismatch>;\n\
         pub const ALL: &[(&str, Test)] = &[{}];\n",
        names.join(", ")
    )
}
