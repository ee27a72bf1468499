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
        .map(|&formulation| {
            let choice = compile::of_formulation(plans, function, formulation);
            let written = compile::emitted(plans.tree, function, &choice.derived, plans.without);
            (choice, written)
        })
        .collect();
    let written = derived.iter();
    let written = written.map(|(choice, written)| (choice.formulation, *written));
    Counts {
        function: function.clone(),
        formulations: written.collect(),
        cheapest: cheapest(plans.tree, function, &derived),
        refused,
    }
}

/// The formulation that [`compile::choose`] takes.
fn cheapest(
    tree: &Tree,
    function: &Request,
    choices: &[(Choice, Operations)],
) -> Option<Formulation> {
    // In the order of `Formulation`.
    let cheapest = match choices {
        [(notes, of_notes), (recursive, of_recursion)] => {
            let both = [&notes.derived, &recursive.derived];
            let written = [*of_notes, *of_recursion];
            if compile::notes_cost_no_more(tree, function, both, written) {
                notes
            } else {
                recursive
            }
        }
        _ => &choices.first()?.0,
    };
    Some(cheapest.formulation)
}
