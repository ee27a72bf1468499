//! The formulation in which a function is emitted.
//!
//! In: a tree, a function, options. Out: a [`Choice`]. Afterwards: it is the formulation that was asked for, where the
//! function has it, or the one with fewer operations; of equals the notes'.

use std::collections::BTreeSet;

use crate::{
    functions::{Derived, Formulation, Request},
    options::{self, Options},
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::{
    candidate::{candidate, operations},
    search,
};

/// A function in one formulation.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The formulation.
    pub formulation: Formulation,
    /// The expressions that are emitted.
    pub derived: Derived,
}

/// The function in the formulation that is wanted, where it has it: what is emitted.
pub fn choose(tree: &Tree, function: &Request, options: &Options) -> Choice {
    let has_choice = function.formulations().len() > 1;
    let notes = || of_formulation(tree, function, Formulation::Notes, &options.without);
    if !has_choice || options.formulation == options::Formulation::Notes {
        return notes();
    }
    let recursive = of_formulation(tree, function, Formulation::Recursive, &options.without);
    // On a large tree the literal sums alone would take longer than all the rest.
    let count = operations(&recursive.derived).total();
    let is_wanted = options.formulation == options::Formulation::Recursive;
    if is_wanted || count < function.literal_terms(tree) {
        return recursive;
    }
    let notes = notes();
    if operations(&notes.derived).total() <= count {
        notes
    } else {
        recursive
    }
}

/// The function in this formulation, by its cheapest plan without some techniques.
pub fn of_formulation(
    tree: &Tree,
    function: &Request,
    formulation: Formulation,
    without: &BTreeSet<Technique>,
) -> Choice {
    let plan = match formulation {
        Formulation::Notes => {
            Plan::plain(tree).with(Technique::Factor, !without.contains(&Technique::Factor))
        }
        Formulation::Recursive => search::cheapest(tree, function, without),
    };
    Choice {
        formulation,
        derived: candidate(tree, function, formulation, &plan),
    }
}
