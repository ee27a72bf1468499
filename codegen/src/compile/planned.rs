//! A function in one formulation by one plan, as it would be emitted, and what that costs.
//!
//! In: a function, a formulation, a plan. Out: its expressions after the passes that see one function alone, and their
//! operations in the loop. Does not: choose.

use super::branches;
use crate::{
    functions::{Derived, Formulation, Request},
    passes::{factor, hoist, hoist::Preparation, sines},
    program::{Operations, Program},
    recursive::{Plan, Technique},
    tree::Tree,
};

/// How many nodes may be built to compare candidates whatever they promise: a tenth of a second's work.
pub(super) const MOST_NODES: usize = 400_000;

/// A plan, and the function by it, as it would be emitted.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The plan.
    pub plan: Plan,
    /// The function's expressions.
    pub derived: Derived,
}

impl Planned {
    /// The function in this formulation by this plan.
    pub(super) fn new(
        tree: &Tree,
        function: &Request,
        formulation: Formulation,
        plan: Plan,
    ) -> Self {
        let derived = by_plan(tree, function, formulation, &plan);
        Self { plan, derived }
    }
}

/// The function in this formulation by this plan, as it would be emitted: its sums factored, and sines and cosines inputs
/// where they are to be given.
pub fn by_plan(tree: &Tree, function: &Request, formulation: Formulation, plan: &Plan) -> Derived {
    let derived = function.derive(tree, formulation, plan);
    finished(tree, function, plan, derived)
}

/// What was derived by a plan, as it would be emitted.
pub(super) fn finished(
    tree: &Tree,
    function: &Request,
    plan: &Plan,
    mut derived: Derived,
) -> Derived {
    // The pattern of a compact output follows from the tree: nothing to factor across columns.
    if plan.uses(Technique::Factor) && function.compact().is_none() {
        (derived.graph, derived.roots) = factor::run(derived.graph, derived.roots);
    }
    given_sines(tree, function, derived)
}

/// A function with sines and cosines as inputs where they are to be given.
pub(super) fn given_sines(tree: &Tree, function: &Request, mut derived: Derived) -> Derived {
    if function.is_at_sin_cos() {
        let angles = sines::angles(tree);
        (derived.graph, derived.roots) = sines::run(&derived.graph, &derived.roots, &angles);
    }
    derived
}

/// The operations that are left in the loop.
pub fn operations(derived: &Derived) -> Operations {
    Operations::of(&derived.graph, &derived.roots)
}

/// Its program, where nothing else is in the module: what branches and columns go through alike is written once.
pub(super) fn program(tree: &Tree, function: &Request, derived: &Derived) -> Program {
    let mut preparation = Preparation::default();
    let (graph, roots) = hoist::run(&derived.graph, &derived.roots, "", &mut preparation);
    branches::flattened(tree, &function.arguments(), &graph, &roots)
}
