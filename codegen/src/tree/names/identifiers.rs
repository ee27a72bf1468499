//! The Rust identifiers that stand for bodies and joints in generated code.
//!
//! In: names as the user wrote them. Out: one identifier a body or joint, lower snake case, ASCII, unique, no keyword.
//! A name that is such an identifier stays as it is; others give way. Does not: know of other names of the output.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Escaped, Spanned};
use crate::tree::joints::ResolvedJoint;
use crate::words::is_rust_keyword;

/// The identifiers of bodies with these names, and for those that had to change a note.
pub(crate) fn identifiers(
    names: &[Spanned<String>],
    findings: &mut Vec<Diagnostic>,
) -> Vec<String> {
    let names: Vec<&Spanned<String>> = names.iter().collect();
    let identifiers = unique(&names, BTreeSet::new());
    let plural = "bodies have other names in generated code";
    note_changed(["body", plural], &names, &identifiers, findings);
    identifiers
}

/// The identifiers of frames with these names, beside those of the bodies; notes likewise.
pub(crate) fn frame_identifiers(
    names: &[&Spanned<String>],
    bodies: &[String],
    findings: &mut Vec<Diagnostic>,
) -> Vec<String> {
    let identifiers = unique(names, bodies.iter().cloned().collect());
    let plural = "frames have other names in generated code";
    note_changed(["frame", plural], names, &identifiers, findings);
    identifiers
}

/// Notes of joints with names of their own that are called otherwise; `moving` are the places of their bodies in the user's list.
pub(crate) fn note_joints(
    description: &Description,
    moving: &[usize],
    joints: &[ResolvedJoint],
    findings: &mut Vec<Diagnostic>,
) {
    let named = moving.iter().filter_map(|&place| {
        let name = description.bodies[place].joint.name.as_ref()?;
        Some((name, joints[place].identifier.clone()))
    });
    let (names, identifiers): (Vec<_>, Vec<_>) = named.unzip();
    let plural = "joints have other names in generated code";
    note_changed(["joint", plural], &names, &identifiers, findings);
}

/// An identifier for each name, none of those that are taken. A name that is an identifier keeps it, wherever it stands in the list.
fn unique(names: &[&Spanned<String>], mut taken: BTreeSet<String>) -> Vec<String> {
    let plain: Vec<String> = names.iter().map(|name| identifier(&name.value)).collect();
    let kept: Vec<bool> = names
        .iter()
        .zip(&plain)
        .map(|(name, plain)| name.value == *plain && taken.insert(plain.clone()))
        .collect();
    let mut next = BTreeMap::new();
    let plain = plain.into_iter().zip(kept);
    plain
        .map(|(plain, kept)| {
            if kept {
                plain
            } else {
                unique_among(&plain, &mut taken, &mut next)
            }
        })
        .collect()
}

fn note_changed(
    [kind, plural]: [&'static str; 2],
    names: &[&Spanned<String>],
    identifiers: &[String],
    findings: &mut Vec<Diagnostic>,
) {
    for (name, identifier) in names.iter().zip(identifiers) {
        if *identifier != name.value {
            let shown = name.value.escaped();
            let note = format!("{kind} `{shown}` is called `{identifier}` in generated code");
            let note = Diagnostic::note(note)
                .at(name.span, "no lower snake case identifier of its own")
                .one_of(plural, format!("`{shown}` is `{identifier}`"));
            findings.push(note);
        }
    }
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
    let own = unique(&bodies.iter().collect::<Vec<_>>(), BTreeSet::new());
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
