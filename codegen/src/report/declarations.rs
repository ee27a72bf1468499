//! Functions of two texts of a module that are gone or take other arguments: code that calls them must change, or means something else.
//!
//! In: two texts. Out: each such function with its arguments before and after. What the new text alone holds is left out.

use std::collections::BTreeMap;

use quote::ToTokens as _;
use syn::{File, FnArg, Item, Pat, Visibility};

use crate::rust;

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
///
/// ```
/// use kane_codegen::report::redeclared;
///
/// let [old, new] = ["pub fn step(q: &[f64; 2], u: &[f64; 2]) {}", "pub fn step(u: &[f64; 2], q: &[f64; 2]) {}"];
/// let found = &redeclared(old, new).unwrap()[0];
/// assert_eq!((&*found.old, found.new.as_deref()), ("q, u", Some("u, q")));
/// assert_eq!(redeclared(old, "pub fn other() {}").unwrap()[0].new, None);
/// ```
///
/// # Errors
/// A text that is not Rust.
pub fn redeclared(old: &str, new: &str) -> Result<Vec<Redeclared>, syn::Error> {
    let old = rust::read(old, declared)?;
    let new: BTreeMap<String, Arguments> = rust::read(new, declared)?.into_iter().collect();
    let changed = old.into_iter().filter_map(|(name, old)| {
        let new = new.get(&name);
        if new.is_some_and(|new| *new == old) {
            return None;
        }
        let is_by_name = new.is_none_or(|new| names(&old) != names(new));
        let shown = if is_by_name { names } else { whole };
        Some(Redeclared {
            name,
            old: shown(&old),
            new: new.map(shown),
        })
    });
    Ok(changed.collect())
}

/// The name and type of each argument.
type Arguments = Vec<[String; 2]>;

fn names(arguments: &Arguments) -> String {
    let names: Vec<&str> = arguments.iter().map(|[name, _]| name.as_str()).collect();
    names.join(", ")
}

fn whole(arguments: &Arguments) -> String {
    let whole = arguments.iter().map(|[name, of]| format!("{name}: {of}"));
    whole.collect::<Vec<_>>().join(", ")
}

fn declared(file: File) -> Vec<(String, Arguments)> {
    let functions = file.items.into_iter().filter_map(|item| match item {
        Item::Fn(function) if matches!(function.vis, Visibility::Public(_)) => Some(function.sig),
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
