//! What changed between two texts of a module: functions, and the operations that each states in its documentation.
//!
//! In: two modules. Out: a [`Comparison`]. Reads the line `Operations: 7 = 4 mul + 3 add + 0 div + 0 trig` and nothing
//! else, so it serves for modules of any age; a function without that line is left out, and so is one that users cannot call.

use std::collections::BTreeMap;

use syn::{Attribute, Expr, ExprLit, File, ImplItem, Item, Lit, Meta, Visibility};

use crate::listing::Counted;

/// A function that both modules hold, with other operations or in another formulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The function's name; `Prepared::new` for the preparation.
    pub name: String,
    /// What the old module states.
    pub old: Counted,
    /// What the new module states.
    pub new: Counted,
}

/// What changed, each list in the order of its module.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comparison {
    /// Functions that both hold and that differ.
    pub changed: Vec<Change>,
    /// Functions that only the new module holds.
    pub added: Vec<(String, Counted)>,
    /// Functions that only the old module holds.
    pub removed: Vec<(String, Counted)>,
}

/// Compares the functions of two modules.
pub(super) fn compare(old: &[(String, Counted)], new: &[(String, Counted)]) -> Comparison {
    let old_map: BTreeMap<_, _> = old.iter().map(|(name, own)| (name, own)).collect();
    let new_map: BTreeMap<_, _> = new.iter().map(|(name, own)| (name, own)).collect();
    let mut comparison = Comparison::default();
    for (name, new) in new {
        match old_map.get(name) {
            None => comparison.added.push((name.clone(), new.clone())),
            Some(&old) if old == new => {}
            Some(&old) => comparison.changed.push(Change {
                name: name.clone(),
                old: old.clone(),
                new: new.clone(),
            }),
        }
    }
    let removed = old.iter().filter(|(name, _)| !new_map.contains_key(name));
    comparison.removed = removed.cloned().collect();
    comparison
}

/// The functions of a module that state their operations, in its order.
pub(super) fn counted(file: &File) -> Vec<(String, Counted)> {
    let mut list = Vec::new();
    for item in &file.items {
        match item {
            Item::Fn(function) if matches!(function.vis, Visibility::Public(_)) => {
                let name = function.sig.ident.to_string();
                list.extend(stated(&function.attrs).map(|counted| (name, counted)));
            }
            Item::Impl(block) if block.trait_.is_none() => {
                for item in &block.items {
                    if let ImplItem::Fn(function) = item {
                        let name = format!("Prepared::{}", function.sig.ident);
                        list.extend(stated(&function.attrs).map(|counted| (name, counted)));
                    }
                }
            }
            _ => {}
        }
    }
    list
}

/// What the documentation states.
fn stated(attributes: &[Attribute]) -> Option<Counted> {
    attributes.iter().find_map(|attribute| {
        let Meta::NameValue(pair) = &attribute.meta else {
            return None;
        };
        match &pair.value {
            Expr::Lit(ExprLit {
                lit: Lit::Str(text),
                ..
            }) if pair.path.is_ident("doc") => Counted::read(&text.value()),
            _ => None,
        }
    })
}
