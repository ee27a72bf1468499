//! Arrays whose entries a model's tree and numbers decide: what is packed, the columns that are other than zero, base parameters.
//!
//! In: two modules. Out: each such array of both that has other entries, or has them in other places. Where a system has
//! other bodies or speeds that is told, and all of these arrays are others.

use std::collections::BTreeMap;

use quote::ToTokens as _;
use syn::{Expr, File, Item};

use super::{
    constants::{constant, entries, field, integer, list, string},
    meaning::Meaning,
};
use crate::{
    functions::{N_BODIES, N_SPEEDS},
    listing::constants::{BASE_PARAMETER_TERMS, BASE_PARAMETERS},
};

/// How the names of constants end that say which entries an array has.
pub(super) const ENDINGS: [&str; 4] = ["_PLACES", "_SPEEDS", "_ORDER", "_BLOCKS"];

/// What a module says of its arrays.
#[derive(Debug)]
pub(super) struct Places {
    /// The numbers of bodies and speeds.
    sizes: [Option<String>; 2],
    /// For each constant that says it, the entries of its array.
    arrays: BTreeMap<String, Vec<Entry>>,
}

/// The base parameters of a module.
#[derive(Debug)]
pub(super) struct Base {
    sums: Vec<String>,
    /// For each what it is made of, whatever names are.
    terms: Vec<Vec<String>>,
}

/// What an entry means whatever names are, and that for people.
#[derive(Debug)]
struct Entry {
    meaning: String,
    shown: String,
}

impl Places {
    pub(super) fn of(file: &File) -> Self {
        let size = |name| constant(file, name).map(text);
        let constants = file.items.iter().filter_map(|item| match item {
            Item::Const(constant) => Some((constant.ident.to_string(), &*constant.expr)),
            _ => None,
        });
        let decides = |name: &str| ENDINGS.iter().any(|ending| name.ends_with(ending));
        let arrays = constants.filter(|(name, _)| decides(name));
        let arrays = arrays.map(|(name, list)| {
            let list = match list {
                Expr::Reference(list) => &*list.expr,
                list => list,
            };
            let all = entries(list).into_iter().map(|entry| Entry {
                meaning: text(entry),
                shown: text(entry),
            });
            (name, all.collect())
        });
        let mut arrays: BTreeMap<String, Vec<Entry>> = arrays.collect();
        let base = base_parameters(file);
        arrays.extend((!base.is_empty()).then(|| (BASE_PARAMETERS.to_owned(), base)));
        Self {
            sizes: [size(N_BODIES), size(N_SPEEDS)],
            arrays,
        }
    }

    /// The arrays that have other entries in another module.
    pub(super) fn changed(&self, new: &Self) -> Vec<Meaning> {
        if self.sizes != new.sizes {
            return Vec::new();
        }
        let both = self.arrays.iter();
        let both = both.filter_map(|(name, old)| Some((name, old, new.arrays.get(name)?)));
        both.filter_map(|(name, old, new)| changed(name, old, new))
            .collect()
    }
}

impl Base {
    /// How those of another module differ: their number, or the first that is another sum; `None` where they do not, or one module has
    /// none.
    pub(super) fn changed(&self, new: &Self) -> Option<Meaning> {
        if self.sums.is_empty() || new.sums.is_empty() {
            return None;
        }
        changed(BASE_PARAMETERS, &self.entries(), &new.entries())
    }

    fn entries(&self) -> Vec<Entry> {
        let pairs = self.sums.iter().zip(&self.terms);
        let entries = pairs.map(|(shown, terms)| Entry {
            meaning: terms.join(" "),
            shown: shown.clone(),
        });
        entries.collect()
    }

    pub(super) fn of(file: &File) -> Self {
        let sums = list(file, BASE_PARAMETERS).into_iter();
        let sums: Vec<String> = sums.filter_map(string).collect();
        let mut terms = vec![Vec::new(); sums.len()];
        for term in list(file, BASE_PARAMETER_TERMS) {
            let base = field(term, "base").and_then(integer);
            let base = base.and_then(|base| usize::try_from(base).ok());
            if let Some(own) = base.and_then(|base| terms.get_mut(base)) {
                own.push(text(term));
            }
        }
        Self { sums, terms }
    }
}

/// Of each base parameter the first of its sum: how much others add is a number of the model.
fn base_parameters(file: &File) -> Vec<Entry> {
    let terms = list(file, BASE_PARAMETER_TERMS);
    let part = |term: &Expr, name| field(term, name).map(text);
    let sums = list(file, BASE_PARAMETERS).into_iter().enumerate();
    let entries = sums.filter_map(|(place, sum)| {
        let base = Some(place.to_string());
        let first = terms.iter().find(|term| part(term, "base") == base)?;
        let [body, parameter] = ["body", "parameter"].map(|name| part(first, name));
        let sum = string(sum)?;
        Some(Entry {
            meaning: format!("{body:?} {parameter:?}"),
            shown: sum.split(" + ").next().unwrap_or(&sum).to_owned(),
        })
    });
    entries.collect()
}

/// How an array's entries changed, the first of them; `None` where they did not.
fn changed(name: &str, old: &[Entry], new: &[Entry]) -> Option<Meaning> {
    if old.len() != new.len() {
        let [old, new] = [old, new].map(|list| match list.len() {
            1 => "1 entry".to_owned(),
            many => format!("{many} entries"),
        });
        let name = name.to_owned();
        return Some(Meaning { name, old, new });
    }
    let others = (0..old.len()).filter(|&place| old[place].meaning != new[place].meaning);
    let others: Vec<usize> = others.collect();
    let (&first, rest) = others.split_first()?;
    let rest = match rest.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    Some(Meaning {
        name: format!("{name}[{first}]{rest}"),
        old: old[first].shown.clone(),
        new: new[first].shown.clone(),
    })
}

pub(super) fn text(value: &Expr) -> String {
    value.to_token_stream().to_string()
}
