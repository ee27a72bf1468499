//! The stages of a long function, and the function that calls them.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Expr, FieldValue, Item, Member, Stmt, parse_quote};

use super::{
    expression::Writer,
    frames::type_name,
    signature, statements,
    text::{allow_generated, doc, ident},
};
use crate::{
    functions::Signature,
    listing::{Facts, Function, Stage},
};

/// Every stage as a function, of which nobody else knows, and what it returns.
pub(super) fn items(facts: &Facts, of: &Function) -> impl Iterator<Item = Item> {
    of.stages.iter().flat_map(move |stage| {
        let kept = (!stage.kept.is_empty()).then(|| structure(stage));
        kept.into_iter().chain([function(facts, of, stage)])
    })
}

/// The type of what a stage returns.
fn type_of(stage: &Stage) -> Ident {
    ident(&type_name(&stage.signature.name))
}

fn structure(stage: &Stage) -> Item {
    let (doc, name) = (
        doc([format!(
            "What `{}` returns for later stages.",
            stage.signature.name
        )]),
        type_of(stage),
    );
    let fields = stage.kept.iter().map(|kept| ident(&kept.name));
    parse_quote! {
        #doc
        #[allow(non_camel_case_types, reason = "digits are kept apart as in the functions' names")]
        struct #name<R> {
            #(#fields: R,)*
        }
    }
}

fn function(facts: &Facts, of: &Function, stage: &Stage) -> Item {
    let stages = &of.stages;
    let Signature {
        name,
        doc: lines,
        arguments,
        ..
    } = &stage.signature;
    let (doc, allow, name) = (doc(lines), allow_generated(), ident(name));
    let arguments = arguments.iter().map(signature::declared);
    let earlier = stage.earlier.iter().map(|&place| {
        let (name, held) = (ident(&stages[place].keeps), type_of(&stages[place]));
        quote!(#name: &#held<R>)
    });
    let writer = Writer::of_stage(facts, of, stage);
    let fields = stage.kept.iter().map(|kept| {
        let (name, value) = (ident(&kept.name), writer.expression(&kept.value));
        let value: FieldValue = parse_quote!(#name: #value);
        shortened(value)
    });
    let kept = (!stage.kept.is_empty()).then(|| type_of(stage));
    let returned = kept.as_ref().map(|kept| quote!(-> #kept<R>));
    let result = kept.as_ref().map(|kept| quote!(#kept { #(#fields),* }));
    let mut item: syn::ItemFn = parse_quote! {
        #doc
        #allow
        #[inline(never)]
        fn #name<R: kane::Real>(#(#arguments,)* #(#earlier),*) #returned {
            #result
        }
    };
    item.block.stmts.splice(..0, statements::of(&writer));
    Item::Fn(item)
}

/// `x` for `x: x`.
fn shortened(mut field: FieldValue) -> FieldValue {
    let is_own = matches!((&field.member, &field.expr), (Member::Named(name), Expr::Path(value)) if value.path.is_ident(name));
    if is_own {
        field.colon_token = None;
    }
    field
}

/// The calls of a function's stages, in order.
pub(super) fn calls(function: &Function) -> Vec<Stmt> {
    let stages = &function.stages;
    // Its own arrays stand behind the arguments.
    let n_arguments = function.signature.arguments.len();
    let calls = stages.iter().map(|stage| {
        let name = ident(&stage.signature.name);
        let own = stage.signature.arguments.iter().zip(&stage.given);
        let own = own.map(|(argument, &place)| {
            let name = ident(&argument.name);
            if place < n_arguments {
                quote!(#name)
            } else {
                quote!(&mut #name)
            }
        });
        let earlier = stage.earlier.iter();
        let earlier = earlier.map(|&place| ident(&stages[place].keeps));
        let call: TokenStream = quote!(self::#name(#(#own,)* #(&#earlier),*));
        if stage.kept.is_empty() {
            return parse_quote!(#call;);
        }
        let keeps = ident(&stage.keeps);
        parse_quote!(let #keeps = #call;)
    });
    calls.collect()
}
