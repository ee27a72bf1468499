//! How large a module would be, told before any of its functions is derived.
//!
//! In: a tree, functions, options. Out: an error where deriving or writing them would take more time or memory than
//! [`crate::limits`] allow.

use std::collections::BTreeSet;

use crate::{
    companions::Kind, compile::Options, config::Formulation, error::Error, functions::Request,
    limits, recursive, recursive::Technique, solve, tree::Tree,
};

/// Refuses what would be too large.
///
/// # Errors
/// [`Error::TooLarge`], for the first limit that is passed.
pub fn check(tree: &Tree, requests: &[Request], options: &Options) -> Result<(), Error> {
    bound("the system has", tree.n_speeds, "speeds", limits::SPEEDS)?;
    bound("the bodies have", tree.n_parts(), "parts", limits::PARTS)?;
    let sizes: Vec<usize> = requests
        .iter()
        .map(|request| request.n_numbers(tree))
        .collect();
    let largest = sizes.iter().zip(requests).max_by_key(|(size, _)| **size);
    let largest = largest.map_or_else(String::new, |(_, request)| request.text());
    let what = format!("the functions, `{largest}` most of all, write");
    bound(&what, sizes.iter().sum(), "numbers", limits::NUMBERS)?;
    for request in requests {
        check_derivation(tree, request, options)?;
    }
    check_companions(tree, requests, &options.companions)
}

/// Refuses files beside the module for which too much would be evaluated.
fn check_companions(
    tree: &Tree,
    requests: &[Request],
    companions: &BTreeSet<Kind>,
) -> Result<(), Error> {
    for request in companions.iter().flat_map(|kind| kind.evaluated(requests)) {
        let what = format!("the tests evaluate `{}` with", request.text());
        let terms = request.literal_terms(tree);
        bound(&what, terms, "terms", limits::EVALUATED_TERMS)?;
    }
    Ok(())
}

/// Refuses a function whose derivation alone would be too large.
fn check_derivation(tree: &Tree, request: &Request, options: &Options) -> Result<(), Error> {
    let terms = request.literal_terms(tree);
    let name = request.text();
    if options.formulation == Formulation::Notes {
        bound(
            &format!("the notes' sums for `{name}` have"),
            terms,
            "terms",
            limits::TERMS,
        )?;
    }
    let is_factorised = options.formulation == Formulation::Notes
        || options.without.contains(&Technique::Articulated)
        || recursive::has_followers(tree);
    if request.solves() && is_factorised {
        let updates = solve::operations(tree);
        bound(
            &format!("factorising for `{name}` takes"),
            updates,
            "updates",
            limits::EVALUATED_TERMS,
        )?;
    }
    Ok(())
}

fn bound(what: &str, found: usize, unit: &'static str, most: usize) -> Result<(), Error> {
    if found <= most {
        return Ok(());
    }
    let what = what.to_owned();
    Err(Error::TooLarge {
        what,
        found,
        unit,
        most,
    })
}
