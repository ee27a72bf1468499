//! Generates modules with their tests, and of each module ten with one token changed.

use std::{env, fmt::Write as _, fs, path::Path};

use kane_codegen::{build_script::Build, description::Base};

mod mutant;

use mutant::{Mutant, mutant};

/// How many mutants a module has.
const MUTANTS: u64 = 10;

#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=mutant.rs");
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
            let Mutant { module, line, .. } = mutant(&module, seed);
            write!(
                list,
                "/// `{line}`\npub mod {name}_{seed} {{ {module}\npub mod tests {{ use super::*; {tests} }} }}\n"
            )?;
        }
    }
    list += &eight_body(Path::new(&out))?;
    fs::write(Path::new(&out).join("mutants.rs"), list)?;
    Ok(())
}

/// All functions of a large module, and of each mutant the one that is wrong, in front of the others: ten whole ones would take
/// minutes to compile. Identities call the functions of the module as it is, so the test of the function's values has to see
/// what is wrong.
fn eight_body(out: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let build = Build::new("../../models/eight_body.toml").functions(["all"]);
    let module = fs::read_to_string(build.with_tests().run()?)?;
    let tests = fs::read_to_string(out.join("eight_body_tests.rs"))?;
    let mut list = format!(
        "pub mod eight_body {{ {module}\npub mod tests {{ use super::*; {} }} }}\n",
        as_functions(&tests)
    );
    for seed in 0..MUTANTS {
        let mutant = mutant(&module, seed);
        let (name, function) = mutant.function();
        let mut items = tests.split("#[test]\n");
        let test = items.find(|item| item.starts_with(&format!("fn {name}_has_its_values(")));
        let test = as_functions(&format!(
            "#[test]\n{}",
            test.ok_or("a function without test")?
        ));
        write!(
            list,
            "/// `{}`\npub mod eight_body_{seed} {{ pub use super::eight_body::*;{function}\
             pub mod tests {{ use super::*; use crate::eight_body::tests::*; {test} }} }}\n",
            mutant.line
        )?;
    }
    Ok(list)
}

/// The tests as functions that can be called, with the list of them.
fn as_functions(tests: &str) -> String {
    let text = tests.replace("#[test]\nfn ", "pub fn ");
    let text = text.replace("\nconst ", "\npub const ");
    let names = tests.split("#[test]\nfn ").skip(1);
    let names = names.filter_map(|rest| rest.split('(').next());
    let names: Vec<String> = names
        .map(|name| format!("({name:?}, {name} as Test)"))
        .collect();
    format!(
        "{text}\npub type Test = fn() -> Result<(), kane::self_test::Mismatch>;\n\
         pub const ALL: &[(&str, Test)] = &[{}];\n",
        names.join(", ")
    )
}
