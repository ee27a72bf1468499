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
            let is_named = paths.iter().any(|path| tokens.contains(path));
            if is_named || is_called(&tokens, name) || is_folded(&tokens, name) {
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
    arguments.map(str::trim).any(is_float)
}

/// True where it is a method in what folds floats: a fold that begins with one.
fn is_folded(tokens: &str, name: &str) -> bool {
    let call = format!(". {name} (");
    let folds = tokens.split(". fold (").skip(1);
    let mut parts = folds.filter_map(|rest| rest.split_once(','));
    parts.any(|(first, rest)| is_float(first.trim()) && inside(rest).contains(&call))
}

/// What stands before the bracket that closes the one around it.
fn inside(tokens: &str) -> &str {
    let mut n_open = 1_usize;
    let end = tokens.find(|mark| {
        match mark {
            '(' => n_open += 1,
            ')' => n_open -= 1,
            _ => {}
        }
        n_open == 0
    });
    &tokens[..end.unwrap_or(tokens.len())]
}

/// True for a number with a point or an exponent, and a constant of floats.
fn is_float(argument: &str) -> bool {
    let number = argument.trim_start_matches(['-', ' ']);
    let is_number = number.contains(['.', 'e']) && number.parse::<f64>().is_ok();
    is_number || number.starts_with("f32 ::") || number.starts_with("f64 ::")
}

/// The same where sources are programs, and tests stand beside them.
pub(crate) fn passed_over_beside_programs(sources: &Sources) -> Vec<String> {
    let found = passed_over(sources).into_iter();
    found.filter(|line| !line.contains("/src/")).collect()
}
