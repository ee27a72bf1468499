//! The arguments that say what is generated of a model, and how.
//!
//! In: arguments. Out: what they ask for, read, to stand above what `kane.toml` says.

use std::path::Path;

use clap::Args;
use kane_codegen::{
    config::Named,
    error::Error,
    functions::{Parsed, split},
    options::{ALL, Formulation, Functions, Options, is_in_all, is_set},
    recursive::Technique,
};

use crate::cli::{
    Failures,
    arguments::changes::ChangesArguments,
    arguments::parse::{name_of, one_of},
    job::Listing,
    listed,
};

/// What is generated of a model, and how.
#[derive(Args, Debug)]
pub(crate) struct OptionsArguments {
    /// The functions, comma-separated; `all` for every function of the system, `default` for the default set
    ///
    /// `kane info MODEL --functions all` lists the functions of the system. `mass_matrix+bias` is one function that computes both, and
    /// `step = mass_matrix+bias` names it; `bias(sin_cos)` takes the sines and cosines of the angles as inputs. `q_dot`, and with
    /// quaternions `normalize`, are always generated: the trait `kane::System` needs them.
    #[arg(long, value_name = "A,B", requires = "model")]
    functions: Option<Vec<String>>,

    /// How to compute sums over bodies: `notes`, term by term as in the lecture notes that docs/equations.md cites; `recursive`,
    /// along the tree; `cheapest`, whichever costs less
    #[arg(long, value_name = "WHICH", requires = "model", value_parser = one_of(Formulation::ALL))]
    formulation: Option<Formulation>,

    /// Use fused multiply-add: faster on hardware that has it, but the last bits then depend on the machine
    ///
    /// Generated code calls `kane::Real::mul_add`. It is one instruction if the compilation target has one (x86 with
    /// `-C target-feature=+fma` or a `target-cpu` that has it, 64-bit Arm), else two. `--fma=false` overrides
    /// `fma = true` in `kane.toml`.
    #[arg(
        long,
        value_name = "BOOL",
        requires = "model",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "true"
    )]
    fma: Option<bool>,

    /// Operation-saving techniques to disable, comma-separated; the values stay the same
    #[arg(long, value_name = "A,B", requires = "model", value_delimiter = ',', value_parser = one_of(Technique::ALL))]
    without: Vec<Technique>,

    #[command(flatten)]
    changes: ChangesArguments,
}

/// What is asked for, read.
pub(crate) struct Asked<'a> {
    arguments: &'a OptionsArguments,
    functions: Option<Functions>,
}

impl OptionsArguments {
    /// What is asked for, or everything that is wrong with it.
    pub(crate) fn read(&self) -> Result<Asked<'_>, Failures> {
        let mut failures = Failures::default();
        let functions = self.functions.as_deref().map(functions).transpose();
        let functions = failures.keep(functions).flatten();
        failures.keep(self.changes.check());
        failures.none()?;
        Ok(Asked {
            arguments: self,
            functions,
        })
    }

    /// What the model lacks of that, beside names that are none. What is wrong with the model itself waits until they are right.
    pub(crate) fn lacking(&self, model: &Path) -> Failures {
        let asked = self.functions.as_deref().unwrap_or_default();
        let job = listed::looked_at(model, &self.changes, asked);
        let checked = job.and_then(|job| job.checked());
        let mut failures = Failures::default();
        if let Ok(checked) = checked {
            let requests = names(asked)
                .into_iter()
                .filter_map(|name| Parsed::read(name).ok());
            for request in requests {
                failures.keep(request.on(&checked.tree).map_err(Error::Requests));
            }
        }
        failures
    }

    /// The same arguments, as words of a command.
    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = Vec::new();
        let mut push = |word: &str| words.push(word.to_owned());
        if let Some(functions) = &self.functions {
            push("--functions");
            push(&functions.join(","));
        }
        if let Some(formulation) = self.formulation {
            push("--formulation");
            push(name_of(&formulation, &Formulation::ALL));
        }
        if !self.without.is_empty() {
            push("--without");
            let names = self.without.iter();
            let names: Vec<&str> = names.map(|one| name_of(one, &Technique::ALL)).collect();
            push(&names.join(","));
        }
        if let Some(fma) = self.fma {
            push(if fma { "--fma" } else { "--fma=false" });
        }
        words.extend(self.changes.words());
        words
    }
}

impl Asked<'_> {
    /// True where functions are asked for, in place of those that `kane.toml` has.
    pub(crate) fn says_functions(&self) -> bool {
        self.functions.is_some()
    }

    /// Leaves out what `kane.toml` names and it names others for.
    pub(crate) fn replace(&self, listing: &mut Listing) {
        if self.functions.is_some() {
            listing.functions = Named::default();
        }
        self.arguments.changes.replace(listing);
    }

    /// Sets what is asked for, above what was said before.
    pub(crate) fn set(&self, options: &mut Options) {
        let arguments = self.arguments;
        arguments.changes.set(options);
        let Options {
            functions,
            formulation,
            fma,
            without,
            ..
        } = options;
        if let Some(asked) = &self.functions {
            functions.clone_from(asked);
        }
        *formulation = arguments.formulation.unwrap_or(*formulation);
        *fma = arguments.fma.unwrap_or(*fma);
        if !arguments.without.is_empty() {
            *without = arguments.without.iter().copied().collect();
        }
    }
}

/// Reads a name of `--functions` or `--function`.
pub(crate) fn request(text: &str) -> Result<Parsed, Failures> {
    Parsed::read(text).map_err(|faults| Error::Requests(faults).into())
}

/// The names in what `--functions` was given, each time it stood there: commas inside brackets separate none.
fn names(lists: &[String]) -> Vec<&str> {
    lists.iter().flat_map(|list| split(list)).collect()
}

/// The function to which `kane.toml` gives this name.
pub(crate) fn named(name: &str, listed: &Functions) -> Option<Parsed> {
    let mut requests = listed.requests().into_iter();
    requests.find(|own| own.given_name() == Some(name.trim()))
}

/// True where each of these is among the listed functions, by its request or the name that `kane.toml` gives it.
pub(crate) fn are_listed(asked: &[String], listed: &Functions) -> bool {
    let requests: Vec<String> = listed.requests().iter().map(Parsed::text).collect();
    let is_listed = |name: &str| {
        let parsed = Parsed::read(name).ok();
        let function = parsed.as_ref().and_then(Parsed::catalogue_function);
        named(name, listed).is_some()
            || function.is_some_and(|function| listed.names(function))
            || parsed.is_some_and(|parsed| requests.contains(&parsed.text()))
    };
    names(asked).into_iter().all(is_listed)
}

/// Reads `--functions`, in which names may stand that `kane.toml` gives.
pub(crate) fn functions_of(lists: &[String], listed: &Functions) -> Result<Functions, Failures> {
    let names = names(lists).into_iter().map(|name| {
        let named = named(name, listed);
        named.map_or_else(|| name.to_owned(), |own| own.text())
    });
    functions(&names.collect::<Vec<_>>())
}

/// Reads `--functions`.
pub(crate) fn functions(lists: &[String]) -> Result<Functions, Failures> {
    let names = names(lists);
    let mut failures = Failures::default();
    for (index, name) in names.iter().enumerate() {
        let request = (!is_set(name)).then(|| request(name)).transpose();
        if name.trim().is_empty() {
            failures.add(Failures::message(
                "--functions has no name between two commas, or behind the last",
            ));
        } else if let Err(fault) = request {
            failures.add(fault);
        } else if names[..index].contains(name) {
            failures.add(Failures::message(format!(
                "--functions names `{name}` twice"
            )));
        } else if names.contains(&ALL) && is_in_all(name) {
            failures.add(Failures::message(format!(
                "--functions names `{name}` beside `{ALL}`, which has it"
            )));
        }
    }
    failures.none()?;
    Ok(Functions::of(names.into_iter().map(str::to_owned)))
}
