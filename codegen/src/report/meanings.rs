//! Places of two texts of a module that have one name and mean something else: code that uses them goes on and is wrong.
//!
//! In: two texts. Out: each such place with what it means before and after. What one text alone says is left out.

use std::collections::BTreeMap;

use syn::{Expr, File};

use super::{
    constants::{constant, entries, list, string},
    meaning::Meaning,
    outline::coordinates,
    places::Places,
};
use crate::{functions::PRESCRIBED, listing::constants, rust};

/// Compares the units of coordinates, which speeds are prescribed, and which entries arrays have that leave some out.
///
/// # Errors
/// A text that is not Rust.
pub fn meanings(old: &str, new: &str) -> Result<Vec<Meaning>, syn::Error> {
    let read = |text| rust::read(text, |file| (said(&file), Places::of(&file)));
    let ((old, old_places), (new, new_places)) = (read(old)?, read(new)?);
    let old: BTreeMap<String, Said> = old.into_iter().collect();
    let changed = new.into_iter().filter_map(|(name, new)| {
        let old = old.get(&name)?;
        // Places that moved, under names that stay, are told as such.
        let is_other = old.meaning != new.meaning && old.shown != new.shown;
        is_other.then(|| Meaning {
            name,
            old: old.shown.clone(),
            new: new.shown,
        })
    });
    let places = old_places.changed(&new_places);
    Ok(changed.chain(places).collect())
}

/// What a module says of a place: what it means whatever names are, and that for people.
#[derive(Clone)]
struct Said {
    meaning: String,
    shown: String,
}

/// What a module says, place by place.
fn said(file: &File) -> Vec<(String, Said)> {
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
    let mut said: Vec<(String, Said)> = units.collect();
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
