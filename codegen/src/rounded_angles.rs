//! What rounded right angles cost: operations that a larger tolerance of constant rotations saves.
//!
//! In: a description, and what is asked for of it. Out: a note, where functions would need fewer operations; found by
//! compiling them a second time. Does not: change anything; the user decides what is exact.

use crate::{
    compile,
    description::Description,
    diagnostic::{Diagnostic, Diagnostics},
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
        Some(functions) => total(functions.iter().map(|(_, operations)| operations)),
        None => compiled(description, options)?,
    };
    if before > OPERATIONS {
        return None;
    }
    let options = Options {
        changes: Changes {
            snap: near.snap,
            ..options.changes.clone()
        },
        ..options.clone()
    };
    let after = compiled(description, &options)?;
    // Per cent, to the nearest.
    let saved = (200 * before.saturating_sub(after) + before) / (2 * before).max(1);
    if saved == 0 {
        return None;
    }
    let note = format!(
        "rounded right angles cost operations: `--snap {snap:?}`, or `snap = {snap:?}` in `kane.toml`, saves {saved} % of those of \
        these functions ({after} in the place of {before}) and turns no axis by more than {angle:.1e} rad",
        snap = near.snap,
        angle = near.angle,
    );
    let name = description.name.as_ref().map_or("", |name| &name.value);
    let note = Diagnostic::note(note).one_of("models whose rounded angles cost operations", name);
    Some(Diagnostics::new(description.source.clone(), vec![note]))
}

/// The operations of the functions that are asked for; `None` where they cannot be had, or not soon.
fn compiled(description: &Description, options: &Options) -> Option<usize> {
    let tree = tree::build_with(description, &options.changes).ok()?.tree;
    let tree = tree::prescribe(description, tree, &options.prescribed).ok()?;
    let is_small = |tree: &Tree| tree.n_speeds.max(tree.n_parts()) <= COUNTED;
    let compiled = is_small(&tree).then(|| compile::compile(&tree, options))?;
    let compiled = compiled.ok()?;
    Some(total(
        compiled
            .functions
            .iter()
            .map(|function| &function.operations),
    ))
}

fn total<'a>(operations: impl Iterator<Item = &'a Operations>) -> usize {
    operations.map(|operations| operations.total()).sum()
}
