//! Names of bodies: those that are given, and others for bodies that have none.

use std::collections::BTreeMap;

use crate::description::WrittenBody;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span, Spanned};

/// How a body is to be called.
#[derive(Clone, Debug)]
pub(super) enum Wish {
    /// As the file says.
    Given(Spanned<String>),
    /// The file says nothing.
    None(Span),
    /// After the body whose joints it carries, and one of them.
    After {
        /// The place of that body in the list.
        body: usize,
        joint: String,
        span: Span,
    },
}

/// Names that are in use, each with the last number that was tried behind it.
type Used = BTreeMap<String, usize>;

/// Names the bodies, no two of them the same by our doing.
pub(super) fn give(reader: &mut Reader, bodies: &mut [WrittenBody], wishes: &[Wish]) {
    let mut used = Used::new();
    for (body, wish) in bodies.iter_mut().zip(wishes) {
        if let Wish::Given(name) = wish {
            used.insert(name.value.clone(), 1);
            body.name = Some(name.clone());
        }
    }
    let mut number = 0;
    for (body, wish) in bodies.iter_mut().zip(wishes) {
        if let Wish::None(span) = wish {
            let name = loop {
                number += 1;
                let name = format!("body{number}");
                if !used.contains_key(&name) {
                    break name;
                }
            };
            let note = Diagnostic::note(format!("a body without a name is called `{name}`"));
            reader.faults.push(note.at(*span, "no name"));
            used.insert(name.clone(), 1);
            body.name = Some(Spanned::new(name, *span));
        }
    }
    for (index, wish) in wishes.iter().enumerate() {
        if let Wish::After { body, joint, span } = wish {
            let owner = bodies.get(*body).and_then(|body| body.name.as_ref());
            let owner = owner.map_or("body", |name| name.value.as_str());
            let name = free(&mut used, format!("{owner}_{joint}"));
            bodies[index].name = Some(Spanned::new(name, *span));
        }
    }
}

/// The name, or with a number behind it where it is taken.
fn free(used: &mut Used, name: String) -> String {
    let mut tried = used.get(&name).copied().unwrap_or(0);
    let mut found = name.clone();
    if tried > 0 {
        loop {
            tried += 1;
            found = format!("{name}_{tried}");
            if !used.contains_key(&found) {
                break;
            }
        }
        used.insert(name, tried);
    }
    used.entry(found.clone()).or_insert(1);
    found
}
