//! Arrays of numbers of two modules that hold something else: limits, friction, frames.
//!
//! In: two modules. Out: each such constant with its first entry that differs. What other comparisons tell is left out: names, places, bodies.

use std::{collections::BTreeMap, iter};

use quote::ToTokens as _;
use syn::{Expr, File, Item};

use super::{
    constants::{field, list, string},
    meaning::Meaning,
    places::{ENDINGS, text},
};
use crate::{
    functions::{PARAMETER_NAMES, PRESCRIBED},
    listing::constants::{
        BASE_PARAMETER_TERMS, BASE_PARAMETERS, BODY_NAMES, COORDINATE_NAMES, JOINTS, LOWER_BODIES,
        OPERATIONS, SPEED_NAMES,
    },
};

/// What others tell of.
const TOLD: [&str; 10] = [
    BASE_PARAMETERS,
    BASE_PARAMETER_TERMS,
    BODY_NAMES,
    COORDINATE_NAMES,
    JOINTS,
    LOWER_BODIES,
    OPERATIONS,
    PARAMETER_NAMES,
    PRESCRIBED,
    SPEED_NAMES,
];

/// Compares the arrays of two modules that have one length in both.
pub(super) fn held(old: &[Array], new: &[Array]) -> Vec<Meaning> {
    let old: BTreeMap<&String, &Vec<Part>> = old.iter().map(|(name, own)| (name, own)).collect();
    let both = new.iter().filter_map(|(name, new)| {
        let old = *old.get(name)?;
        // What has another name came or went, which is told.
        let are_same = iter::zip(old, new).all(|(old, new)| old.place == new.place);
        if old.len() != new.len() || !are_same {
            return None;
        }
        let mut others = iter::zip(old, new).filter(|(old, new)| old.text != new.text);
        let (old, new) = others.next()?;
        let rest = match others.count() {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        Some(Meaning {
            name: format!("{name}{}{rest}", new.place),
            old: old.text.clone(),
            new: new.text.clone(),
        })
    });
    both.collect()
}

/// An array's name, and what it holds.
pub(super) type Array = (String, Vec<Part>);

/// An entry of an array, or a field of one.
#[derive(Debug)]
pub(super) struct Part {
    /// Which it is: `[2]`, `[2].position of tool`.
    place: String,
    text: String,
}

/// The arrays that others do not tell of.
pub(super) fn arrays(file: &File) -> Vec<Array> {
    let constants = file.items.iter().filter_map(|item| match item {
        Item::Const(constant) => Some(constant.ident.to_string()),
        _ => None,
    });
    let is_told =
        |name: &str| TOLD.contains(&name) || ENDINGS.iter().any(|ending| name.ends_with(ending));
    let arrays = constants.filter(|name| !is_told(name));
    let arrays = arrays.map(|name| {
        let parts = list(file, &name).into_iter().enumerate();
        let parts = parts.flat_map(parts_of).collect();
        (name, parts)
    });
    arrays.collect()
}

fn parts_of((place, entry): (usize, &Expr)) -> Vec<Part> {
    let part = |place, value| Part {
        place,
        text: shown(value),
    };
    let Expr::Struct(fields) = entry else {
        return vec![part(format!("[{place}]"), entry)];
    };
    let name = field(entry, "name").and_then(string);
    let of = name.map_or_else(String::new, |name| format!(" of {name}"));
    let fields = fields.fields.iter().map(|field| {
        let member = field.member.to_token_stream();
        part(format!("[{place}].{member}{of}"), &field.expr)
    });
    fields.collect()
}

/// An expression without most of the spaces between its tokens.
fn shown(value: &Expr) -> String {
    let text = text(value).replace("- ", "-").replace(" ,", ",");
    let text = text.replace(" :: ", "::").replace(" (", "(");
    text.replace("[ ", "[").replace(" ]", "]")
}
