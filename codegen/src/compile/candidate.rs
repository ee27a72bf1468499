//! A function in one formulation by one plan, as it would be emitted, and what that costs.
//!
//! In: a function, a formulation, a plan. Out: its expressions after the passes that see one function alone, and their
//! operations in the loop. Does not: choose.

use super::branches;
use crate::{
    expr::{Expr, ExprGraph},
    functions::{Derived, Formulation, Request},
    passes::{factor, hoist, hoist::Preparation, sines},
    program::{self, Operations, Program},
    recursive::{Plan, Technique},
    tree::Tree,
};

/// How many nodes may be built to compare candidates whatever they promise: a tenth of a second's work.
pub(super) const MOST_NODES: usize = 400_000;

/// The function in this formulation by this plan, as it would be emitted: its sums factored, and sines and cosines inputs
/// where they are to be given.
pub fn candidate(
    tree: &Tree,
    function: &Request,
    formulation: Formulation,
    plan: &Plan,
) -> Derived {
    let mut derived = function.derive(tree, formulation, plan);
    if plan.uses(Technique::Factor) {
        derived = factored(function, derived);
    }
    given_sines(tree, function, derived)
}

/// A function with its sums factored.
fn factored(function: &Request, derived: Derived) -> Derived {
    let (graph, roots) = if function.compact().is_some() {
        // The pattern of a compact output follows from the tree: nothing to factor across columns.
        (derived.graph, derived.roots)
    } else {
        factor::run(&derived.graph, &derived.roots)
    };
    Derived {
        graph,
        roots,
        blocks: derived.blocks,
    }
}

/// A function with sines and cosines as inputs where they are to be given.
pub(super) fn given_sines(tree: &Tree, function: &Request, derived: Derived) -> Derived {
    if !function.is_at_sin_cos() {
        return derived;
    }
    let (graph, roots) = sines::run(&derived.graph, &derived.roots, &sines::angles(tree));
    Derived {
        graph,
        roots,
        blocks: derived.blocks,
    }
}

/// The operations that are left in the loop.
pub fn operations(derived: &Derived) -> Operations {
    in_loop(derived).operations()
}

/// As many of them as are written down: what several columns or branches go through alike once.
pub(super) fn text(tree: &Tree, function: &Request, derived: &Derived) -> usize {
    let (graph, roots) = hoisted(derived);
    branches::flattened(tree, &function.arguments(), &graph, &roots).written()
}

fn in_loop(derived: &Derived) -> Program {
    let (graph, roots) = hoisted(derived);
    program::flatten(&graph, &roots)
}

fn hoisted(derived: &Derived) -> (ExprGraph, Vec<Expr>) {
    let mut preparation = Preparation::default();
    hoist::run(&derived.graph, &derived.roots, "", &mut preparation)
}
