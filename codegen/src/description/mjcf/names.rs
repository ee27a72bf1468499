//! Names of bodies and joints: those that are given, and others for those that have none.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::WrittenBody;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};

/// How a body is to be called.
#[derive(Clone, Debug)]
pub(super) enum Wish {
    /// As the file says.
    Given(Spanned<String>),
    /// The file says nothing.
    None(Span),
    /// After the body whose joints it carries, and one of them.
    After {
        /// The place of that body in the list, which is called after no other.
        body: usize,
        joint: String,
        span: Span,
    },
}

/// Names that are in use, each with the last number that was tried behind it.
type Used = BTreeMap<String, usize>;

/// The names of the bodies, no two of them the same by our doing.
pub(super) fn give(reader: &mut Reader, wishes: &[Wish]) -> Vec<Spanned<String>> {
    let mut used = Used::new();
    // Of the bodies that are called after no other.
    let mut own: BTreeMap<usize, Spanned<String>> = BTreeMap::new();
    for (body, wish) in wishes.iter().enumerate() {
        if let Wish::Given(name) = wish {
            used.insert(name.value.clone(), 1);
            own.insert(body, name.clone());
        }
    }
    let mut number = 0;
    for (body, wish) in wishes.iter().enumerate() {
        if let Wish::None(span) = wish {
            let name = invented(&mut used, &mut number);
            let note = Diagnostic::note(format!("a body without a name is called `{name}`"));
            let plural = "bodies without names are given some";
            let note = note.one_of(plural, format!("`{name}`"));
            reader.faults.push(note.at(*span, "no name"));
            own.insert(body, Spanned::new(name, *span));
        }
    }
    let name = |(body, wish): (usize, &Wish)| match wish {
        Wish::Given(_) | Wish::None(_) => own[&body].clone(),
        Wish::After { body, joint, span } => {
            let owner = &own[body].value;
            Spanned::new(free(&mut used, format!("{owner}_{joint}")), *span)
        }
    };
    wishes.iter().enumerate().map(name).collect()
}

/// Gives names to joints that have none where another joint is called as their body: in MuJoCo these do not meet.
pub(super) fn tell_joints_apart(reader: &mut Reader, bodies: &mut [WrittenBody]) {
    let joints = bodies.iter().filter_map(|body| body.joint.name.as_ref());
    let given: BTreeSet<String> = joints.map(|name| name.value.clone()).collect();
    let all = bodies.iter().filter_map(WrittenBody::joint_name);
    let mut used: Used = all.map(|name| (name.value.clone(), 1)).collect();
    for body in bodies {
        let own = body.joint_name().filter(|_| body.joint.name.is_none());
        let Some(own) = own.filter(|own| given.contains(&own.value)) else {
            continue;
        };
        let name = free(&mut used, own.value.clone());
        let note = Diagnostic::note(format!(
            "the joint of body `{}`, which has no name, is called `{name}`",
            shown(&own.value)
        ));
        let plural = "joints without names are given some";
        let note = note.one_of(plural, format!("`{name}`"));
        reader
            .faults
            .push(note.at(own.span, "another joint has this name"));
        body.joint.name = Some(Spanned::new(name, own.span));
    }
}

/// The next name of ours that is not in use.
fn invented(used: &mut Used, number: &mut usize) -> String {
    loop {
        *number += 1;
        let name = format!("body{number}");
        if !used.contains_key(&name) {
            used.insert(name.clone(), 1);
            return name;
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
