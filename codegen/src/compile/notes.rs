//! A function by the notes' equations as they stand.
//!
//! In: a function, as it is by the recursion. Out: its [`Planned`], if it costs no more, and to find that out does not take long.

use crate::{
    functions::{Derived, Formulation, Request},
    program::Operations,
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::{
    planned::{Planned, cost, emitted, operations},
    plans::Plans,
    sweeps,
};

/// From how many nodes on the notes' values are long: their derivatives would take more time than all the rest.
const LONG: usize = 20_000;

/// Up to how many nodes they are short: second derivatives of others would.
const SHORT: usize = 1_000;

/// Notes of more terms are derived only where the recursion needs more operations than that: of fewer, some may be zero.
const MANY_TERMS: usize = 1_000;

/// Up to how many operations of the recursion both are compared as they are written: [`passes::reuse`](crate::passes::reuse) takes
/// longer, and of long functions a small part.
const MOST_WRITTEN: usize = 1_000;

/// How many times the recursion's cost the notes may have before `reuse`, which saves more in the notes but hardly ever half of them.
const MOST_REUSED: usize = 2;

/// The function by the notes, if it costs no more than by the recursion.
pub(super) fn instead_of(
    plans: &Plans<'_>,
    request: &Request,
    recursive: &Derived,
) -> Option<Planned> {
    let before = operations(recursive);
    if !have_a_chance(plans.tree, request, before) {
        return None;
    }
    let notes = at_most(plans, request, most(request, before))?;
    let both = [&notes.derived, recursive];
    let written = || both.map(|derived| emitted(plans.tree, request, derived, plans.without));
    are_cheaper(request, both, written).then_some(notes)
}

/// True where [`instead_of`] gives the notes, beside this recursion. `written` are the operations of both as they are [`emitted`].
pub(crate) fn cost_no_more(
    tree: &Tree,
    request: &Request,
    [notes, recursive]: [&Derived; 2],
    written: [Operations; 2],
) -> bool {
    have_a_chance(tree, request, operations(recursive))
        && are_cheaper(request, [notes, recursive], || written)
}

/// What the notes may cost as they are derived, beside a recursion that needs these operations.
fn most(request: &Request, recursive: Operations) -> usize {
    let own = cost(request, recursive);
    if recursive.total() <= MOST_WRITTEN {
        MOST_REUSED * own
    } else {
        own
    }
}

/// True where the notes cost no more: as they are written, if they are short.
fn are_cheaper(
    request: &Request,
    both: [&Derived; 2],
    written: impl FnOnce() -> [Operations; 2],
) -> bool {
    let [of_notes, of_recursion] = both.map(operations);
    let cost_no_more_as_derived = cost(request, of_notes) <= cost(request, of_recursion);
    if of_recursion.total() > MOST_WRITTEN || cost(request, of_notes) > most(request, of_recursion)
    {
        return cost_no_more_as_derived;
    }
    let [of_notes, of_recursion] = written().map(|operations| cost(request, operations));
    // What happens to be the same as something else, such as two numbers, makes no formulation a better one.
    of_notes < of_recursion || of_notes == of_recursion && cost_no_more_as_derived
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
