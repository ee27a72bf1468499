//! The operations of every function in every formulation that it has.

use std::{collections::BTreeSet, slice};

use crate::{
    compile::{self, Choice, Plans},
    functions::{Formulation, Request},
    options::{self, Options},
    program::Operations,
    recursive::Technique,
    threads,
    tree::Tree,
};

/// The operations of a function.
#[derive(Clone, Debug)]
pub struct Counts {
    /// The function.
    pub function: Request,
    /// Its formulations, each with the operations that it leaves in the loop, as it would be emitted.
    pub formulations: Vec<(Formulation, Operations)>,
    /// The one that costs least, which is what is generated where nothing else is asked for; `None` where the
    /// function would be too large in each of them.
    pub cheapest: Option<Formulation>,
    /// Why it is too large, where it is so in some formulation.
    pub refused: Option<String>,
}

/// Counts the operations of functions in those of their formulations in which they would not be too large.
pub fn count(tree: &Tree, functions: &[Request], without: &BTreeSet<Technique>) -> Vec<Counts> {
    let plans = Plans::new(tree, without);
    threads::map(functions, |function| of_one(&plans, function))
}

fn of_one(plans: &Plans<'_>, function: &Request) -> Counts {
    let is_choice = function.formulations().len() > 1;
    let mut refused = None;
    let derived: Vec<_> = function
        .formulations()
        .iter()
        .filter(|&&formulation| {
            let options = Options {
                formulation: match formulation {
                    Formulation::Notes if is_choice => options::Formulation::Notes,
                    _ => options::Formulation::Cheapest,
                },
                without: plans.without.clone(),
                ..Options::default()
            };
            let checked = compile::check_size(plans.tree, slice::from_ref(function), &options);
            let is_refused = checked.is_err();
            refused = checked
                .err()
                .map(|error| error.to_string())
                .or(refused.take());
            !is_refused
        })
        .map(|&formulation| compile::of_formulation(plans, function, formulation))
        .collect();
    let cheapest = cheapest(plans, function, &derived);
    let formulations = derived.iter().map(|choice| {
        let operations = compile::emitted(plans.tree, function, &choice.derived, plans.without);
        (choice.formulation, operations)
    });
    let formulations = formulations.collect();
    Counts {
        function: function.clone(),
        formulations,
        cheapest,
        refused,
    }
}

/// The formulation that [`compile::choose`] takes.
fn cheapest(plans: &Plans<'_>, function: &Request, choices: &[Choice]) -> Option<Formulation> {
    let of = |wanted| choices.iter().find(|choice| choice.formulation == wanted);
    match (of(Formulation::Notes), of(Formulation::Recursive)) {
        (Some(notes), Some(recursive)) => {
            let [notes, recursive] = [notes, recursive].map(|choice| &choice.derived);
            let is_notes = compile::notes_cost_no_more(plans, function, notes, recursive);
            Some(if is_notes {
                Formulation::Notes
            } else {
                Formulation::Recursive
            })
        }
        _ => choices.first().map(|choice| choice.formulation),
    }
}
