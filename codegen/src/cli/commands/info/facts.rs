//! What is shown of a model, and what the text and the JSON both say of it.

use kane_codegen::{
    functions::Formulation,
    id::BodyId,
    limits::PICTURED_BODIES,
    program::Operations,
    report::Counts,
    tree::{RigidPart, Tree},
};

/// What people are shown beside the tree.
pub(super) struct Shown {
    /// Which partitions are zero.
    pub(super) partitions: bool,
    /// Which entries of the mass matrix are not zero; none where it would be too large.
    pub(super) pattern: Vec<Vec<bool>>,
    /// True where the default set is counted because nothing else was asked for.
    pub(super) are_default: bool,
    /// False where the default set, or all functions, would take too long to count.
    pub(super) is_counted: bool,
    /// What was asked for then.
    pub(super) uncounted: Vec<String>,
}

/// True where there is room for the tree and its partitions.
pub(super) fn is_pictured(tree: &Tree) -> bool {
    tree.bodies.len() <= PICTURED_BODIES
}

/// True for a function of the default set.
pub(super) fn is_default(count: &Counts) -> bool {
    let part = count.function.catalogue_part();
    part.is_some_and(|part| part.function.is_default)
}

pub(super) fn operations(count: &Counts, formulation: Formulation) -> Option<Operations> {
    let found = count
        .formulations
        .iter()
        .find(|(known, _)| *known == formulation);
    found.map(|(_, operations)| *operations)
}

/// The entry of the body-connection array: 0 for the inertial frame.
pub(super) fn lower_number(tree: &Tree, body: BodyId) -> usize {
    tree.lower(body).map_or(0, |lower| lower.index() + 1)
}

pub(super) fn gravity(tree: &Tree) -> [f64; 3] {
    tree.gravity.map(|component| tree.nominal(component))
}

/// The share of a body's weight that is lifted, with all that is fixed to it; `None` where nothing is.
pub(super) fn lifted(tree: &Tree, body: BodyId) -> Option<f64> {
    let parts = &tree.body(body).parts;
    if tree.lifted == 0.0 && !parts.iter().any(RigidPart::is_lifted) {
        return None;
    }
    let lifted = |part: &RigidPart| tree.nominal(part.mass) * tree.nominal(part.lifted);
    let mass: f64 = parts.iter().map(|part| tree.nominal(part.mass)).sum();
    let own: f64 = parts.iter().map(lifted).sum();
    Some(tree.lifted + if mass == 0.0 { 0.0 } else { own / mass })
}
