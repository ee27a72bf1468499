//! The formulation in which a function is emitted.
//!
//! In: a function, a formulation or none. Out: a [`Choice`]. Afterwards: it is the formulation that was asked for, where the
//! function has it, or the one that costs less; of equals the notes', where these [have a chance](notes::have_a_chance). If none was
//! asked for, parts of a joined function may have different ones, which counts as the recursion.

use crate::{
    functions::{Derived, Formulation, Request},
    options,
};

use super::{
    cheapest::{cheapest, cheapest_recursion},
    notes,
    planned::Planned,
    plans::Plans,
};

/// A function in one formulation.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The formulation.
    pub formulation: Formulation,
    /// The expressions that are emitted.
    pub derived: Derived,
}

impl Choice {
    fn new(formulation: Formulation, planned: Planned) -> Self {
        Self {
            formulation,
            derived: planned.derived,
        }
    }
}

/// The function in the formulation that is wanted, where it has it, else in that which costs least: what is emitted.
pub fn choose(plans: &Plans<'_>, request: &Request, wanted: options::Formulation) -> Choice {
    let formulations = request.formulations();
    let wanted = wanted
        .wanted()
        .filter(|wanted| formulations.contains(wanted));
    match wanted {
        Some(Formulation::Recursive) => {
            Choice::new(Formulation::Recursive, cheapest_recursion(plans, request))
        }
        Some(notes) => of_formulation(plans, request, notes),
        None if formulations.len() == 1 => of_formulation(plans, request, formulations[0]),
        None => {
            let recursive = cheapest(plans, request);
            match notes::instead_of(plans, request, &recursive.derived) {
                Some(notes) => Choice::new(Formulation::Notes, notes),
                None => Choice::new(Formulation::Recursive, recursive),
            }
        }
    }
}

/// The function as it is emitted where this formulation costs least: parts of one that counts as the recursion may be by the notes.
pub fn of_formulation(plans: &Plans<'_>, request: &Request, formulation: Formulation) -> Choice {
    let planned = match formulation {
        Formulation::Recursive => cheapest(plans, request),
        Formulation::Notes => {
            let notes = notes::at_most(plans, request, usize::MAX);
            notes.expect("choose: one way has the least")
        }
    };
    Choice::new(formulation, planned)
}
