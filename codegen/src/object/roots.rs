//! The functions of a generated module about which something is promised.

use std::path::Path;

use syn::{Attribute, Generics, Item, Visibility};

use crate::rust;

use super::Error;

/// A function, to be compiled in one scalar.
#[derive(Debug)]
pub(super) struct Root {
    /// Its name in the module: `mass_matrix`, `Prepared::new`.
    pub(super) name: String,
    /// The type of which it is a method.
    owner: Option<Generic>,
    function: Generic,
}

/// A name with its number of type parameters, each of which is the scalar.
#[derive(Debug)]
struct Generic {
    name: String,
    scalars: usize,
}

impl Generic {
    fn new(name: String, generics: &Generics) -> Self {
        let scalars = generics.type_params().count();
        Self { name, scalars }
    }

    /// The name, and after `link` its type arguments.
    fn of(&self, scalar: &str, link: &str) -> String {
        let scalars = vec![scalar; self.scalars].join(", ");
        if scalars.is_empty() {
            self.name.clone()
        } else {
            format!("{}{link}<{scalars}>", self.name)
        }
    }
}

impl Root {
    /// As source text names it, below the module's path.
    pub(super) fn path(&self, module: &str, scalar: &str) -> String {
        let function = self.function.of(scalar, "::");
        match &self.owner {
            Some(owner) => format!("{module}::{}::{function}", owner.of(scalar, "::")),
            None => format!("{module}::{function}"),
        }
    }

    /// As symbols name it.
    pub(super) fn symbol(&self, module: &str, scalar: &str) -> String {
        let function = self.function.of(scalar, "::");
        match &self.owner {
            Some(owner) => format!("<{module}::{}>::{function}", owner.of(scalar, "")),
            None => format!("{module}::{function}"),
        }
    }
}

/// Every `pub fn` with `#[inline(never)]` of a module's text, in order.
pub(super) fn of(path: &Path, text: &str) -> Result<Vec<Root>, Error> {
    let roots = rust::read(text, |file| {
        file.items.iter().flat_map(of_item).collect::<Vec<_>>()
    });
    let roots = roots.map_err(|error| Error::Unreadable {
        path: path.to_owned(),
        message: error.to_string(),
    })?;
    if roots.is_empty() {
        return Err(Error::NoFunctions {
            path: path.to_owned(),
        });
    }
    Ok(roots)
}

fn of_item(item: &Item) -> Vec<Root> {
    match item {
        Item::Fn(function) if is_root(&function.vis, &function.attrs) => {
            let function = Generic::new(function.sig.ident.to_string(), &function.sig.generics);
            vec![Root {
                name: function.name.clone(),
                owner: None,
                function,
            }]
        }
        Item::Impl(block) if block.trait_.is_none() => {
            let syn::Type::Path(owner) = &*block.self_ty else {
                return Vec::new();
            };
            let owner = owner.path.segments.last();
            let Some(owner) = owner.map(|segment| segment.ident.to_string()) else {
                return Vec::new();
            };
            let functions = block.items.iter().filter_map(|item| match item {
                syn::ImplItem::Fn(function) if is_root(&function.vis, &function.attrs) => {
                    Some(&function.sig)
                }
                _ => None,
            });
            let root = |signature: &syn::Signature| Root {
                name: format!("{owner}::{}", signature.ident),
                owner: Some(Generic::new(owner.clone(), &block.generics)),
                function: Generic::new(signature.ident.to_string(), &signature.generics),
            };
            functions.map(root).collect()
        }
        _ => Vec::new(),
    }
}

fn is_root(visibility: &Visibility, attributes: &[Attribute]) -> bool {
    let is_never = |attribute: &Attribute| {
        attribute.path().is_ident("inline")
            && attribute
                .parse_args::<syn::Ident>()
                .is_ok_and(|argument| argument == "never")
    };
    matches!(visibility, Visibility::Public(_)) && attributes.iter().any(is_never)
}
