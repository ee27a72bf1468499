//! What names must be: there, printable, of bounded length, and each given once.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Escaped, Spanned, is_unprintable};
use crate::limits::NAME_CHARACTERS;
use crate::tree::system::Tree;

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
        let joint = format!("body {}'s joint's", index + 1);
        check_one(body.joint.name.as_ref(), &joint, findings);
        let Some(name) = body.name.as_ref().filter(|name| !name.value.is_empty()) else {
            continue;
        };
        if let Some(first) = first.get(name.value.as_str()) {
            let fault = Diagnostic::error(format!(
                "two bodies have the name `{}`",
                name.value.escaped()
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

pub(super) fn check_one(
    name: Option<&Spanned<String>>,
    whose: &str,
    findings: &mut Vec<Diagnostic>,
) {
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
        let names = tree.coordinate_names();
        let note = format!("the coordinates, in order, are {}", names.join(", "));
        findings.push(Diagnostic::note(note).all_of("coordinates, in order", names));
    }
}
