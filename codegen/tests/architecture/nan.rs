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
        for name in PASSING {
            let paths = ["f32", "f64"].map(|scalar| format!("{scalar} :: {name}"));
            if paths.iter().any(|path| tokens.contains(path)) || is_called(&tokens, name) {
                found.push(format!("{file}: `{name}` of floats"));
            }
        }
    }
    found
}

/// True where it is a method that is given a number with a point or an exponent.
fn is_called(tokens: &str, name: &str) -> bool {
    let call = format!(". {name} (");
    let calls = tokens.split(&call).skip(1);
    let arguments = calls.filter_map(|rest| rest.split([')', ',']).next());
    arguments.map(str::trim).any(|argument| {
        let number = argument.trim_start_matches(['-', ' ']);
        number.contains(['.', 'e']) && number.parse::<f64>().is_ok()
    })
}

/// The same where sources are programs, and tests stand beside them.
pub(crate) fn passed_over_beside_programs(sources: &Sources) -> Vec<String> {
    let found = passed_over(sources).into_iter();
    found.filter(|line| !line.contains("/src/")).collect()
}
