//! Functions that a `kane.toml` names, each of which is known.

use crate::{
    description::toml_reader::{Reader, Table, list, span},
    diagnostic::{Diagnostic, Spanned, nearest},
    functions::{Request, RequestError},
    options::Functions,
};

/// Reads `functions` of a system.
pub(super) fn read(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    known: &[&str],
) -> Option<Functions> {
    let Some(item) = system.get("functions") else {
        return Some(Functions::Default);
    };
    let what = system.what("functions");
    let entries = reader.list(item, &what, "names")?;
    if entries.is_empty() {
        let fault = Diagnostic::error(format!("{what} is empty"))
            .at(span(item), "expected names, or \"all\"");
        reader
            .faults
            .push(fault.help("leave `functions` out for the default set"));
        return None;
    }
    let mut names: Vec<Spanned<String>> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        let all = name.value == "all";
        if let Some(fault) = (!all).then(|| request_fault(&name, &what, known)).flatten() {
            reader.faults.push(fault);
        } else if let Some(first) = names.iter().find(|first| first.value == name.value) {
            let fault = Diagnostic::error(format!("{what} names `{}` twice", name.value));
            reader.faults.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            names.push(name);
        }
    }
    let all = names.iter().find(|name| name.value == "all");
    match all {
        Some(_) if entries.len() == 1 => Some(Functions::All),
        Some(all) => {
            let fault = Diagnostic::error(format!("{what} names functions beside `all`"));
            reader
                .faults
                .push(fault.at(all.span, "this names them all"));
            None
        }
        None => Some(Functions::Named(
            names.into_iter().map(|name| name.value).collect(),
        )),
    }
}

/// What is wrong with the name of a function in a list or table.
pub(super) fn request_fault(
    name: &Spanned<String>,
    what: &str,
    known: &[&str],
) -> Option<Diagnostic> {
    let among = |part: &str| known.contains(&part);
    let fault = match Request::parse(&name.value) {
        Ok(request) => {
            let mut parts = request.parts().iter().map(|part| part.name);
            let name = parts.find(|part| !among(part))?.to_owned();
            RequestError::Unknown { name }
        }
        Err(fault) => fault,
    };
    let RequestError::Unknown { name: part } = fault else {
        let fault = Diagnostic::error(format!("{what}: {fault}"));
        return Some(fault.at(name.span, "cannot be joined"));
    };
    let whole = if part == name.value {
        String::new()
    } else {
        format!(" in `{}`", name.value.escape_debug())
    };
    let fault = Diagnostic::error(format!(
        "{what} names `{}`{whole}, which is no function",
        part.escape_debug()
    ));
    let help = match nearest(&part, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the functions are {}", list(known)),
    };
    Some(fault.at(name.span, "unknown function").help(help))
}
