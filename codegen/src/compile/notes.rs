//! A function by the notes' equations as they stand.
//!
//! In: a function, what it costs by the recursion. Out: its [`Planned`], if it costs no more, and to find that out does not take long.

use crate::{
    functions::{Derived, Formulation, Request},
    program::Operations,
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::{
    planned::{Planned, cost, operations},
    plans::Plans,
    sweeps,
};

/// From how many nodes on the notes' values are long: their derivatives would take more time than all the rest.
const LONG: usize = 20_000;

/// Up to how many nodes they are short: second derivatives of others would.
const SHORT: usize = 1_000;

/// Notes of more terms are derived only where the recursion needs more operations than that: of fewer, some may be zero.
const MANY_TERMS: usize = 1_000;

/// The function by the notes, if it costs no more than by the recursion.
pub(super) fn instead_of(
    plans: &Plans<'_>,
    request: &Request,
    recursive: &Derived,
) -> Option<Planned> {
    let operations = operations(recursive);
    have_a_chance(plans.tree, request, operations)
        .then(|| at_most(plans, request, cost(request, operations)))
        .flatten()
}

/// True where [`instead_of`] gives the notes, which need these operations, beside a recursion that needs those.
pub(crate) fn cost_no_more(
    tree: &Tree,
    request: &Request,
    notes: Operations,
    recursive: Operations,
) -> bool {
    have_a_chance(tree, request, recursive) && cost(request, notes) <= cost(request, recursive)
}

/// True where the function is derived by the notes beside the recursion, which needs these operations: on a large tree the literal sums
/// alone would take longer than all the rest.
fn have_a_chance(tree: &Tree, request: &Request, recursive: Operations) -> bool {
    let (count, terms) = (recursive.total(), request.literal_terms(tree));
    terms <= MANY_TERMS.max(count)
        && !(request.differentiates() && derivatives_take_long(tree, request, count))
}

/// True where the notes' derivatives would take long: the second ones of values that are not short, and the first ones of long values
/// that need more operations alone than the derivatives by the recursion, for these hardly ever cost less.
fn derivatives_take_long(tree: &Tree, request: &Request, count: usize) -> bool {
    let values = request.values();
    let values = values.derive(tree, Formulation::Notes, &Plan::plain(tree));
    let n_nodes = values.graph.len();
    if request.is_second_derivative() {
        n_nodes > SHORT
    } else {
        n_nodes > LONG && operations(&values).total() > count
    }
}

/// The function by the notes; `None` where it costs more than `most`.
pub(super) fn at_most(plans: &Plans<'_>, request: &Request, most: usize) -> Option<Planned> {
    let &Plans { tree, without, .. } = plans;
    let notes = Formulation::Notes;
    let plan = Plan::plain(tree).with(Technique::Factor, !without.contains(&Technique::Factor));
    let ways = if request.differentiates() {
        sweeps::ways(tree, request, notes, without, &plan)
    } else {
        vec![plan]
    };
    let arranged = |plan| request.arranged_by(tree, plan).with_formulation(notes);
    let ways = ways.iter().map(arranged).collect();
    sweeps::fewest(tree, request, ways, most)
}
