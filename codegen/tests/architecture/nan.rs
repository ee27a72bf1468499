//! Comparisons in tests that pass over what is not a number.

use proc_macro2::TokenStream;

use crate::walk::Sources;

/// Functions that give the other number in the place of NaN.
const PASSING: [&str; 2] = ["max", "min"];

/// The files of tests that name one, a line each.
pub(crate) fn passed_over(sources: &Sources) -> Vec<String> {
    let mut found = Vec::new();
    for (file, text) in &sources.0 {
        let tokens: TokenStream = text.parse().unwrap_or_else(|e| panic!("{file}: {e}"));
        let tokens = tokens.to_string();
        let mut names = PASSING.iter();
        if let Some(name) = names.find(|name| tokens.contains(&format!("f64 :: {name}"))) {
            found.push(format!("{file}: `f64::{name}`"));
        }
    }
    found
}

/// The same where sources are programs, and tests stand beside them.
pub(crate) fn passed_over_beside_programs(sources: &Sources) -> Vec<String> {
    let found = passed_over(sources).into_iter();
    found.filter(|line| !line.contains("/src/")).collect()
}
