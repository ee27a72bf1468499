//! Which entries of the mass matrix are zero.

use crate::{
    compile,
    functions::{Formulation, Request},
    recursive::Plan,
    tree::Tree,
};

/// A row for each speed and in it an entry for each speed: false where the entry is zero for every state and is not computed.
pub fn mass_matrix_pattern(tree: &Tree) -> Vec<Vec<bool>> {
    let request = Request::parse("mass_matrix").expect("report: the catalogue has it");
    let plan = Plan::full(tree).with_parallel(None, false);
    let derived = compile::by_plan(tree, &request, Formulation::Recursive, &plan);
    let entries = derived.roots.iter();
    let entries: Vec<bool> = entries
        .map(|&entry| !derived.graph.is_zero(entry))
        .collect();
    let rows = entries.chunks(tree.n_speeds.max(1));
    rows.map(<[bool]>::to_vec).collect()
}
