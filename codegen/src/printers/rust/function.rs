//! One function: documentation, signature, statements, and the trait that holds it.

use quote::quote;
use syn::{Item, ItemFn, parse_quote};

use super::{
    constants,
    expression::Writer,
    frames, signature, statements,
    text::{allow_generated, doc, ident},
};
use crate::{
    functions::{self, Shape},
    listing::{Facts, Function},
};

/// What callers may wonder at.
const FENCES: &str =
    "A `compiler_fence` is no instruction: it keeps runs of zeros from becoming calls of `memset`.";

/// The items of one function, in order: its pattern, itself, its trait.
pub(super) fn items(facts: &Facts, function: &Function) -> Vec<Item> {
    let pattern = function.pattern.map(|place| &facts.patterns[place]);
    let mut items = pattern.map_or_else(Vec::new, |pattern| {
        constants::items(&facts.pattern_constants(pattern))
    });
    items.push(item(facts, function));
    let in_trait = function
        .alone
        .and_then(|alone| Some((alone, alone.trait_name?)));
    items.extend(in_trait.map(|(alone, name)| trait_impl(function, alone, name)));
    let of_frame = function.of_frame.as_ref();
    items.extend(of_frame.and_then(|(of, subject)| frames::trait_impl(function, of, subject)));
    items
}

/// The function itself.
pub(super) fn item(facts: &Facts, function: &Function) -> Item {
    let signature = &function.signature;
    let mut lines = signature.doc.clone();
    lines.push(String::new());
    lines.extend(function.cost());
    lines.extend(function.code.has_fences().then(|| FENCES.to_owned()));
    let (doc, allow) = (doc(lines), allow_generated());
    let name = ident(&signature.name);
    let arguments = signature.arguments.iter().map(signature::declared);
    let mut item: ItemFn = parse_quote! {
        #doc
        #allow
        #[inline(never)]
        pub fn #name<R: kane::Real>(#(#arguments),*) {}
    };
    item.block.stmts = statements::of(&Writer::new(facts, function));
    Item::Fn(item)
}

/// The runtime crate's trait for the function.
fn trait_impl(function: &Function, alone: &functions::Function, trait_name: &str) -> Item {
    let (trait_name, method) = (ident(trait_name), ident(alone.name));
    // The first one is `self`.
    let arguments = function.signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let output_type = arguments.clone().next_back();
    let output_type = output_type.map(|output| signature::held(output, "R"));
    let arguments = arguments.map(signature::declared);
    let associated = match alone.outputs[0].shape {
        Shape::SPEED_MATRIX => quote!(type Matrix = #output_type;),
        Shape::SPEED_PAIRS => quote! {
            type Entries = #output_type;
            const PLACES: &'static [[usize; 2]] = MASS_MATRIX_PACKED_PLACES;
        },
        Shape::COLUMNS => {
            let columns = ident(&format!(
                "{}Columns",
                alone.trait_name.expect("compact functions have traits")
            ));
            let blocks = ident(&alone.blocks_constant());
            quote! {
                type #columns = #output_type;
                const #blocks: &'static [kane::Block] = &#blocks;
            }
        }
        _ => quote!(),
    };
    parse_quote! {
        impl<R: kane::Real> kane::functions::#trait_name<R> for Prepared<R> {
            #associated
            #[inline]
            fn #method(&self, #(#arguments),*) {
                self::#method(self, #(#names),*);
            }
        }
    }
}
