//! Names of frames that only mark places, and of the bodies in which they are fixed.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::{Carrier, Description};
use crate::diagnostic::{Diagnostic, Escaped, NearNames, Spanned};
use crate::tree::names::lookup::listed;
use crate::tree::names::rules::check_one;

/// Names that are empty, unprintable, or given to another frame or a body too; and bodies that are not there.
pub(crate) fn check_frames(description: &Description, findings: &mut Vec<Diagnostic>) {
    let bodies = description.bodies.iter();
    let bodies = bodies.filter_map(|body| Some(("body", body.name.as_ref()?)));
    let mut known: BTreeMap<&str, (&str, &Spanned<String>)> = BTreeMap::new();
    for (kind, name) in bodies.clone() {
        known.entry(&name.value).or_insert((kind, name));
    }
    let written: Vec<&str> = bodies.map(|(_, name)| name.value.as_str()).collect();
    let names: BTreeSet<&str> = written.iter().copied().collect();
    // A body whose name is missing, or a list that is not there, is the fault then.
    let all_named = !names.is_empty() && written.len() == description.bodies.len();
    let mut near = NearNames::default();
    for (index, frame) in description.frames.iter().enumerate() {
        check_one(
            frame.name.as_ref(),
            &format!("frame {}'s", index + 1),
            findings,
        );
        if let Some(name) = frame.name.as_ref().filter(|name| !name.value.is_empty()) {
            if let Some((kind, first)) = known.get(name.value.as_str()) {
                let shown = name.value.escaped();
                let fault = match *kind {
                    "body" => format!("a body and a frame have the name `{shown}`"),
                    _ => format!("two frames have the name `{shown}`"),
                };
                findings.push(
                    Diagnostic::error(fault)
                        .at(name.span, "the second one")
                        .at(first.span, "the first one"),
                );
            } else {
                known.insert(&name.value, ("frame", name));
            }
        }
        if let Carrier::Body(Some(body)) = &frame.body
            && all_named
            && !names.contains(body.value.as_str())
        {
            let frame = match &frame.name {
                Some(name) if !name.value.is_empty() => format!("frame `{}`", name.value.escaped()),
                _ => format!("frame {}", index + 1),
            };
            findings.push(unknown_body(&frame, body, &written, &mut near));
        }
    }
}

fn unknown_body(
    frame: &str,
    body: &Spanned<String>,
    names: &[&str],
    near: &mut NearNames,
) -> Diagnostic {
    let shown = body.value.escaped();
    let fault = Diagnostic::error(format!("{frame} is fixed in `{shown}`, which is no body"));
    let help = if names.is_empty() {
        "without `body` it is fixed in the inertial frame".to_owned()
    } else if let Some(near) = near.nearest(&body.value, names.iter().copied()) {
        format!("did you mean `{}`?", near.escaped())
    } else {
        let names = listed(names);
        format!("bodies are {names}; without `body` it is fixed in the inertial frame")
    };
    fault.at(body.span, "unknown body").help(help)
}
