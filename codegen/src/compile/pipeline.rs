//! The order of the passes.
//!
//! In: a function as it was derived. Out: its expressions after the passes that see one function alone, whose operations are
//! compared; then its program, with what depends on parameters alone taken out.

use std::collections::BTreeSet;

use super::branches;
use crate::{
    functions::{Arrangement, Derived, Request},
    passes::{angles, factor, hoist, hoist::Preparation, reuse, sines},
    program::{self, Program},
    recursive::Technique,
    tree::Tree,
};

/// What was derived by these plans, as it would be emitted.
pub(super) fn finished(
    tree: &Tree,
    request: &Request,
    arrangement: &Arrangement,
    mut derived: Derived,
) -> Derived {
    // The pattern of a compact output follows from the tree: nothing to factor across columns.
    if arrangement.uses(Technique::Factor) && request.compact().is_none() {
        (derived.graph, derived.roots) = factor::run(derived.graph, derived.roots);
    }
    with_sines(tree, request, derived)
}

/// A function with sines and cosines as inputs where they are to be given, and with one of each an angle where it is joined of several.
pub(super) fn with_sines(tree: &Tree, request: &Request, mut derived: Derived) -> Derived {
    if request.is_at_sin_cos() {
        let angles = tree.angles();
        (derived.graph, derived.roots) = sines::run(&derived.graph, &derived.roots, &angles);
    } else if request.parts().len() > 1 {
        (derived.graph, derived.roots) = angles::run(derived.graph, derived.roots);
    }
    derived
}

/// How a program is written.
#[derive(Clone, Copy)]
pub(super) struct Lowering {
    /// What branches go through alike is written once.
    pub(super) side_by_side: bool,
    /// Values are made of others that are there.
    pub(super) reuses: bool,
    /// Products and sums are fused.
    pub(super) fuses: bool,
}

impl Lowering {
    /// Where nothing else is said, but for what takes long and changes little.
    pub(super) const DRAFT: Self = Self {
        side_by_side: true,
        reuses: false,
        fuses: false,
    };

    /// Without some techniques.
    pub(super) fn without(without: &BTreeSet<Technique>) -> Self {
        Self {
            side_by_side: !without.contains(&Technique::Lockstep),
            reuses: !without.contains(&Technique::Reuse),
            fuses: false,
        }
    }
}

/// The program of a function that is finished; what depends on parameters alone goes to the preparation. `None` where numbers overflow.
pub(super) fn program(
    tree: &Tree,
    request: &Request,
    derived: &Derived,
    preparation: &mut Preparation,
    lowering: Lowering,
) -> Option<Program> {
    let Derived { graph, roots, .. } = derived;
    let name = request.name();
    let (hoisted, roots) = hoist::run(graph, roots, &name, preparation);
    if graph.overflowed() || hoisted.overflowed() {
        return None;
    }
    let (mut graph, mut roots) = (hoisted, roots);
    if lowering.side_by_side {
        (graph, roots) = branches::arranged(tree, &request.arguments(), graph, roots);
    }
    if lowering.reuses {
        (graph, roots) = reuse::run(tree, graph, roots);
    }
    let program = program::flatten(&graph, &roots);
    Some(if lowering.fuses {
        program::fuse(program)
    } else {
        program
    })
}
