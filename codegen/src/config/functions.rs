//! Functions that a `kane.toml` names, each of which is known.

use std::collections::BTreeMap;

use crate::{
    description::toml_reader::{Reader, Table, span},
    diagnostic::{Diagnostic, Escaped, Spanned},
    functions::{ALL, Parsed, RequestError, advice, is_set},
    options::{Functions, is_in_all},
};

/// The functions that a system names, where they stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Named {
    /// The list, in the words of messages.
    what: String,
    /// The entries, by what each asks for however it writes that.
    asked: BTreeMap<String, Spanned<String>>,
}

/// Reads `functions` of a system.
pub(super) fn read(reader: &mut Reader, system: &Table<'_, '_>) -> Option<(Functions, Named)> {
    let Some(item) = system.get("functions") else {
        return Some((Functions::default(), Named::default()));
    };
    let what = system.what("functions");
    let entries = reader.list(item, &what, "names")?;
    if entries.is_empty() {
        let fault = Diagnostic::error(format!("{what} is empty"))
            .at(span(item), "expected names, \"default\" or \"all\"");
        reader
            .faults
            .push(fault.help("leave `functions` out for the default set"));
        return None;
    }
    let mut names: Vec<Spanned<String>> = Vec::new();
    let mut asked: BTreeMap<String, Spanned<String>> = BTreeMap::new();
    for (index, entry) in entries.iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        let is_function = !is_set(&name.value);
        let faults = is_function.then(|| request_faults(&name, &what));
        let faults = faults.unwrap_or_default();
        if !faults.is_empty() {
            reader.faults.extend(faults);
            continue;
        }
        let plain = Parsed::plain(&name.value);
        if let Some(first) = asked.get(&plain) {
            let fault = Diagnostic::error(format!("{what} names `{}` twice", name.value));
            reader.faults.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            asked.insert(plain, name.clone());
            names.push(name);
        }
    }
    if let Some(all) = names.iter().find(|name| name.value == ALL) {
        for name in names.iter().filter(|name| is_in_all(&name.value)) {
            let fault = format!("{what} names `{}` beside `{ALL}`", name.value);
            let fault = Diagnostic::error(fault).at(name.span, "one of them");
            reader
                .faults
                .push(fault.at(all.span, "this names them all"));
        }
    }
    let functions = Functions::of(names.iter().map(|name| name.value.clone()));
    Some((functions, Named { what, asked }))
}

impl Named {
    /// What is wrong with them on a model, at the entries that it is about; `None` where it is about none.
    pub fn fault(&self, fault: &RequestError) -> Option<Diagnostic> {
        match fault {
            RequestError::SameName { first, second, .. } => Some(self.both([first, second], fault)),
            RequestError::SameConstant { requests, .. } => {
                Some(self.both(requests.each_ref(), fault))
            }
            RequestError::UnknownFrame { request, .. } => Some(part_fault(
                self.entry(request)?,
                &self.what,
                fault,
                "unknown frame",
            )),
            RequestError::UnknownVariable { request, .. } => Some(part_fault(
                self.entry(request)?,
                &self.what,
                fault,
                "unknown variable",
            )),
            RequestError::OneOfDirection { request, .. } => Some(part_fault(
                self.entry(request)?,
                &self.what,
                fault,
                "no direction",
            )),
            RequestError::Repeated { request, .. }
            | RequestError::OwnArguments { request, .. }
            | RequestError::SameOutput { request, .. } => {
                Some(part_fault(self.entry(request)?, &self.what, fault, ""))
            }
            _ => None,
        }
    }

    /// What is wrong with two of them, of which one may be there in every module.
    fn both(&self, requests: [&String; 2], fault: &RequestError) -> Diagnostic {
        let entries = requests.map(|text| self.entry(text));
        let mut spans: Vec<_> = entries.into_iter().flatten().map(|own| own.span).collect();
        spans.sort_by_key(|span| std::cmp::Reverse(span.start));
        spans.dedup();
        let shown = Diagnostic::error(format!("{}: {fault}", self.what));
        match spans[..] {
            [one] => shown.at(one, "here"),
            [second, first] => shown
                .at(second, "the second one")
                .at(first, "the first one"),
            _ => shown,
        }
    }

    /// The entry that asks for this, however it writes that.
    fn entry(&self, request: &str) -> Option<&Spanned<String>> {
        self.asked.get(&Parsed::plain(request))
    }
}

/// All that is wrong with the name of a function in a list or table.
pub(super) fn request_faults(name: &Spanned<String>, what: &str) -> Vec<Diagnostic> {
    let faults = Parsed::read(&name.value).err().unwrap_or_default();
    let shown = faults.iter().map(|fault| request_fault(name, what, fault));
    shown.collect()
}

fn request_fault(name: &Spanned<String>, what: &str, fault: &RequestError) -> Diagnostic {
    let RequestError::Unknown { name: part } = fault else {
        return part_fault(name, what, fault, "here");
    };
    let whole = if *part == name.value {
        String::new()
    } else {
        format!(" in `{}`", name.value.escaped())
    };
    let fault = Diagnostic::error(format!(
        "{what} names `{}`{whole}, which is no function",
        part.escaped()
    ));
    let fault = fault.at(name.span, "unknown function");
    fault.help(advice(part))
}

/// What is wrong with a request of known functions, with its place in the text where that stands there as it is.
fn part_fault(name: &Spanned<String>, what: &str, fault: &RequestError, label: &str) -> Diagnostic {
    let shown = Diagnostic::error(format!("{what}: {fault}"));
    let Some(place) = fault.place() else {
        return shown.at(name.span, "in this request");
    };
    // Between two quotes of one character each, and nothing escaped.
    let is_plain = name.span.end - name.span.start == name.value.len() + 2;
    let start = name.span.start + 1;
    let span = if is_plain {
        (start + place.start..start + place.end.max(place.start + 1)).into()
    } else {
        name.span
    };
    shown.at(span, label)
}
