//! One function: documentation, signature, statements, and the trait that holds it.

use std::iter;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Item, ItemFn, parse_quote};

use super::{
    constants, derivatives,
    expression::Writer,
    frames, lockstep, signature, stages, statements,
    text::{allow_generated, doc, ident},
};
use crate::{
    functions::{self as catalogue, Declared, ELIMINATION, PRESCRIBED, Part, Shape},
    listing::{
        Facts, Function,
        constants::{BASE_PARAMETER_TERMS, BASE_PARAMETERS},
    },
};

/// The items of one function, in order: its pattern, itself, its trait.
pub(super) fn items(facts: &Facts, function: &Function) -> impl Iterator<Item = Item> {
    let pattern = function.pattern.map(|place| &facts.patterns[place]);
    let pattern = pattern.map(|pattern| constants::items(&facts.pattern_constants(pattern)));
    let own = iter::once_with(move || item(facts, function));
    let part = function.catalogue_part.as_ref();
    let traits = part.and_then(|part| trait_impl(function, part));
    pattern
        .into_iter()
        .flatten()
        .chain(lockstep::items(facts, function))
        .chain(stages::items(facts, function))
        .chain(own)
        .chain(traits)
        .chain(derivatives::trait_impl(function))
}

/// The function itself.
pub(super) fn item(facts: &Facts, function: &Function) -> Item {
    let signature = &function.signature;
    let mut lines = signature.doc.clone();
    lines.push(String::new());
    lines.extend(function.cost());
    let (doc, allow) = (doc(lines), allow_generated());
    let name = ident(&signature.name);
    let arguments = signature.arguments.iter().map(signature::declared);
    let mut item: ItemFn = parse_quote! {
        #doc
        #allow
        #[inline(never)]
        pub fn #name<R: kane::Real>(#(#arguments),*) {}
    };
    item.block.stmts = lockstep::scratch(function);
    item.block.stmts.extend(match &function.stages[..] {
        [] => statements::of(&Writer::new(facts, function)),
        _ => stages::calls(function),
    });
    Item::Fn(item)
}

/// What the trait of a function leaves to the system: the types of its last output, and tables beside it.
fn associated(alone: &catalogue::Function, output: Option<&Declared>) -> TokenStream {
    let shape = alone.outputs[0].shape;
    let output_type = output.map(|output| signature::held(output, "R"));
    let row = || output.map(|output| signature::held(&output.row(), "R"));
    let packed = shape.packed().map(|packed| ident(packed.places_constant()));
    match shape {
        Shape::MASS_MATRIX_PACKED | Shape::INVERSE_PACKED | Shape::REGRESSOR_PACKED => quote! {
            type Entries = #output_type;
            const PLACES: &'static [[usize; 2]] = #packed;
        },
        Shape::FACTORS => {
            let order = ident(ELIMINATION);
            quote! {
                type Entries = #output_type;
                const PLACES: &'static [[usize; 2]] = #packed;
                const ORDER: &'static [usize] = &#order;
            }
        }
        Shape::SPEED_VECTORS => quote!(type Terms = #output_type;),
        Shape::INERTIAL_PARAMETERS => quote!(type Inertial = #output_type;),
        Shape::BASE_PARAMETERS => quote!(type Base = #output_type;),
        Shape::REGRESSOR => {
            let row = row();
            quote! {
                type Row = #row;
                type Rows = #output_type;
            }
        }
        Shape::BASE_REGRESSOR => {
            let (names, terms) = (ident(BASE_PARAMETERS), ident(BASE_PARAMETER_TERMS));
            let row = row();
            quote! {
                type Row = #row;
                type Rows = #output_type;
                const NAMES: &'static [&'static str] = &#names;
                const TERMS: &'static [kane::BaseTerm] = &#terms;
            }
        }
        Shape::COLUMNS => {
            let columns = format_ident!("{}Columns", alone.trait_name.unwrap_or_default());
            let blocks = ident(&alone.blocks_constant());
            quote! {
                type #columns = #output_type;
                const #blocks: &'static [kane::Block] = &#blocks;
            }
        }
        Shape::VECTOR_BY_FRAME_SPEEDS => {
            let row = match output {
                Some(output) => signature::held(&output.row(), "R"),
                None => quote!(),
            };
            quote!(type Columns = #row;)
        }
        Shape::FRAME_MATRIX | Shape::POINT_MATRIX => {
            let row = output.map(|output| signature::held(&output.row(), "R"));
            quote!(type Row = #row; type Rows = #output_type;)
        }
        _ => quote!(),
    }
}

/// The runtime crate's trait for a function of the catalogue.
fn trait_impl(function: &Function, part: &Part) -> Option<Item> {
    let alone = part.function;
    let (trait_name, method) = (ident(alone.trait_name?), ident(alone.name));
    let own = ident(&function.signature.name);
    let frame = part.subject.as_ref().map(frames::frame_type).into_iter();
    // The first one is `self`.
    let arguments = function.signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let output = arguments.clone().next_back();
    let arguments = arguments.map(signature::declared);
    let associated = associated(alone, output);
    let speeds = part.function.has_frame_speeds().then(|| {
        let speeds = ident(&part.speeds_constant());
        quote!(const SPEEDS: &'static [usize] = &#speeds;)
    });
    let prescribed = part.function.prescribes.then(|| {
        let prescribed = ident(PRESCRIBED);
        quote!(const #prescribed: &'static [bool] = &#prescribed;)
    });
    Some(parse_quote! {
        impl<R: kane::Real> kane::functions::#trait_name<R #(, #frame)*> for Prepared<R> {
            #associated
            #speeds
            #prescribed
            #[inline]
            fn #method(&self, #(#arguments),*) {
                self::#own(self, #(#names),*);
            }
        }
    })
}
