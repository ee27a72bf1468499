//! A function by the notes' equations as they stand.
//!
//! In: a function, what it costs by the recursion. Out: its [`Planned`], if it costs no more, and to find that out does not take long.

use crate::{
    functions::{Derived, Formulation, Request},
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

/// Notes of fewer terms are always derived: they may cost less than one operation a term, where some are zero.
const MANY_TERMS: usize = 1_000;

/// The function by the notes, if it costs no more than by the recursion.
pub(super) fn instead_of(
    plans: &Plans<'_>,
    request: &Request,
    recursive: &Derived,
) -> Option<Planned> {
    let operations = operations(recursive);
    let (count, terms) = (operations.total(), request.literal_terms(plans.tree));
    // On a large tree the literal sums alone would take longer than all the rest, and so would second derivatives of them.
    if terms > MANY_TERMS.max(count)
        || request.is_second_derivative()
        || request.differentiates() && values_cost_more(plans.tree, request, count)
    {
        return None;
    }
    at_most(plans, request, cost(request, operations))
}

/// True where the notes' values are long, and need more operations alone than this: their derivatives hardly ever need fewer.
fn values_cost_more(tree: &Tree, request: &Request, count: usize) -> bool {
    let values = request.values();
    let values = values.derive(tree, Formulation::Notes, &Plan::plain(tree));
    values.graph.len() > LONG && operations(&values).total() > count
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
