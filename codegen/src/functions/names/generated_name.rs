//! Names of generated functions, read back: for those who ask for what they know from a module.

use super::absent::NO_FRAMES;
use crate::functions::{
    argument::Argument,
    function::{Function, Of},
    parse::syntax::{AT_SIN_COS, Product},
    variable::PARAMETERS,
};

/// The request of which a name is that of the generated function, or nearly so: `d_forward_dynamics`, `mass_matrix_and_bias`.
pub(in crate::functions) fn request(name: &str) -> Option<String> {
    let (name, suffix) = match name.strip_suffix("_at_sin_cos") {
        Some(name) => (name, AT_SIN_COS),
        None => (name, ""),
    };
    let parts: Option<Vec<String>> = name.split("_and_").map(of_part).collect();
    parts.map(|parts| parts.join("+") + suffix)
}

fn of_part(name: &str) -> Option<String> {
    if Function::find(name).is_some() {
        return Some(name.to_owned());
    }
    if let Some((frame, function)) = of_frame(name) {
        let frame = Some(frame).filter(|frame| !NO_FRAMES.contains(frame));
        let frame = frame.unwrap_or("FRAME");
        return Some(format!("{function}({frame})"));
    }
    for suffix in ["_derivatives", "_derivative"] {
        if let Some((function, "")) = name.strip_suffix(suffix).and_then(split_function) {
            return derivative("d", function, "");
        }
    }
    let (kind, rest) = name.split_once('_')?;
    let (function, by) = split_function(rest)?;
    if Product::NAMED.iter().any(|(own, _)| *own == kind) {
        return derivative(kind, function, by);
    }
    match by.strip_suffix("_packed") {
        _ if kind != "d" => None,
        Some(by) => derivative("d", function, by).map(|whole| format!("packed({whole})")),
        None => derivative("d", function, by),
    }
}

/// The function with which a text begins, and what follows.
fn split_function(text: &str) -> Option<(&'static Function, &str)> {
    let functions = Function::all();
    let found = functions.filter_map(|own| Some((own, text.strip_prefix(own.name)?)));
    found.max_by_key(|(own, _)| own.name.len())
}

/// A request for derivatives by the variables of a generated name, or by all where it has none.
fn derivative(kind: &str, function: &Function, by: &str) -> Option<String> {
    let mut rest = by.strip_prefix("_d").unwrap_or(by);
    let mut variables: Vec<&str> = Vec::new();
    let known = function.variables().map(Argument::name);
    let known: Vec<&str> = known.chain([PARAMETERS]).collect();
    while let Some(text) = rest.strip_prefix('_') {
        let begins = |own: &&&str| {
            let rest = text.strip_prefix(**own);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let found = known.iter().filter(begins);
        let Some(found) = found.max_by_key(|own| own.len()) else {
            break;
        };
        variables.push(found);
        rest = &text[found.len()..];
    }
    if variables.is_empty() {
        variables.extend(&known[..known.len() - 1]);
    }
    if variables.is_empty() || function.is_compact() {
        return None;
    }
    let of = match function.of {
        Of::System => function.name.to_owned(),
        Of::Frame(_) | Of::Frames(_) => format!("{}(FRAME)", function.name),
    };
    let by = variables.join(", ");
    Some(match kind {
        "d" => format!("d({of})/d({by})"),
        kind => format!("{kind}({of}; {by})"),
    })
}

/// The frame and its function, of a name in which both stand as in generated code: `tool0_jacobian`.
fn of_frame(name: &str) -> Option<(&str, &'static str)> {
    let of_frames = Function::all().filter(|function| function.of != Of::System);
    let found = of_frames.filter_map(|function| {
        let frame = name.strip_suffix(function.name)?.strip_suffix('_')?;
        (!frame.is_empty()).then_some((frame, function.name))
    });
    found.max_by_key(|(_, function)| function.len())
}
