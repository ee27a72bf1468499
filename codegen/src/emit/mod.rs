//! From programs to source: the only place that builds syntax, prints numbers and makes identifiers.
//!
//! In: a tree, its programs, where they come from. Out: the text of one Rust module. Afterwards: the text holds no inner
//! attribute and names only `kane`, `core` and itself, so it compiles as a file, in a module and through `include!`,
//! in editions 2021 and 2024; no `unsafe`, no indexing by a variable, no loop, no branch. What is `unsafe` for callers in C
//! stands in a text of its own (`interface`).
//! Does not: decide what is computed, or in what order.

mod expression;
mod function;
mod interface;
mod items;
mod self_test;
mod signature;
mod sin_cos;
mod statements;
mod syntax;
mod tables;

pub(crate) use interface::{RULES, SCALARS, source as interface};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{File, Item};

pub use self_test::{Sample, Sampled, self_tests};

pub use crate::compile::Emittable;

use crate::{
    functions::{Request, Signature},
    origin::Origin,
    program::{Operations, Program},
    threads,
    tree::Tree,
};

/// A module ready to be emitted.
#[derive(Clone, Debug)]
pub struct Module<'a> {
    /// The checked tree.
    pub tree: &'a Tree,
    /// Where it comes from.
    pub origin: Origin,
    /// What depends on parameters alone: one store for each of `fields`.
    pub preparation: Program,
    /// The fields of `Prepared`.
    pub fields: Vec<String>,
    /// The functions, in order.
    pub functions: Vec<Emittable>,
}

impl Module<'_> {
    /// The operations of everything that states them, in the order of the module.
    pub fn costs(&self) -> Vec<(String, Operations)> {
        let mut costs = vec![("Prepared::new".to_owned(), self.preparation.operations())];
        if self.any(Request::is_at_sin_cos) {
            costs.push(("sin_cos".to_owned(), sin_cos::operations(self.tree)));
        }
        let functions = self.functions.iter();
        costs.extend(functions.map(|one| (one.function.name(), one.operations)));
        costs
    }

    /// True where some function is so.
    pub(crate) fn any(&self, is: fn(&Request) -> bool) -> bool {
        let mut functions = self.functions.iter();
        functions.any(|emittable| is(&emittable.function))
    }

    /// What callers see who have no types of Rust: the functions, and what they need before.
    pub(crate) fn signatures(&self) -> Vec<Signature> {
        let mut signatures = vec![Signature::nominal(), Signature::prepare()];
        signatures.extend(self.any(Request::is_at_sin_cos).then(Signature::sin_cos));
        let functions = self.functions.iter();
        signatures.extend(functions.map(|emittable| emittable.function.signature()));
        signatures
    }
}

/// The text of a module.
pub fn source(module: &Module<'_>) -> String {
    let mut text = module.origin.banner();
    let fields = &module.fields;
    let mut items = items::constants(module.tree);
    items.extend(items::identity(module));
    items.extend(items::parameters(module.tree));
    items.extend(items::prepared(module, fields));
    items.push(items::system(module.tree));
    if module.any(Request::is_at_sin_cos) {
        items.extend(sin_cos::items(module.tree));
    }
    if module.any(Request::is_packed) {
        items.extend(items::packed(module.tree));
    }
    text.push_str(&printed(items));
    let functions = threads::map(&module.functions, |emittable| {
        printed(function::items(module, emittable))
    });
    text + &functions.concat()
}

/// Items as prettyplease prints them, each after an empty line.
fn printed(items: Vec<Item>) -> String {
    let mut text = String::new();
    for item in items {
        text.push('\n');
        text.push_str(&prettyplease::unparse(&File {
            shebang: None,
            frontmatter: None,
            attrs: Vec::new(),
            items: vec![item],
        }));
    }
    text
}

/// An identifier. Names come from the tree's identifiers, which are valid, and from our own words.
fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// Documentation, a line each.
fn doc<S: AsRef<str>>(lines: impl IntoIterator<Item = S>) -> TokenStream {
    let lines = lines.into_iter().map(|line| {
        let line = line.as_ref();
        if line.is_empty() {
            String::new()
        } else {
            format!(" {line}")
        }
    });
    quote!(#(#[doc = #lines])*)
}

/// What items allow, and why: a module holds more than one program calls.
fn allow_unused() -> TokenStream {
    quote!(#[allow(dead_code, reason = "a program calls what it needs")])
}

/// What code allows, and why: arguments follow one pattern, whether used or not, and numbers are the model's.
fn allow_generated() -> TokenStream {
    quote! {
        #[allow(
            dead_code,
            unused_variables,
            clippy::approx_constant,
            clippy::many_single_char_names,
            clippy::needless_late_init,
            clippy::too_many_arguments,
            reason = "generated: arguments follow one pattern, numbers are the model's"
        )]
    }
}
