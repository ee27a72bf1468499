//! The module's constants, as members of a manifest.

use super::syntax::{list, number, object, string, strings};
use crate::{
    functions::{CompactBlock, PARAMETER_NAMES},
    listing::{
        BaseTerm, Constant, Data, Facts,
        constants::{BODY_NAMES, COORDINATE_NAMES, FRAMES, JOINTS, SPEED_NAMES},
    },
};

/// What has a key of its own.
const ELSEWHERE: [&str; 6] = [
    BODY_NAMES,
    COORDINATE_NAMES,
    SPEED_NAMES,
    JOINTS,
    FRAMES,
    PARAMETER_NAMES,
];

/// An object with a constant a line.
pub(super) fn member(facts: &Facts) -> String {
    let constants = facts.all_constants();
    let constants = constants.iter();
    let lines = constants.filter(|constant| !ELSEWHERE.contains(&constant.name));
    let lines: Vec<String> = lines.filter_map(line).collect();
    format!("{{\n{}\n  }}", lines.join(",\n"))
}

/// What a constant holds; nothing of a size, which is the length of a list, nor of what has a key of its own.
fn line(constant: &Constant<'_>) -> Option<String> {
    let value = match &constant.data {
        Data::Texts(_, texts) => strings(texts),
        Data::Integers(_, numbers) => list(numbers),
        Data::Numbers(_, numbers) => list(numbers.iter().copied().map(number)),
        Data::Places(_, places) => list(places.iter().map(list)),
        Data::Terms(terms) => list(terms.iter().map(term)),
        Data::Blocks(blocks) => list(blocks.iter().map(block)),
        Data::Size(_)
        | Data::Hash(_)
        | Data::Text(_)
        | Data::Truths(..)
        | Data::Costs(_)
        | Data::Joints(..)
        | Data::Frames(_) => return None,
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

fn block(block: &CompactBlock) -> String {
    object(&[
        ("body", block.body.to_string()),
        ("partition", block.partition.to_string()),
        ("speed", block.speed.to_string()),
        ("columns", block.columns.to_string()),
        ("first", block.first.to_string()),
    ])
}
