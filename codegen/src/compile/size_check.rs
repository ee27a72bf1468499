//! How large a module would be, told before its functions are derived. To know how large second derivatives are, what they differentiate is
//! derived.
//!
//! In: a tree, functions, options. Out: an error where deriving or writing them would take more time or memory than
//! [`crate::limits`] allow.

use std::collections::BTreeSet;

use crate::{
    error::Error,
    functions::{Argument, Dimension, Packed, Request},
    limits,
    options::{Formulation, Options, companion::CompanionKind},
    recursive::Technique,
    tree::{N_INERTIAL, Tree},
};

/// How many terms of a mass matrix take the memory of one of forces.
const FORCES_WEIGHT: usize = 8;

/// How many times as much as the values products with derivatives are.
const PRODUCT: usize = 4;

/// Refuses what would be too large.
///
/// # Errors
/// [`Error::TooLarge`], for the first limit that is passed.
pub fn check(tree: &Tree, requests: &[Request], options: &Options) -> Result<(), Error> {
    bound("the system has", tree.n_speeds, "speeds", limits::SPEEDS)?;
    bound("the bodies have", tree.n_parts(), "parts", limits::PARTS)?;
    let n_numbers = |request: &Request| request.n_numbers(tree);
    bound_sum("write", requests, n_numbers, "numbers", limits::NUMBERS)?;
    for request in requests {
        check_derivation(tree, request, options)?;
    }
    check_companions(tree, requests, &options.companions)
}

/// Refuses files beside the module for which too much would be evaluated.
fn check_companions(
    tree: &Tree,
    requests: &[Request],
    companions: &BTreeSet<CompanionKind>,
) -> Result<(), Error> {
    let evaluated = companions.iter().flat_map(|kind| kind.evaluated(requests));
    let evaluated: Vec<Request> = evaluated.collect();
    let terms = |request: &Request| {
        let is_of_forces = request.arguments().contains(&Argument::U) && !request.solves();
        request.literal_terms(tree) * if is_of_forces { FORCES_WEIGHT } else { 1 }
    };
    let verb = "have for the tests";
    bound_sum(verb, &evaluated, terms, "terms", limits::EVALUATED_TERMS)
}

/// Refuses a function whose derivation alone would be too large.
fn check_derivation(tree: &Tree, request: &Request, options: &Options) -> Result<(), Error> {
    let name = request.text();
    if request.differentiates() {
        // It is derived whole, however few numbers come of it.
        let (values, what) = (
            request.values(),
            format!("what `{name}` differentiates has"),
        );
        bound(&what, values.n_numbers(tree), "numbers", limits::NUMBERS)?;
        let n_solved = values.n_solved(tree);
        bound(&what, n_solved, "numbers of solutions", limits::SOLVED)?;
    }
    if options.formulation == Formulation::Notes {
        let is_product = request.arguments().into_iter().any(Argument::is_of_product);
        let slopes = if is_product { PRODUCT } else { 1 };
        bound(
            &format!("the notes' sums for `{name}` have"),
            request.literal_terms(tree),
            "terms",
            limits::TERMS / slopes,
        )?;
    }
    bound(
        &format!("`{name}` writes"),
        request.n_differentiated(tree),
        "numbers of derivatives",
        limits::DIFFERENTIATED,
    )?;
    check_second(tree, request, options)?;
    check_whole(tree, request)?;
    bound(
        &format!("`{name}` writes"),
        request.n_solved(tree),
        "numbers of solutions",
        limits::SOLVED,
    )?;
    let is_factorised = options.formulation == Formulation::Notes
        || options.without.contains(&Technique::Articulated)
        || !Technique::Articulated.is_possible(tree);
    if request.factorises() || request.solves() && is_factorised {
        let updates = request.factorising(tree);
        bound(
            &format!("factorising for `{name}` takes"),
            updates,
            "updates",
            limits::UPDATES,
        )?;
    }
    Ok(())
}

/// Refuses what comes of a matrix that would be too large, however few of its numbers are written.
fn check_whole(tree: &Tree, request: &Request) -> Result<(), Error> {
    let n_regressor = tree.n_speeds * N_INERTIAL * tree.bodies.len();
    let wholes = [
        (
            Dimension::BaseParameters,
            "regressor",
            n_regressor,
            limits::BASE_REGRESSOR,
        ),
        (
            Dimension::Packed(Packed::Regressor),
            "regressor",
            n_regressor,
            limits::REGRESSOR,
        ),
        (
            Dimension::Packed(Packed::Inverse),
            "inverse",
            tree.n_speeds.pow(2),
            limits::INVERSE,
        ),
    ];
    let derived = wholes
        .into_iter()
        .filter(|(dimension, ..)| request.writes(*dimension));
    for (_, whole, found, most) in derived {
        let what = format!("the {whole} for `{}` has", request.text());
        bound(&what, found, "numbers", most)?;
    }
    Ok(())
}

/// Refuses second derivatives of which too much would be built.
fn check_second(tree: &Tree, request: &Request, options: &Options) -> Result<(), Error> {
    let n_variables = request.n_second(tree);
    if n_variables == 0 {
        return Ok(());
    }
    let is_direct = options.formulation != Formulation::Notes
        && !options.without.contains(&Technique::DirectDerivatives);
    let name = request.text();
    let found = request.n_second_operations(tree, is_direct);
    if found <= limits::SECOND {
        return Ok(());
    }
    Err(Error::TooLarge {
        what: match n_variables {
            1 => format!("`{name}`, by one variable, builds about"),
            _ => format!("`{name}`, by {n_variables} variables, builds about"),
        },
        found,
        unit: "operations",
        most: limits::SECOND,
        advice: Some(if n_variables > 1 {
            "ask for fewer variables, or for `vjp` and its differences"
        } else {
            "ask for `vjp` and its differences"
        }),
    })
}

/// Refuses what functions have together.
fn bound_sum(
    verb: &str,
    requests: &[Request],
    size: impl Fn(&Request) -> usize,
    unit: &'static str,
    most: usize,
) -> Result<(), Error> {
    let largest = requests.iter().max_by_key(|request| size(request));
    let largest = largest.map_or_else(String::new, Request::text);
    let what = format!("the functions, `{largest}` most of all, {verb}");
    bound(&what, requests.iter().map(size).sum(), unit, most)
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
        advice: None,
    })
}
