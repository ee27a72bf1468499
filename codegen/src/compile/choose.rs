//! The formulation in which a function is emitted.
//!
//! In: a function, a formulation or none. Out: a [`Choice`]. Afterwards: it is the formulation that was asked for, where the
//! function has it, or the one that costs less; of equals the notes'.

use crate::{
    functions::{Derived, Formulation, Request},
    options,
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::{
    cheapest::cheapest,
    planned::{cost, operations},
    plans::Plans,
    sweeps,
};

/// From how many nodes on the notes' values are long: their derivatives would take more time than all the rest.
const LONG: usize = 20_000;

/// Notes of fewer terms are always derived: they may cost less than one operation a term, where some are zero.
const MANY_TERMS: usize = 1_000;

/// A function in one formulation.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The formulation.
    pub formulation: Formulation,
    /// The expressions that are emitted.
    pub derived: Derived,
}

/// The function in the formulation that is wanted, where it has it, else in that which costs least: what is emitted.
pub fn choose(plans: &Plans<'_>, request: &Request, wanted: options::Formulation) -> Choice {
    let formulations = request.formulations();
    let of = |formulation| of_formulation(plans, request, formulation);
    let wanted = wanted
        .wanted()
        .filter(|wanted| formulations.contains(wanted));
    if let Some(only) = wanted.or((formulations.len() == 1).then(|| formulations[0])) {
        return of(only);
    }
    let recursive = of(Formulation::Recursive);
    let count = operations(&recursive.derived).total();
    let terms = request.literal_terms(plans.tree);
    // On a large tree the literal sums alone would take longer than all the rest, and so would second derivatives of them.
    if terms > MANY_TERMS.max(count)
        || request.is_second_derivative()
        || request.differentiates() && values_cost_more(plans.tree, request, count)
    {
        return recursive;
    }
    let cost = cost(request, operations(&recursive.derived));
    of_at_most(plans, request, Formulation::Notes, cost).unwrap_or(recursive)
}

/// True where the notes' values are long, and need more operations alone than this: their derivatives hardly ever need fewer.
fn values_cost_more(tree: &Tree, request: &Request, count: usize) -> bool {
    let values = request.values();
    let values = values.derive(tree, Formulation::Notes, &Plan::plain(tree));
    values.graph.len() > LONG && operations(&values).total() > count
}

/// The function in this formulation, by its cheapest plan.
pub fn of_formulation(plans: &Plans<'_>, request: &Request, formulation: Formulation) -> Choice {
    let choice = of_at_most(plans, request, formulation, usize::MAX);
    choice.expect("choose: some plan is the cheapest")
}

/// The same; `None` where it costs more than `most`.
fn of_at_most(
    plans: &Plans<'_>,
    request: &Request,
    formulation: Formulation,
    most: usize,
) -> Option<Choice> {
    let &Plans { tree, without, .. } = plans;
    let best = if request.takes_plan(formulation) {
        let best = cheapest(plans, request);
        (cost(request, operations(&best.derived)) <= most).then_some(best)
    } else {
        let plan = Plan::plain(tree).with(Technique::Factor, !without.contains(&Technique::Factor));
        let ways = if request.differentiates() {
            sweeps::ways(tree, request, formulation, without, &plan)
        } else {
            vec![plan]
        };
        let ways = ways.iter().map(|plan| request.arranged_by(tree, plan));
        let ways = ways.collect();
        sweeps::fewest(tree, request, formulation, ways, most)
    };
    best.map(|best| Choice {
        formulation,
        derived: best.derived,
    })
}
