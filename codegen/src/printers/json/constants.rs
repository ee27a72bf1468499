//! The constants that outputs need to be read, as members of a manifest.

use super::syntax::{list, number, object, string, strings};
use crate::listing::{BaseTerm, Constant, Data, Facts};

/// An object with a constant a line; none where no output needs one.
pub(super) fn member(facts: &Facts) -> Option<String> {
    let constants = facts.output_constants();
    let lines: Vec<String> = constants.iter().filter_map(line).collect();
    (!lines.is_empty()).then(|| format!("{{\n{}\n  }}", lines.join(",\n")))
}

/// What a constant holds; nothing of a size, which is the length of a list.
fn line(constant: &Constant<'_>) -> Option<String> {
    let value = match &constant.data {
        Data::Texts(_, texts) => strings(texts),
        Data::Integers(_, numbers) => list(numbers),
        Data::Places(_, places) => list(places.iter().map(list)),
        Data::Terms(terms) => list(terms.iter().map(term)),
        _ => return None,
    };
    Some(format!("    {}: {value}", string(constant.name)))
}

fn term(term: &BaseTerm) -> String {
    object(&[
        ("base", term.base.to_string()),
        ("body", term.body.to_string()),
        ("parameter", term.parameter.to_string()),
        ("factor", number(term.factor)),
    ])
}
