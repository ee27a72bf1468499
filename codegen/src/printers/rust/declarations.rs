//! Which locals are declared together. This is for rustc: other compilers open no scope at a declaration.

use std::collections::BTreeMap;

use crate::listing::{Code, LocalId, Statement};

/// The most `let`s in a function. Debug information opens a scope at each of them, inside that of the one before, and the
/// compiler's stack ends after two or three thousand. In longer functions the next values of a body are declared together.
const MOST_LETS: usize = 1_800;

/// Of how many bodies how many values are declared together, from longer to longer functions.
const TOGETHER: [(usize, usize); 4] = [(1, 8), (1, 64), (16, 64), (256, 256)];

/// Where the locals of a function are declared: each where it is assigned, or several by the first of them.
pub(super) struct Declarations(Option<BTreeMap<LocalId, Vec<LocalId>>>);

impl Declarations {
    pub(super) fn of(code: &Code) -> Self {
        // Arrays have `let`s of their own, two of them one.
        let most = MOST_LETS.saturating_sub(code.arrays.len() / 2);
        let assigned: Vec<LocalId> = code
            .statements
            .iter()
            .flat_map(Statement::assigned)
            .collect();
        if assigned.len() <= most {
            return Self(None);
        }
        let together = TOGETHER.map(|(bodies, locals)| chunks(code, &assigned, bodies, locals));
        let [.., last] = &together;
        let fewest = together.iter().find(|chunks| chunks.len() <= most);
        let chunks = fewest.unwrap_or(last).iter();
        let first = |chunk: &Vec<LocalId>| (chunk[0], chunk.clone());
        Self(Some(chunks.map(first).collect()))
    }

    /// True where declarations stand apart from assignments.
    pub(super) fn are_apart(&self) -> bool {
        self.0.is_some()
    }

    /// What is declared before this local is assigned.
    pub(super) fn at(&self, local: LocalId) -> Option<&[LocalId]> {
        self.0.as_ref()?.get(&local).map(Vec::as_slice)
    }
}

/// The locals of so many bodies, so many together, in order.
fn chunks(code: &Code, assigned: &[LocalId], bodies: usize, together: usize) -> Vec<Vec<LocalId>> {
    let mut groups: BTreeMap<Option<usize>, Vec<LocalId>> = BTreeMap::new();
    for &id in assigned {
        let group = code.local(id).body.map(|body| body.index() / bodies);
        groups.entry(group).or_default().push(id);
    }
    let chunks = groups.values().flat_map(|ids| ids.chunks(together));
    chunks.map(<[LocalId]>::to_vec).collect()
}
