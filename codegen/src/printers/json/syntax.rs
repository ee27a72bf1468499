//! JSON by hand: keys in the order in which they are written, and lines that a diff shows well.

use std::fmt::Display;

const NULL: &str = "null";

/// A string, quoted.
pub(super) fn string(text: &str) -> String {
    let escaped = |character: char| match character {
        '"' | '\\' => format!("\\{character}"),
        control if control.is_control() => format!("\\u{:04x}", u32::from(control)),
        plain => plain.to_string(),
    };
    let text: String = text.chars().map(escaped).collect();
    format!("\"{text}\"")
}

/// A list on one line; items are JSON already.
pub(super) fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    format!("[{}]", items.join(", "))
}

/// A list of strings on one line.
pub(super) fn strings<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    list(items.into_iter().map(|item| string(item.as_ref())))
}

/// A list with an item a line, of a member of the whole.
pub(super) fn records(items: impl IntoIterator<Item = String>) -> String {
    records_within("", items)
}

/// The same, of a member of a member.
pub(super) fn inner_records(items: impl IntoIterator<Item = String>) -> String {
    records_within("  ", items)
}

fn records_within(indent: &str, items: impl IntoIterator<Item = String>) -> String {
    let items = items.into_iter();
    let items: Vec<String> = items.map(|item| format!("{indent}    {item}")).collect();
    if items.is_empty() {
        return "[]".to_owned();
    }
    format!("[\n{}\n{indent}  ]", items.join(",\n"))
}

/// An object on one line; values are JSON already.
pub(super) fn object(members: &[(&str, String)]) -> String {
    let members = members.iter();
    let members: Vec<String> = members
        .map(|(key, value)| format!("{}: {value}", string(key)))
        .collect();
    format!("{{ {} }}", members.join(", "))
}

/// A number, with all digits that it needs to be read back; JSON has no infinite ones, and zero no sign.
pub(super) fn number(number: f64) -> String {
    if number.is_infinite() {
        return NULL.to_owned();
    }
    format!("{:?}", number + 0.0)
}

/// One string, or a list of several; null for none.
pub(super) fn one_or_several(texts: &[String]) -> String {
    match texts {
        [] => NULL.to_owned(),
        [one] => string(one),
        several => strings(several),
    }
}

/// A place, if there is one.
pub(super) fn optional(place: Option<usize>) -> String {
    place.map_or_else(|| NULL.to_owned(), |place| place.to_string())
}
