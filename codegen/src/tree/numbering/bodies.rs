//! The body-connection array: is it a tree, and in which order do its bodies count outward.
//!
//! In: the array as the user wrote it. Out: the bodies' [`Outward`] order, in which every lower body (parent) comes
//! before its bodies. Does not: keep anything of an array that is no tree.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::description::cycles::cycles;
use crate::description::{Description, Given};
use crate::diagnostic::{Diagnostic, Span};
use crate::tree::names::shown;

/// The written bodies from the inertial frame outward.
#[derive(Clone, Debug)]
pub(crate) struct Outward {
    /// Of each its place in the user's list.
    pub(crate) places: Vec<usize>,
    /// Of each where its lower body stands in this order, which is before it; `None` is the inertial frame.
    pub(crate) lowers: Vec<Option<usize>>,
}

/// The bodies outward.
///
/// Again and again the lowest-numbered body whose lower body is placed: a list that runs outward stays as it is.
/// `None` if the array is no tree, which is then among the findings.
pub(crate) fn outward(
    description: &Description,
    findings: &mut Vec<Diagnostic>,
) -> Option<Outward> {
    let lower = lowers(description, findings)?;
    if !lower.contains(&None) {
        findings.push(no_root(description, &lower));
        return None;
    }
    let mut bodies_on: Vec<Vec<usize>> = vec![Vec::new(); lower.len()];
    // Each with where its lower body stands outward.
    let mut ready = BinaryHeap::new();
    for (body, lower) in lower.iter().enumerate() {
        match lower {
            Some(lower) => bodies_on[*lower].push(body),
            None => ready.push(Reverse((body, None))),
        }
    }
    let mut places = Vec::with_capacity(lower.len());
    let mut lowers = Vec::with_capacity(lower.len());
    while let Some(Reverse((body, on))) = ready.pop() {
        let here = places.len();
        places.push(body);
        lowers.push(on);
        ready.extend(
            bodies_on[body]
                .iter()
                .map(|&body| Reverse((body, Some(here)))),
        );
    }
    if places.len() == lower.len() {
        return Some(Outward { places, lowers });
    }
    findings.extend(cycles(&lower).iter().map(|cycle| {
        let fault = Diagnostic::error(format!(
            "the lower bodies form a cycle: {}",
            chain(description, cycle)
        ));
        let help =
            "follow the lower bodies from any body, and the inertial frame, 0, must be reached";
        label(description, cycle, fault).help(help)
    }));
    None
}

/// The lower body of each body as a place in the user's list, `None` for the inertial frame; `None` if one is unusable.
fn lowers(description: &Description, findings: &mut Vec<Diagnostic>) -> Option<Vec<Option<usize>>> {
    let array = description.lower_bodies.as_ref()?;
    let n_bodies = description.bodies.len();
    if n_bodies == 0 {
        return None;
    }
    let mut usable = array.value.len() == n_bodies;
    if !usable {
        let entries = count(array.value.len(), "entry", "entries");
        let bodies = count(n_bodies, "body", "bodies");
        let fault = Diagnostic::error(format!(
            "`lower_bodies` has {entries} for {bodies}; expected one entry a body"
        ));
        findings.push(fault.at(
            array.span,
            format!("expected {}", count(n_bodies, "entry", "entries")),
        ));
    }
    let highest = n_bodies.max(array.value.len());
    let mut lowers = Vec::with_capacity(array.value.len());
    for (index, entry) in array.value.iter().enumerate() {
        let Some(number) = entry else {
            usable = false;
            continue;
        };
        match usize::try_from(number.value) {
            Ok(0) => lowers.push(None),
            Ok(lower) if lower <= highest => lowers.push(Some(lower - 1)),
            _ => {
                usable = false;
                findings.push(unknown(description, index, number.value, number.span));
            }
        }
    }
    usable.then_some(lowers)
}

fn unknown(description: &Description, body: usize, number: i64, span: Span) -> Diagnostic {
    let body = if body < description.bodies.len() {
        shown(description, body)
    } else {
        format!("body {}", body + 1)
    };
    let message = format!("{body} hangs from body {number}, which is not defined");
    let fault = Diagnostic::error(message).at(span, "unknown lower body");
    fault.help(format!(
        "the bodies are numbered from 1 to {}; 0 is the inertial frame",
        description.bodies.len()
    ))
}

fn no_root(description: &Description, lower: &[Option<usize>]) -> Diagnostic {
    let fault = Diagnostic::error("no body hangs from the inertial frame");
    let array = description.lower_bodies.as_ref().map(|array| array.span);
    let fault = fault.at_if(array, "expected at least one 0");
    fault.help_if(cycles(lower).first().map(|cycle| {
        let chain = chain(description, cycle);
        format!("write 0 for the lower body of a root; now {chain}")
    }))
}

/// The most bodies of a cycle that a message names.
const MOST_NAMED: usize = 8;

/// "body `a` hangs from body `b`, that from body `a`".
fn chain(description: &Description, cycle: &[usize]) -> String {
    let [first, rest @ ..] = cycle else {
        return String::new();
    };
    let name = |body: &usize| shown(description, *body);
    if rest.is_empty() {
        return format!("{} hangs from itself", name(first));
    }
    let mut named: Vec<String> = rest.iter().take(MOST_NAMED).map(name).collect();
    if rest.len() > MOST_NAMED {
        named.push(format!("{} more", rest.len() - MOST_NAMED));
    }
    named.push(name(first));
    format!("{} hangs from {}", name(first), named.join(", that from "))
}

/// Labels the entries of the bodies on the cycle.
fn label(description: &Description, cycle: &[usize], fault: Diagnostic) -> Diagnostic {
    let entry = |body: &usize| -> Option<Span> {
        let entries: &[Given<i64>] = &description.lower_bodies.as_ref()?.value;
        entries.get(*body)?.map(|number| number.span)
    };
    cycle
        .iter()
        .take(MOST_NAMED)
        .filter_map(|body| Some((entry(body)?, body)))
        .fold(fault, |fault, (span, body)| {
            fault.at(span, format!("lower body of {}", shown(description, *body)))
        })
}

/// Tells which bodies of the tree, at these places in the user's list, do not stand in its order.
pub(crate) fn note_moved(
    description: &Description,
    places: &[usize],
    findings: &mut Vec<Diagnostic>,
) {
    let mut in_list = places.to_vec();
    in_list.sort_unstable();
    let moved: Vec<String> = places
        .iter()
        .zip(in_list)
        .enumerate()
        .filter(|(_, (place, in_list))| *place != in_list)
        .map(|(new, (&place, _))| {
            let name = shown(description, place);
            format!("{name} from {} to {}", place + 1, new + 1)
        })
        .collect();
    let Some(array) = description
        .lower_bodies
        .as_ref()
        .filter(|_| !moved.is_empty())
    else {
        return;
    };
    let note = Diagnostic::note(format!(
        "the bodies are renumbered outward: {}",
        moved.join(", ")
    ));
    let note = note.all_of("bodies are renumbered outward", moved);
    findings.push(note.at(
        array.span,
        "every array, loads included, uses the new order",
    ));
}

fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}
