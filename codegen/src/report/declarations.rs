//! Functions of two texts of a module that are gone or take other arguments: code that calls them must change, or means something else.
//!
//! In: two modules. Out: each such function with its arguments before and after. What the new one alone holds is left out.

use std::collections::BTreeMap;

use quote::ToTokens as _;
use syn::{File, FnArg, Item, Pat, Visibility};

/// A function of the old module that is gone, or has other arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Redeclared {
    /// The function's name.
    pub name: String,
    /// Its arguments in the old module: names, or names and types where these alone differ.
    pub old: String,
    /// Those in the new module; `None` where it is gone.
    pub new: Option<String>,
}

/// Compares how the public functions of two modules are declared.
pub(super) fn redeclared(old: &[Declared], new: &[Declared]) -> Vec<Redeclared> {
    let new: BTreeMap<&String, &Arguments> = new.iter().map(|(name, own)| (name, own)).collect();
    let changed = old.iter().filter_map(|(name, old)| {
        let new = new.get(name).copied();
        if new == Some(old) {
            return None;
        }
        let is_by_name = new.is_none_or(|new| names(old) != names(new));
        let shown = if is_by_name { names } else { whole };
        Some(Redeclared {
            name: name.clone(),
            old: shown(old),
            new: new.map(shown),
        })
    });
    changed.collect()
}

/// A function's name and arguments.
pub(super) type Declared = (String, Arguments);

/// The name and type of each argument.
pub(super) type Arguments = Vec<[String; 2]>;

fn names(arguments: &Arguments) -> String {
    let names: Vec<&str> = arguments.iter().map(|[name, _]| name.as_str()).collect();
    names.join(", ")
}

fn whole(arguments: &Arguments) -> String {
    let whole = arguments.iter().map(|[name, of]| format!("{name}: {of}"));
    whole.collect::<Vec<_>>().join(", ")
}

/// The public functions of a module.
pub(super) fn declared(file: &File) -> Vec<Declared> {
    let functions = file.items.iter().filter_map(|item| match item {
        Item::Fn(function) if matches!(function.vis, Visibility::Public(_)) => Some(&function.sig),
        _ => None,
    });
    let arguments = functions.map(|signature| {
        let arguments = signature
            .inputs
            .iter()
            .filter_map(|argument| match argument {
                FnArg::Typed(typed) => match &*typed.pat {
                    Pat::Ident(name) => Some([
                        name.ident.to_string(),
                        typed.ty.to_token_stream().to_string(),
                    ]),
                    _ => None,
                },
                FnArg::Receiver(_) => None,
            });
        (signature.ident.to_string(), arguments.collect())
    });
    arguments.collect()
}
