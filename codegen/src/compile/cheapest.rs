//! The cheapest plan of any function: that of its values, and the cheapest way to differentiate these.
//!
//! In: the plans of values, a function. Out: a [`Planned`], parts of which may be by the notes. Columns of what is long go in lockstep.

use crate::{
    functions::{Arrangement, Formulation, Request},
    passes::hoist::Preparation,
    recursive::{Plan, Technique},
};

use super::{
    arranged, notes,
    pipeline::{self, Lowering},
    planned::{MOST_NODES, Planned, operations},
    plans::Plans,
    sweeps,
};

/// The operations of a function whose machine code fits into a processor's first cache, of 32 kB. Beyond, time goes by bytes of code.
const MOST_CACHED: usize = 3_500;

/// The function by the cheapest plan of each part that was found; parts of a joined one may be by the notes.
pub fn cheapest(plans: &Plans<'_>, request: &Request) -> Planned {
    cheapest_by(plans, request, true)
}

/// The same with no part by the notes that can be by the recursion.
pub(super) fn cheapest_recursion(plans: &Plans<'_>, request: &Request) -> Planned {
    cheapest_by(plans, request, false)
}

/// The cheapest; parts of a joined one may be by the notes where it `may_mix`.
fn cheapest_by(plans: &Plans<'_>, request: &Request, may_mix: bool) -> Planned {
    let best = one_by_one(plans, request, may_mix);
    if request.has_columns(&best.arrangement) {
        in_lockstep(plans, request, best)
    } else {
        best
    }
}

/// The same with no columns in lockstep.
fn one_by_one(plans: &Plans<'_>, request: &Request, may_mix: bool) -> Planned {
    let together = by_one_plan(plans, request);
    if request.parts().len() == 1 {
        return together;
    }
    let own = || {
        let alone = request.alone();
        Arrangement::concat(
            alone
                .iter()
                .map(|part| cheapest_alone(plans, part, may_mix)),
        )
    };
    arranged::cheapest(plans.tree, request, together, own)
}

/// The cheapest way to derive a single part.
fn cheapest_alone(plans: &Plans<'_>, part: &Request, may_mix: bool) -> Arrangement {
    let has_choice = may_mix && part.formulations().len() > 1;
    if !has_choice && !part.differentiates() {
        return part.arranged_by(plans.tree, &plans.of_values(part));
    }
    let recursive = by_one_plan(plans, part);
    let notes = has_choice.then(|| notes::instead_of(plans, part, &recursive.derived));
    notes.flatten().unwrap_or(recursive).arrangement
}

/// The function by the cheapest plan for all its parts.
///
/// What is differentiated is planned by its values, and then by the cheaper way to differentiate them.
fn by_one_plan(plans: &Plans<'_>, request: &Request) -> Planned {
    let &Plans { tree, without, .. } = plans;
    if !request.differentiates() {
        let arrangement = request.arranged_by(tree, &plans.of_values(request));
        return Planned::new(tree, request, arrangement);
    }
    let forward = plans
        .of_values(&request.values())
        .with(Technique::DirectDerivatives, false)
        .with(Technique::Reverse, false);
    let sweeps = |plan: &Plan| sweeps::ways(tree, request, Formulation::Recursive, without, plan);
    let mut ways = Vec::new();
    let rates = Technique::Rates;
    if request.heeds(rates) && !without.contains(&rates) {
        // Rates that are dearer may change more cheaply.
        ways.extend(sweeps(&forward.with(rates, !forward.uses(rates))));
    }
    ways.extend(sweeps(&forward));
    if !without.contains(&Technique::DirectDerivatives) && request.differentiates_directly() {
        let alike = request.alike();
        let alike: Vec<Plan> = alike.iter().map(|own| plans.of_values(own)).collect();
        let swept = if request.sweeps_beside_direct() {
            ways.clone()
        } else {
            vec![forward.clone()]
        };
        if request.differentiates_accelerations_twice()
            && request.n_second_operations(tree, false) > MOST_NODES
        {
            // Sweeps through the solver would take long, and are cheaper for small systems at most.
            ways.clear();
        }
        for way in swept {
            let is_reverse = way.uses(Technique::Reverse);
            let alike = alike.iter();
            let alike = alike.map(|plan| plan.with(Technique::Reverse, is_reverse));
            let plans = std::iter::once(way).chain(alike);
            ways.extend(plans.map(|plan| plan.with(Technique::DirectDerivatives, true)));
        }
    }
    let ways = ways.iter().map(|plan| request.arranged_by(tree, plan));
    let best = sweeps::fewest(tree, request, ways.collect(), usize::MAX);
    best.expect("cheapest: one way has the least")
}

/// The plan with columns in lockstep where a long function is a good deal shorter with it and is run in fewer steps, or as it is.
fn in_lockstep(plans: &Plans<'_>, request: &Request, one_by_one: Planned) -> Planned {
    let &Plans { tree, without, .. } = plans;
    if without.contains(&Technique::Lockstep) {
        return one_by_one;
    }
    let least = operations(&one_by_one.derived).total();
    if least <= MOST_CACHED {
        return one_by_one;
    }
    // As if nothing else was in the module.
    let program = |planned: &Planned| {
        let (derived, mut preparation) = (&planned.derived, Preparation::default());
        pipeline::program(tree, request, derived, &mut preparation, Lowering::DRAFT)
    };
    let with = |arrangement| {
        let planned = Planned::new(tree, request, arrangement);
        // A tenth more operations at most, which are counted first, and a fifth less text.
        if 10 * operations(&planned.derived).total() > 11 * least {
            return None;
        }
        let program = program(&planned)?;
        let is_short = 5 * program.written() <= 4 * least;
        is_short.then(|| (program.steps(), planned))
    };
    let lockstep = |plan: &Plan| plan.with(Technique::Lockstep, true);
    let lockstep = one_by_one.arrangement.with_plans(lockstep);
    let twice = request.differentiates_accelerations();
    let twice = twice.then(|| lockstep.with_plans(|plan| plan.with_calls_twice(true)));
    let others = [Some(lockstep), twice].into_iter().flatten();
    let others: Vec<(usize, Planned)> = others.filter_map(with).collect();
    if others.is_empty() {
        return one_by_one;
    }
    let Some(as_it_is) = program(&one_by_one) else {
        return one_by_one;
    };
    let all = std::iter::once((as_it_is.steps(), one_by_one)).chain(others);
    let best = all.min_by_key(|(steps, _)| *steps);
    best.expect("cheapest: one is as it is").1
}
