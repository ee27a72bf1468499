//! Where the entries of a packed or compact array stand: the names of constants that say so, and which columns belong to which variable.

use super::syntax::{list, object, string};
use crate::{
    functions::{Declared, Length},
    listing::{Facts, PackedEntries},
};

/// Members of an argument; none of one that is whole.
pub(super) fn members(facts: &Facts, argument: &Declared) -> Vec<(&'static str, String)> {
    let is_of = |constant: &str| {
        let mut lengths = argument.lengths.iter();
        lengths.any(|length| matches!(length, Length::Constant(own) if own == constant))
    };
    let mut packed = facts.packed.iter().map(|(packed, _)| packed);
    if let Some(packed) = packed.find(|packed| is_of(packed.length_constant())) {
        return vec![("places", string(packed.places_constant()))];
    }
    let mut patterns = facts.patterns.iter();
    if let Some(pattern) = patterns.find(|pattern| is_of(&pattern.columns)) {
        return vec![("blocks", string(&pattern.blocks))];
    }
    let mut speeds = facts.frame_speeds.iter();
    if let Some(speeds) = speeds.find(|speeds| is_of(&speeds.length)) {
        return vec![("columns_of", string(&speeds.constant))];
    }
    let mut entries = facts.entries.iter();
    let entries = entries.find(|entries| is_of(&entries.length));
    entries.map_or_else(Vec::new, of_derivative)
}

fn of_derivative(entries: &PackedEntries) -> Vec<(&'static str, String)> {
    let mut first = 0;
    let columns = entries.columns.iter().map(|(name, length)| {
        let members = [
            ("by", string(name)),
            ("first", first.to_string()),
            ("length", length.to_string()),
        ];
        first += length;
        object(&members)
    });
    let mut members = vec![
        ("rows", entries.n_rows.to_string()),
        ("columns", list(columns)),
        ("places", string(&entries.constant)),
    ];
    let colors = entries.colors.as_ref();
    members.extend(colors.map(|colors| ("colors", string(&colors.constant))));
    members
}
