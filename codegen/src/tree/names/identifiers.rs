//! The Rust identifiers that stand for bodies and joints in generated code.
//!
//! In: names as the user wrote them. Out: one identifier a body or joint, lower snake case, ASCII, unique, no keyword.
//! A name that is such an identifier stays as it is; others give way. Does not: know of other names of the output.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Spanned};
use crate::words::is_rust_keyword;

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
                Diagnostic::note(note)
                    .at(name.span, "no lower snake case identifier of its own")
                    .one_of(
                        "bodies have other names in generated code",
                        format!("`{}` is `{identifier}`", name.value.escape_debug()),
                    ),
            );
        }
        unique.push(identifier);
    }
    unique
}

/// The identifiers of frames with these names, beside those of the bodies.
pub(crate) fn frame_identifiers<'a>(
    names: impl Iterator<Item = &'a str>,
    bodies: &[String],
) -> Vec<String> {
    let mut taken: BTreeSet<String> = bodies.iter().cloned().collect();
    let mut next = BTreeMap::new();
    let unique = |name: &str| unique_among(&identifier(name), &mut taken, &mut next);
    names.map(unique).collect()
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
