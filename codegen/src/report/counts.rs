//! The operations of every function in every formulation that it has.

use std::collections::BTreeSet;

use crate::{
    compile,
    functions::{Formulation, Request},
    program::Operations,
    recursive::Technique,
    tree::Tree,
};

/// The operations of a function.
#[derive(Clone, Debug)]
pub struct Counts {
    /// The function.
    pub function: Request,
    /// Its formulations, each with the operations that it leaves in the loop.
    pub formulations: Vec<(Formulation, Operations)>,
    /// The one with the fewest operations, which is what is generated where nothing else is asked for.
    pub cheapest: Formulation,
}

/// Counts the operations of one function.
pub fn count(tree: &Tree, function: Request, without: &BTreeSet<Technique>) -> Counts {
    let formulations: Vec<_> = function
        .formulations()
        .iter()
        .map(|&formulation| {
            let choice = compile::of_formulation(tree, &function, formulation, without);
            (formulation, compile::operations(&choice.derived))
        })
        .collect();
    // The first of equals, as `compile::choose` takes it.
    let (cheapest, _) = *formulations
        .iter()
        .min_by_key(|(_, operations)| operations.total())
        .expect("functions: every function has a formulation");
    Counts {
        function,
        formulations,
        cheapest,
    }
}
