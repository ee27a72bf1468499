//! What rounded right angles cost: operations that a larger tolerance of constant rotations saves.
//!
//! In: a description, and what is asked for of it. Out: a note, where functions would need fewer operations; found by
//! compiling them a second time. Does not: change anything; the user decides what is exact.

use std::cmp::Reverse;

use crate::{
    compile,
    description::Description,
    diagnostic::{Diagnostic, Diagnostics, first_few},
    generate,
    limits::COUNTED,
    options::Options,
    program::Operations,
    tree::{self, Changes, Tree},
};

/// The most operations of functions that are compiled a second time.
const OPERATIONS: usize = 200_000;

/// Says how many operations a larger tolerance saves: in these functions, which the options ask for, with their operations;
/// `None` where they are not known. No note where it saves none, or where it would take long to know.
pub fn note(
    description: &Description,
    options: &Options,
    functions: Option<&[(String, Operations)]>,
) -> Option<Diagnostics> {
    let near = tree::nearly_exact(description, options.changes.snap)?;
    let before = match functions {
        Some(functions) => functions.to_vec(),
        None => compiled(description, options)?,
    };
    let all: usize = before.iter().map(|(_, counted)| counted.total()).sum();
    if all > OPERATIONS {
        return None;
    }
    let options = Options {
        changes: Changes {
            snap: near.snap,
            ..options.changes.clone()
        },
        ..options.clone()
    };
    let saved = saved(&before, &compiled(description, &options)?);
    if saved.is_empty() {
        return None;
    }
    let shown = saved.iter();
    let shown = shown.map(|(name, percent)| format!("{percent} % of `{name}`"));
    let shown = first_few(&shown.collect::<Vec<_>>());
    let note = format!(
        "rounded right angles cost operations: `--snap {snap:?}`, or `snap = {snap:?}` in `kane.toml`, saves {shown}, and \
        turns no axis by more than {angle:.1e} rad",
        snap = near.snap,
        angle = near.angle,
    );
    let note = Diagnostic::note(note);
    Some(Diagnostics::new(description.source.clone(), vec![note]))
}

/// The functions that need fewer operations, with how many per cent fewer, most first.
fn saved(before: &[(String, Operations)], after: &[(String, Operations)]) -> Vec<(String, usize)> {
    let percent = |(name, old): &(String, Operations)| {
        let (_, new) = after.iter().find(|(other, _)| other == name)?;
        let (old, new) = (old.total(), new.total());
        // To the nearest.
        let percent = (200 * old.saturating_sub(new) + old) / (2 * old).max(1);
        (percent > 0).then(|| (name.clone(), percent))
    };
    let mut saved: Vec<(String, usize)> = before.iter().filter_map(percent).collect();
    saved.sort_by_key(|(_, percent)| Reverse(*percent));
    saved
}

/// The functions that are asked for, with their operations; `None` where they cannot be had, or not soon.
fn compiled(description: &Description, options: &Options) -> Option<Vec<(String, Operations)>> {
    let tree = generate::checked(description, options).ok()?.tree;
    let is_small = |tree: &Tree| tree.n_speeds.max(tree.n_parts()) <= COUNTED;
    let compiled = is_small(&tree).then(|| compile::compile(&tree, options))?;
    let functions = compiled.ok()?.functions.into_iter();
    let functions = functions.map(|one| (one.request.name(), one.operations));
    Some(functions.collect())
}
