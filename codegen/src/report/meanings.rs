//! Places of two texts of a module that have one name and mean something else: code that uses them goes on and is wrong.
//!
//! In: two modules. Out: each such place with what it means before and after. What one module alone says is left out.

use std::collections::BTreeMap;

use syn::{Expr, File};

use super::{
    constants::{constant, entries, list, string},
    meaning::Meaning,
    outline::coordinates,
};
use crate::{functions::PRESCRIBED, listing::constants};

/// Compares the units of coordinates, and which speeds are prescribed.
pub(super) fn meanings(old: &[Place], new: &[Place]) -> Vec<Meaning> {
    let old: BTreeMap<&String, &Said> = old.iter().map(|(name, said)| (name, said)).collect();
    let changed = new.iter().filter_map(|(name, new)| {
        let old = old.get(name)?;
        // Places that moved, under names that stay, are told as such.
        let is_other = old.meaning != new.meaning && old.shown != new.shown;
        is_other.then(|| Meaning {
            name: name.clone(),
            old: old.shown.clone(),
            new: new.shown.clone(),
        })
    });
    changed.collect()
}

/// A place's name, and what a module says of it.
pub(super) type Place = (String, Said);

/// What a module says of a place: what it means whatever names are, and that for people.
#[derive(Debug)]
pub(super) struct Said {
    meaning: String,
    shown: String,
}

/// What a module says, place by place.
pub(super) fn said(file: &File) -> Vec<Place> {
    let names = |name| -> Vec<String> {
        let names = list(file, name).into_iter();
        names.filter_map(string).collect()
    };
    let coordinate_names = names(constants::COORDINATE_NAMES);
    let joints = list(file, constants::JOINTS).into_iter();
    let units = joints.flat_map(coordinates).filter_map(|(place, kind)| {
        let name = coordinate_names.get(place)?;
        let unit = kind.unit().to_owned();
        let said = Said {
            meaning: unit.clone(),
            shown: unit,
        };
        Some((format!("q of {name}"), said))
    });
    let mut said: Vec<Place> = units.collect();
    let prescribed = constant(file, PRESCRIBED).map(entries);
    said.extend(prescribed.map(|flags| {
        let flags: Vec<bool> = flags.iter().map(|flag| is_true(flag)).collect();
        let speeds = names(constants::SPEED_NAMES).into_iter();
        let given = speeds.zip(&flags).filter(|(_, flag)| **flag);
        let given: Vec<String> = given.map(|(name, _)| name).collect();
        let given = if given.is_empty() {
            "none".to_owned()
        } else {
            given.join(", ")
        };
        let said = Said {
            meaning: format!("{flags:?}"),
            shown: given,
        };
        ("prescribed speeds".to_owned(), said)
    }));
    said
}

fn is_true(value: &Expr) -> bool {
    match value {
        Expr::Lit(literal) => matches!(&literal.lit, syn::Lit::Bool(own) if own.value),
        _ => false,
    }
}
