//! Names of functions among the arguments.

use kane_codegen::{
    diagnostic::{Escaped, nearest},
    error::Error,
    functions::{ALL, DEFAULT, Parsed, RequestError, is_set, split},
    options::{Functions, is_in_all},
};

use crate::cli::Failures;

/// Reads a name of `--functions` or `--function`, which may be one that `kane.toml` gives.
pub(crate) fn request(text: &str, listed: Option<&Functions>) -> Result<Parsed, Failures> {
    if let Some(named) = listed.and_then(|listed| named(text, listed)) {
        return Ok(named);
    }
    let faults = match Parsed::read(text) {
        Ok(request) => return Ok(request),
        Err(faults) => faults,
    };
    let requests = listed.map_or_else(Vec::new, Functions::requests);
    let given: Vec<&str> = requests.iter().filter_map(Parsed::given_name).collect();
    if let [RequestError::Unknown { name }] = &faults[..]
        && let Some(near) = nearest(name, &given)
    {
        let name = name.escaped();
        return Err(Failures::message(format!(
            "`{name}` is no function; did you mean `{near}` of kane.toml?"
        )));
    }
    Err(Error::Requests(faults).into())
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
pub(crate) fn functions(
    lists: &[String],
    listed: Option<&Functions>,
) -> Result<Functions, Failures> {
    let names = names(lists);
    let mut failures = Failures::default();
    let plain: Vec<String> = names.iter().map(|name| Parsed::plain(name)).collect();
    for (index, name) in names.iter().enumerate() {
        let request = (!is_set(name)).then(|| request(name, listed)).transpose();
        if name.is_empty() {
            failures.add(Failures::message(if names.len() == 1 {
                "--functions names none; expected names, or `all`"
            } else {
                "--functions has no name between two commas, or behind the last"
            }));
        } else if let Err(fault) = request {
            failures.add(fault);
        } else if plain[..index].contains(&plain[index]) {
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
    let texts = names.into_iter().map(|name| {
        let named = listed.and_then(|listed| named(name, listed));
        named.map_or_else(|| name.to_owned(), |own| own.text())
    });
    Ok(Functions::of(texts))
}
