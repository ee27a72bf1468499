//! Generates modules with their tests, and of each module copies with one token changed.

use std::{
    collections::BTreeSet,
    env,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};

use kane_codegen::{build_script::Build, description::Base};

use kane_test_support::{
    mutant::{Mutant, mutant},
    systems::trees,
};

mod calls;

/// How many mutants a module has: ten, and some more, for there are those that change no value. Ordinary runs compile a third.
const MUTANTS: u64 = 12;
/// As many of a large module, in which more is zero.
const MUTANTS_OF_LARGE: u64 = 15;

type Failure = Box<dyn std::error::Error>;

/// A generated module.
struct System {
    name: &'static str,
    module: String,
    tests: String,
}

fn main() -> Result<(), Failure> {
    for file in ["build.rs", "calls.rs"] {
        println!("cargo::rerun-if-changed={file}");
    }
    trees::announce_all_seeds();
    let robots = Path::new("../robots");
    let mut list = String::new();
    for (name, model, base) in [
        ("cart_pole", "../../models/cart_pole.toml".into(), None),
        (
            "double_pendulum",
            robots.join("double_pendulum/double_pendulum.urdf"),
            Some(Base::Fixed),
        ),
        ("ur5", robots.join("ur5/ur5.urdf"), Some(Base::Fixed)),
        ("panda", robots.join("panda/panda.urdf"), Some(Base::Fixed)),
    ] {
        let build = Build::new(model);
        let build = match base {
            Some(base) => build.base(base),
            None => build,
        };
        let system = System::generate(name, build)?;
        list += &system.listed(trees::share(MUTANTS), |mutant| {
            Ok(system.whole(&mutant.module))
        })?;
    }
    let build = Build::new("../../models/eight_body.toml").functions(["all"]);
    let system = System::generate("eight_body", build)?;
    list += &system.listed(trees::share(MUTANTS_OF_LARGE), |mutant| {
        system.alone(mutant)
    })?;
    fs::write(out()?.join("mutants.rs"), list)?;
    Ok(())
}

#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn out() -> Result<PathBuf, Failure> {
    Ok(env::var("OUT_DIR")?.into())
}

impl System {
    fn generate(name: &'static str, build: Build) -> Result<Self, Failure> {
        let module = fs::read_to_string(build.name(name).with_tests().run()?)?;
        let tests = fs::read_to_string(out()?.join(format!("{name}_tests.rs")))?;
        // They stand inside their module, not beside it.
        let tests = tests.replace(&format!("use super::{name} as module;\n"), "");
        let tests = tests.replace(&format!("use super::{name}::*;\n"), "");
        let tests = tests.replace("module::", "super::");
        Ok(Self {
            name,
            module,
            tests,
        })
    }

    /// The module as it is and its mutants, and a constant that lists them.
    fn listed(
        &self,
        count: u64,
        text: impl Fn(&Mutant) -> Result<String, Failure>,
    ) -> Result<String, Failure> {
        let (name, count) = (self.name, usize::try_from(count)?);
        let mut items = format!("pub mod {name} {{ {} }}\n", self.whole(&self.module));
        let mut list = String::new();
        for (place, mutant) in mutants(&self.module, count).iter().enumerate() {
            let (text, line) = (text(mutant)?, &mutant.line);
            writeln!(items, "/// `{line}`\npub mod {name}_{place} {{ {text} }}")?;
            writeln!(
                list,
                "Mutant {{ line: {line:?}, tests: {name}_{place}::tests::ALL, \
                 functions: {name}_{place}::calls::ALL }},"
            )?;
        }
        let constant = name.to_uppercase();
        Ok(format!(
            "{items}pub const {constant}: Module = Module {{ tests: {name}::tests::ALL, \
             functions: {name}::calls::ALL, mutants: &[{list}] }};\n"
        ))
    }

    /// A module and all its tests.
    fn whole(&self, module: &str) -> String {
        format!(
            "{module}\npub mod tests {{ use super::*; {} }}\n{}",
            as_functions(&self.tests),
            calls::of(module, &self.module)
        )
    }

    /// The function that is wrong, in front of the others of the module as it is: many whole ones would take minutes to
    /// compile. Identities call the functions of the module as it is, so the test of the function's values has to see what is
    /// wrong.
    fn alone(&self, mutant: &Mutant) -> Result<String, Failure> {
        let (name, function) = mutant.function();
        let mut items = self.tests.split("#[test]\n");
        let test = items.find(|item| item.starts_with(&format!("fn {name}_has_its_values(")));
        let test = format!("#[test]\n{}", test.ok_or("a function without test")?);
        Ok(format!(
            "pub use super::{system}::*;{function}\
             pub mod tests {{ use super::*; use crate::{system}::tests::*; {} }}\n{}",
            as_functions(&test),
            calls::of(&function, &self.module),
            system = self.name
        ))
    }
}

/// Modules with one token changed, each with another.
fn mutants(module: &str, count: usize) -> Vec<Mutant> {
    let mut places = BTreeSet::new();
    let seeded = (0..1000).map(|seed| mutant(module, seed));
    let distinct = seeded.filter(|mutant| places.insert(mutant.place));
    distinct.take(count).collect()
}

/// The tests as functions that can be called, with the list of them.
fn as_functions(tests: &str) -> String {
    let text = tests.replace("#[test]\nfn ", "pub fn ");
    let text = text.replace("\nconst ", "\npub const ");
    let text = text.replace("\nfn ", "\npub fn ");
    let names = tests.split("#[test]\nfn ").skip(1);
    let names = names.filter_map(|rest| rest.split('(').next());
    let names: Vec<String> = names.map(|name| format!("({name:?}, {name})")).collect();
    let names = names.join(", ");
    format!("{text}\npub const ALL: crate::Tests = &[{names}];\n")
}
