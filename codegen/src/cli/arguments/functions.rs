//! Names of functions among the arguments.

use kane_codegen::{
    error::Error,
    functions::{Parsed, split},
    options::{ALL, DEFAULT, Functions, is_in_all, is_set},
};

use crate::cli::Failures;

/// Reads a name of `--functions` or `--function`.
pub(crate) fn request(text: &str) -> Result<Parsed, Failures> {
    Parsed::read(text).map_err(|faults| Error::Requests(faults).into())
}

/// The names in what `--functions` was given, each time it stood there: commas inside brackets separate none.
pub(super) fn names(lists: &[String]) -> Vec<&str> {
    let names = lists.iter().flat_map(|list| split(list));
    names.map(str::trim).collect()
}

/// The function to which `kane.toml` gives this name.
pub(crate) fn named(name: &str, listed: &Functions) -> Option<Parsed> {
    let mut requests = listed.requests().into_iter();
    requests.find(|own| own.given_name() == Some(name.trim()))
}

/// True where each of these is among the listed functions, by its request or the name that `kane.toml` gives it.
pub(crate) fn are_listed(asked: &[String], listed: &Functions) -> bool {
    let requests: Vec<String> = listed.requests().iter().map(Parsed::sum).collect();
    let is_listed = |name: &str| {
        if is_set(name) {
            return match listed {
                Functions::All(_) => true,
                Functions::Default(_) => name == DEFAULT,
                Functions::Named(_) => false,
            };
        }
        let parsed = Parsed::read(name).ok();
        let function = parsed.as_ref().and_then(Parsed::catalogue_function);
        named(name, listed).is_some()
            || function.is_some_and(|function| listed.names(function))
            || parsed.is_some_and(|parsed| requests.contains(&parsed.sum()))
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
        if name.is_empty() {
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
