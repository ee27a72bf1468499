//! Names of bodies, and the Rust identifiers that stand for them in generated code.
//!
//! In: names as the user wrote them. Out: one identifier a body, lower snake case, ASCII, unique, no keyword.
//! A name that is such an identifier stays as it is; others give way. Does not: know of other names of the output.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Spanned, is_unprintable};
use crate::limits::NAME_CHARACTERS;
use crate::tree::{Joint, Tree};
use crate::words::is_rust_keyword;

/// "body `hub`", or "body 3" where it has no name.
pub(crate) fn shown(description: &Description, body: usize) -> String {
    match description
        .bodies
        .get(body)
        .and_then(|body| body.name.as_ref())
    {
        Some(name) if !name.value.is_empty() => format!("body `{}`", name.value.escape_debug()),
        _ => format!("body {}", body + 1),
    }
}

/// Names that are empty, unprintable or given twice.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) {
    check_one(description.name.as_ref(), "the system's", findings);
    let mut first: BTreeMap<&str, &Spanned<String>> = BTreeMap::new();
    for (index, body) in description.bodies.iter().enumerate() {
        check_one(
            body.name.as_ref(),
            &format!("body {}'s", index + 1),
            findings,
        );
        let joint = format!("the joint of body {}:", index + 1);
        check_one(body.joint.name.as_ref(), &joint, findings);
        let Some(name) = body.name.as_ref().filter(|name| !name.value.is_empty()) else {
            continue;
        };
        if let Some(first) = first.get(name.value.as_str()) {
            let fault = Diagnostic::error(format!(
                "two bodies have the name `{}`",
                name.value.escape_debug()
            ));
            findings.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            first.insert(&name.value, name);
        }
    }
}

fn check_one(name: Option<&Spanned<String>>, whose: &str, findings: &mut Vec<Diagnostic>) {
    let Some(name) = name else { return };
    if name.value.is_empty() {
        findings.push(
            Diagnostic::error(format!("{whose} name is empty")).at(name.span, "expected a name"),
        );
    }
    let n_characters = name.value.chars().count();
    if n_characters > NAME_CHARACTERS {
        let fault = format!(
            "{whose} name has {n_characters} characters; expected at most {NAME_CHARACTERS}"
        );
        findings.push(Diagnostic::error(fault).at(name.span, "too long"));
    }
    if let Some(character) = name
        .value
        .chars()
        .find(|character| is_unprintable(*character))
    {
        let code = u32::from(character);
        let fault = format!("{whose} name holds the character U+{code:04X}, which cannot be shown");
        findings.push(Diagnostic::error(fault).at(name.span, "expected printable characters"));
    }
}

/// The identifiers of bodies with these names, and for those that had to change a note.
pub(crate) fn identifiers(
    names: &[Spanned<String>],
    findings: &mut Vec<Diagnostic>,
) -> Vec<String> {
    let plain: Vec<String> = names.iter().map(|name| identifier(&name.value)).collect();
    // A name that is an identifier keeps it, wherever it stands in the list.
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let kept: Vec<bool> = names
        .iter()
        .zip(&plain)
        .map(|(name, plain)| name.value == *plain && taken.insert(plain.clone()))
        .collect();
    let mut unique = Vec::with_capacity(names.len());
    let mut next = BTreeMap::new();
    for ((name, plain), kept) in names.iter().zip(plain).zip(kept) {
        let identifier = if kept {
            plain
        } else {
            unique_among(&plain, &mut taken, &mut next)
        };
        if identifier != name.value {
            let note = format!(
                "body `{}` is called `{identifier}` in generated code",
                name.value.escape_debug()
            );
            findings.push(
                Diagnostic::note(note).at(name.span, "no lower snake case identifier of its own"),
            );
        }
        unique.push(identifier);
    }
    unique
}

/// The identifier, or with a number behind it where it is taken; `next` holds the next one to try of each, so that thousands
/// of equal names do not try all.
fn unique_among(
    plain: &str,
    taken: &mut BTreeSet<String>,
    next: &mut BTreeMap<String, usize>,
) -> String {
    let mut unique = plain.to_owned();
    while !taken.insert(unique.clone()) {
        let suffix = next.entry(plain.to_owned()).or_insert(2);
        unique = format!("{plain}_{suffix}");
        *suffix += 1;
    }
    unique
}

/// The identifier for a name: letters and digits of ASCII in lower case, `_` for all else and where a word begins.
fn identifier(name: &str) -> String {
    let characters: Vec<char> = name.chars().collect();
    let mut identifier = String::new();
    for (index, character) in characters.iter().enumerate() {
        let before = index.checked_sub(1).map(|before| characters[before]);
        let after = characters.get(index + 1);
        let word_begins = character.is_ascii_uppercase()
            && before.is_some_and(|before| {
                before.is_ascii_lowercase()
                    || before.is_ascii_digit()
                    || (before.is_ascii_uppercase() && after.is_some_and(char::is_ascii_lowercase))
            });
        if word_begins || !character.is_ascii_alphanumeric() {
            identifier.push('_');
        }
        if character.is_ascii_alphanumeric() {
            identifier.push(character.to_ascii_lowercase());
        }
    }
    let words: Vec<&str> = identifier
        .split('_')
        .filter(|word| !word.is_empty())
        .collect();
    let identifier = words.join("_");
    if identifier.is_empty() {
        "body".to_owned()
    } else if identifier.starts_with(|first: char| first.is_ascii_digit())
        || is_rust_keyword(&identifier)
    {
        format!("body_{identifier}")
    } else {
        identifier
    }
}

/// The identifiers that stand before coordinates: of a joint's own name, or its body's.
pub(crate) fn joint_identifiers(description: &Description) -> Vec<String> {
    let bodies: Vec<Spanned<String>> = description
        .bodies
        .iter()
        .map(|body| match &body.name {
            Some(name) => name.clone(),
            None => Spanned::new(String::new(), body.span),
        })
        .collect();
    let own = identifiers(&bodies, &mut Vec::new());
    let mut taken: BTreeSet<String> = description
        .bodies
        .iter()
        .zip(&own)
        .filter(|(body, _)| body.joint.name.is_none())
        .map(|(_, own)| own.clone())
        .collect();
    // As of bodies: a name that is an identifier keeps it.
    let plain = |name: &Spanned<String>| {
        let plain = identifier(&name.value);
        (plain == name.value, plain)
    };
    let mut kept = vec![false; own.len()];
    for (body, kept) in description.bodies.iter().zip(&mut kept) {
        if let Some((true, plain)) = body.joint.name.as_ref().map(plain) {
            *kept = taken.insert(plain);
        }
    }
    let mut next = BTreeMap::new();
    let joints = description.bodies.iter().zip(own).zip(kept);
    joints
        .map(|((body, own), kept)| {
            let Some(name) = &body.joint.name else {
                return own;
            };
            let (_, plain) = plain(name);
            if kept {
                return plain;
            }
            unique_among(&plain, &mut taken, &mut next)
        })
        .collect()
}

/// The name of a joint's coordinate or component of an angular velocity, `kind`: where a joint has a name and only one,
/// the joint's.
pub(crate) fn of_coordinate(joint: &Joint, kind: &str, is_only: bool) -> String {
    if joint.is_named && is_only {
        joint.identifier.clone()
    } else {
        format!("{}_{kind}", joint.identifier)
    }
}

/// Two coordinates with one name, which a joint's own name can make.
pub(crate) fn check_coordinates(tree: &Tree, findings: &mut Vec<Diagnostic>) {
    let mut known = BTreeSet::new();
    for name in tree.coordinate_names() {
        if let Some(name) = known.replace(name) {
            findings.push(Diagnostic::error(format!(
                "two coordinates are called `{name}`; give one of their joints another name"
            )));
        }
    }
}

/// Tells in which order coordinates stand, where joints have names of their own by which a user will look for them.
pub(crate) fn note_order(tree: &Tree, findings: &mut Vec<Diagnostic>) {
    if tree.bodies.iter().any(|body| body.joint.is_named) {
        findings.push(Diagnostic::note(format!(
            "the coordinates, in order, are {}",
            tree.coordinate_names().join(", ")
        )));
    }
}
