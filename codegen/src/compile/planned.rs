//! A function, each part in a formulation by a plan, as it would be emitted, and what that costs.
//!
//! In: a function, an arrangement. Out: its expressions after the passes that see one function alone, and their
//! operations in the loop. Does not: choose.

use std::collections::BTreeSet;

use super::pipeline::{self, Lowering};
use crate::{
    expr::SINE,
    functions::{Arrangement, Derived, Formulation, Request},
    passes::hoist::Preparation,
    program::Operations,
    recursive::{Plan, Technique},
    tree::Tree,
};

/// How many nodes may be built to compare candidates whatever they promise: a tenth of a second's work.
pub(super) const MOST_NODES: usize = 400_000;

/// What a sine costs in a function that is given sines: it is asked for where none are to be computed.
const SINE_OF_GIVEN: usize = 1_000_000;

/// A plan of each part, and the function by these, as it would be emitted.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The plan of each part.
    pub arrangement: Arrangement,
    /// The function's expressions.
    pub derived: Derived,
}

impl Planned {
    /// The function by this arrangement.
    pub(super) fn new(tree: &Tree, request: &Request, arrangement: Arrangement) -> Self {
        let derived = request.derive_arranged(tree, &arrangement);
        let derived = pipeline::finished(tree, request, &arrangement, derived);
        Self {
            arrangement,
            derived,
        }
    }
}

/// The function in this formulation by this plan, as it would be emitted: its sums factored, and sines and cosines inputs
/// where they are to be given.
pub fn by_plan(tree: &Tree, request: &Request, formulation: Formulation, plan: &Plan) -> Derived {
    let arrangement = request.arranged_by(tree, plan);
    let arrangement = arrangement.with_formulation(formulation);
    Planned::new(tree, request, arrangement).derived
}

/// The operations that are left in the loop.
pub fn operations(derived: &Derived) -> Operations {
    Operations::of(&derived.graph, &derived.roots)
}

/// The operations of a function as it is emitted; as it was derived where its numbers overflow.
pub fn emitted(
    tree: &Tree,
    request: &Request,
    derived: &Derived,
    without: &BTreeSet<Technique>,
) -> Operations {
    let lowering = Lowering::without(without);
    let mut preparation = Preparation::default();
    let program = pipeline::program(tree, request, derived, &mut preparation, lowering);
    program.map_or_else(|| operations(derived), |program| program.operations())
}

/// What it costs.
pub(super) fn cost_of(request: &Request, derived: &Derived) -> usize {
    cost(request, operations(derived))
}

/// What a function with these operations costs: plans, ways to sweep and formulations are compared by it.
pub fn cost(request: &Request, operations: Operations) -> usize {
    let sine = if request.is_at_sin_cos() {
        SINE_OF_GIVEN
    } else {
        SINE
    };
    operations.total() + (sine - 1) * operations.trig
}
