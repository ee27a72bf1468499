//! Which statements have a comment before them: those with which another body, or another part of the derivation, begins.

use std::collections::{BTreeMap, BTreeSet};

use super::group::Groups;
use crate::{
    expr::Purpose,
    id::BodyId,
    program::{Instruction, Program, ValueId},
    tree::Tree,
};

/// Fewer statements than this have none where their body comes back to what it had begun: what bodies share stands among
/// theirs.
const SHORTEST: usize = 3;

/// Of which body statements are, and what for.
type Subject = (Option<BodyId>, Purpose);

/// For the value of the first statement of each run its heading.
pub(super) fn of(program: &Program, groups: &Groups, tree: &Tree) -> BTreeMap<ValueId, String> {
    let mut headings = BTreeMap::new();
    let mut current = None;
    let mut begun = BTreeSet::new();
    for (subject, first, length) in runs(program, groups) {
        let is_new = begun.insert(subject);
        if current == Some(subject) || length < SHORTEST && !is_new {
            continue;
        }
        headings.insert(first, words(subject, tree));
        current = Some(subject);
    }
    headings
}

/// Consecutive statements with one subject: their first value, and how many there are.
fn runs(program: &Program, groups: &Groups) -> Vec<(Subject, ValueId, usize)> {
    let mut runs: Vec<(Subject, ValueId, usize)> = Vec::new();
    for instruction in &program.instructions {
        let Instruction::Compute { result, .. } = *instruction else {
            continue;
        };
        if groups.inlined(result).is_some() {
            continue;
        }
        let facts = program.value(result);
        let subject = (facts.scope, facts.purpose);
        match runs.last_mut() {
            Some((last, _, length)) if *last == subject => *length += 1,
            _ => runs.push((subject, result, 1)),
        }
    }
    runs
}

fn words((body, purpose): Subject, tree: &Tree) -> String {
    let body = tree.identifier(body);
    match purpose.words() {
        "" => body.to_owned(),
        words => format!("{body}: {words}"),
    }
}
